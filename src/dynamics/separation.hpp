// The certificate that the attitude flow is an isometry: what lies between two motions stays.
#pragma once

#include <span>

#include "motion/run.hpp"

namespace rotor {

/// How far two distances between two motions came from what they were at the first time.
struct SeparationChange {
  double quaternion = 0;  // of |p - q|, the chord of S^3
  double rotation = 0;    // of the distance of the operators, [0, pi], rad
};

/// The greatest changes at the times. Both are the errors of the two runs and no more, whatever
/// omega is, if it is the same: U p and U q, or p U and q U, are as far apart as p and q. Throws
/// std::invalid_argument for fewer than two times, std::out_of_range for a time outside the runs.
SeparationChange greatest_separation_change(const Run& a, const Run& b,
                                            std::span<const double> times,
                                            const Observer& observer = {});

}  // namespace rotor
