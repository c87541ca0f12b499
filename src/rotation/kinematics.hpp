// How axis, angle and Euler vector move with an angular velocity, and the other way round.
//
// omega is in the space frame, in radians per unit of time, unless said otherwise. A component of a
// result is infinite where it exceeds the largest double.
#pragma once

#include "rotation/extended.hpp"
#include "rotation/rotation.hpp"

namespace rotor {

/// The angular velocity at which axis u and angle theta of r move at the given rates [N15]:
/// omega = theta' u + (1 - cos theta) u x u' + sin theta u'. The axis is a unit vector, so u' is
/// perpendicular to it: to 1e-6 of |u'|, then the part along u is taken off. Throws
/// std::invalid_argument otherwise, with that part, and for rates that are not finite.
Vector angular_velocity(const Rotation& r, double angle_rate, const Vector& axis_rate);

/// The rate of a unit axis n [P5]: (omega - n (omega . n)) cot(theta/2)/2 + omega x n/2; exactly 0
/// for a multiple of n. The caller gives cot(theta/2).
Vector axis_rate(const Vector& n, Extended cot_half_angle, const Vector& omega);

/// How axis and angle move. `jump`: the axis is not that of the rotation, but jumps to `axis`.
struct RotationRates {
  double angle_rate;
  Vector axis;
  Vector axis_rate;
  bool jump;
};

/// The inverse of N15 [P5]: theta' = omega . u and u' = axis_rate. At a full turn, theta = 2 pi n,
/// where the operator is the identity whatever the axis, omega along the axis (to the rounding of a
/// unit vector) keeps it. Any other omega makes the axis jump, and the choice is the one of the
/// notes: to omega/|omega|, so that the angle grows at |omega|; the axis rate is the 0 that a
/// constant omega gives. A full turn is an angle 2 pi n to within 2^-51 of itself (2 to 4 ulp), and
/// 2e-6 rad at most; near 0 it is 0 alone. Throws std::invalid_argument for an omega that is not
/// finite.
RotationRates rotation_rates(const Rotation& r, const Vector& omega);

/// The left Jacobian of the exponential map: omega = J_l(E) E' for the Euler vector E,
/// J_l = 1 + (1 - cos theta)/theta^2 [E]x + (theta - sin theta)/theta^3 [E]x^2, theta = |E|.
/// This and the following throw std::invalid_argument for a v that is not finite.
Matrix left_jacobian(const Vector& v);
/// The right Jacobian J_r(E) = J_l(-E): the angular velocity in the body frame is J_r(E) E'.
Matrix right_jacobian(const Vector& v);
/// E' = J_l(E)^-1 omega [P7]: J_l^-1 = 1 - [E]x/2 + (1 - g)/theta^2 [E]x^2,
/// g = (theta/2) cot(theta/2). Singular at a full turn but 0 (as of rotation_rates), and unknown
/// for |v| > 1e16: throws std::invalid_argument. Entries are rounded once, but near a full turn and
/// for a long v the length of v, known to 1e-19 of itself, adds 1e-19 theta^2/(4 sin^2(theta/2)).
Matrix left_jacobian_inverse(const Vector& v);
/// J_r(E)^-1 = J_l(-E)^-1, with the same singularity.
Matrix right_jacobian_inverse(const Vector& v);

/// The left Jacobian and its inverse in extended precision. Where it has none, the inverse is not
/// finite, or huge.
ExtendedMatrix exp_jacobian(const ExtendedVector& v);
ExtendedMatrix exp_jacobian_inverse(const ExtendedVector& v);

}  // namespace rotor
