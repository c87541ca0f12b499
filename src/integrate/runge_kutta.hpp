// The Runge-Kutta methods, each for every equation of motion.
#pragma once

#include <vector>

#include "integrate/propagator.hpp"

namespace rotor {

/// Follow the scene by RK4 with its fixed `step`, or by DOP853 to its `accuracy`, in its equation,
/// and fill in result.flow, .t1, .stop, .error_estimate, .accuracy and .cost. `breaks` rise: those
/// of the scene and of omega, strictly between t0 and t1. `from` is the start: of the equations,
/// all but those of the quaternion and of the body points need it, for they are singular somewhere.
///
/// Throw std::invalid_argument where the equation cannot start from there, or the scene asks for
/// what the equation does not have; a singularity met on the way is result.stop, with reason
/// "singularity".
void follow_by_rk4(const Scene& scene, const std::vector<double>& breaks, const Rotation& from,
                   const Observer& observer, Propagator& result);
void follow_by_dop853(const Scene& scene, const std::vector<double>& breaks, const Rotation& from,
                      const Observer& observer, Propagator& result);

}  // namespace rotor
