// Pictures of points in plain ASCII.
#pragma once

#include <span>
#include <string>

#include "output/canvas.hpp"

namespace rotor {

/// The points (x, y), one unit as long across as up (a cell is taken for twice as high as wide), on
/// at most `width` columns and `height` rows: "*" where no cell holds two, else the marks
/// . : - = + * # % @ for 1, 2, ... points, up to the most in a cell, in equal ratios. Points with a
/// coordinate that is not finite are left out. Throws std::invalid_argument where none is left,
/// where there are not as many x as y, and where the size leaves no room.
std::string scatter(std::span<const double> x, std::span<const double> y,
                    const PlotOptions& options = {});

}  // namespace rotor
