// The times at which a run is asked.
#pragma once

#include <cstddef>
#include <vector>

namespace rotor {

/// n times from t0 to t1, both included (n = 1: t0 alone). Throws std::invalid_argument for n = 0
/// and n > 1e8.
std::vector<double> times_in(double t0, double t1, std::size_t n);

/// t0, t0 + every, ... up to t1 (backward where t1 < t0). Throws std::invalid_argument unless every
/// is positive and there are at most 1e8 of them.
std::vector<double> times_every(double t0, double t1, double every);

}  // namespace rotor
