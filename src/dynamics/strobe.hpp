// The stroboscopic map: a motion at times a period apart.
#pragma once

#include <vector>

#include "motion/run.hpp"

namespace rotor {

/// t0, t0 + T, ... in the order of the motion. Throws std::invalid_argument unless T is positive
/// and no longer than the run, and where there would be more than 1e8.
std::vector<double> strobe_times(const Run& run, double period);

}  // namespace rotor
