// A motion as a moving picture.
#pragma once

#include <filesystem>
#include <span>

#include "motion/run.hpp"

namespace rotor {

/// Draws FILE, a .gif, by gnuplot as `draw` of picture.hpp does (with its answer and its errors): a
/// frame for each time, on the unit sphere, with the axis n, omega over its greatest length at
/// these times, and a point of the body, unit, by its direction at the start; and the ways of n and
/// of the point so far. Calls omega. Throws std::invalid_argument where there are no times.
bool animate(const Run& run, std::span<const double> times, const Vector& point,
             const std::filesystem::path& file, const Observer& observer = {});

}  // namespace rotor
