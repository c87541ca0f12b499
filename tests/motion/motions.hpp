// What the tests of this floor share: runs of a function, and what a run's own error allows.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "motion/run.hpp"

namespace rotor::motions {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

inline Scene scene(AngularVelocity omega, double t0, double t1, double accuracy = 1e-10) {
  Scene result{std::move(omega)};
  result.t0 = t0;
  result.t1 = t1;
  result.accuracy = accuracy;
  return result;
}

/// The same constant as a function, for the methods that step.
inline AngularVelocity as_function(const Vector& omega) {
  return AngularVelocity([omega](double) { return omega; });
}

/// The error of the rotation at a state of the run: the estimate (of first order, and taken at
/// nodes: a quarter more) and the rounding of quaternion, axis and angle.
inline double rotation_tolerance(const Run& run, double angle) {
  return 1.25 * run.propagator().error_estimate + 4 * kEpsilon + kEpsilon * std::abs(angle);
}
/// That of the axis: an error across the axis turns it by itself / (2 |sin(theta/2)|).
inline double axis_tolerance(const Run& run, double angle) {
  return rotation_tolerance(run, 0) / std::abs(std::sin(angle / 2));
}

/// n + 1 times from a to b.
inline std::vector<double> times(double a, double b, int n) {
  std::vector<double> result;
  for (int i = 0; i <= n; ++i) result.push_back(i == n ? b : a + (b - a) * i / n);
  return result;
}

}  // namespace rotor::motions
