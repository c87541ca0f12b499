// Pictures of time series in plain ASCII.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

namespace rotor {

struct Series {
  std::string name;
  std::vector<double> y;  // one value for each x; nan and infinities are gaps
  // Neighbours further apart are not joined.
  double jump = std::numeric_limits<double>::infinity();
};

struct PlotOptions {
  int width = 80;   // columns of the whole picture, at most
  int height = 20;  // rows between title and axis, at most
  std::string title = {};
  std::string x_label = {};
  std::string y_label = {};  // if empty, the name of the only series
  bool log_x = false;        // logarithmic axes, over whole decades
  bool log_y = false;
};

/// The curves through the points (x, y), straight between neighbours, over round ticks. Each y tick
/// is the exact middle of its row; an x tick is within half a column. x increases to the right. One
/// series is drawn with . - ' for the thirds of a cell and | for steep parts, * for a point between
/// gaps. Several have a mark each, named in the legend; in a cell that they share they take turns,
/// column by column. On a logarithmic axis ticks are powers of ten; y that are not positive are
/// gaps there, and x must be positive. Throws std::invalid_argument if there is nothing to draw, x
/// is not finite or not monotone, sizes differ, there are more series than marks, or the size
/// leaves no room.
std::string plot(std::span<const double> x, std::span<const Series> series,
                 const PlotOptions& options = {});

}  // namespace rotor
