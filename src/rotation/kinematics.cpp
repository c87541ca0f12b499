#include "rotation/kinematics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "rotation/operators.hpp"
#include "rotation/small_angle.hpp"
#include "rotation/text.hpp"

namespace rotor {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
// Beyond it doubles are 2 rad apart.
constexpr Extended kLongest = 1e16L;
// Of the rate of an axis, how much may be along the axis.
constexpr double kPerpendicular = 1e-6;

// |sin(theta/2)| is half the distance from 2 pi n. An angle made as 2 pi times n is off by 1.4
// half-ulps at most; a length |v| with v = angle * unit axis by three more (the axis 1.02, the
// product 1): less than 2^-51 in all.
bool is_full_turn(Extended theta) {
  return std::abs(std::sin(theta / 2)) <= std::min<Extended>(kEpsilon * std::abs(theta), 1e-6L);
}

Matrix inverse_jacobian(const Vector& v, double sign, const char* what) {
  require_finite(v, what);
  const ExtendedVector e = sign * v.cast<Extended>();
  const Extended theta = e.norm();
  if (theta > kLongest) {
    throw std::invalid_argument(std::string(what) + ": expected a length of at most 1e+16, got " +
                                text(v) + ": how near it is to a multiple of 2 pi is not known");
  }
  if (theta != 0 && is_full_turn(theta)) {
    throw std::invalid_argument(std::string(what) +
                                ": singular where the length is a multiple of 2 pi, got " +
                                text(v) + " of length " + text(static_cast<double>(theta)));
  }
  return exp_jacobian_inverse(e).cast<double>();
}

Matrix jacobian(const Vector& v, double sign, const char* what) {
  require_finite(v, what);
  return exp_jacobian(sign * v.cast<Extended>()).cast<double>();
}

}  // namespace

Vector angular_velocity(const Rotation& r, double angle_rate, const Vector& axis_rate) {
  require_finite(angle_rate, "angular_velocity: angle_rate");
  require_finite(axis_rate, "angular_velocity: axis_rate");
  const ExtendedVector u = r.axis().cast<Extended>();
  ExtendedVector rate = axis_rate.cast<Extended>();
  const Extended along = u.dot(rate) / u.squaredNorm();
  if (std::abs(along) > kPerpendicular * rate.norm()) {
    throw std::invalid_argument(
        "angular_velocity: axis_rate: expected a vector perpendicular to the axis " +
        text(r.axis()) + ", for a unit axis only turns, got " + text(axis_rate) + " with " +
        text(static_cast<double>(along), 3) + " along it");
  }
  rate -= along * u;
  const Extended theta = r.angle();
  const Extended half_sine = std::sin(theta / 2);
  return (angle_rate * u + 2 * half_sine * half_sine * u.cross(rate) + std::sin(theta) * rate)
      .cast<double>();
}

Vector axis_rate(const Vector& n, Extended cot_half_angle, const Vector& omega) {
  const ExtendedVector u = n.cast<Extended>();
  const ExtendedVector across = omega.cast<Extended>().cross(u);
  return ((u.cross(across) * cot_half_angle + across) / 2).cast<double>();
}

RotationRates rotation_rates(const Rotation& r, const Vector& omega) {
  require_finite(omega, "rotation_rates: omega");
  const Vector& n = r.axis();
  const ExtendedVector u = n.cast<Extended>();
  const ExtendedVector w = omega.cast<Extended>();
  const auto along = static_cast<double>(w.dot(u));
  const Extended half = Extended{r.angle()} / 2;
  if (!is_full_turn(r.angle())) {
    return {along, n, axis_rate(n, std::cos(half) / std::sin(half), omega), false};
  }
  // Both directions are rounded, each by 1.02 half-ulps at most.
  if (w.cross(u).norm() <= 2 * kEpsilon * w.norm()) return {along, n, Vector::Zero(), false};
  return {norm(omega), unit(omega), Vector::Zero(), true};
}

Matrix left_jacobian(const Vector& v) { return jacobian(v, 1, "left_jacobian"); }
Matrix right_jacobian(const Vector& v) { return jacobian(v, -1, "right_jacobian"); }
Matrix left_jacobian_inverse(const Vector& v) {
  return inverse_jacobian(v, 1, "left_jacobian_inverse");
}
Matrix right_jacobian_inverse(const Vector& v) {
  return inverse_jacobian(v, -1, "right_jacobian_inverse");
}

ExtendedMatrix exp_jacobian(const ExtendedVector& v) {
  const Extended theta = v.norm();
  const ExtendedMatrix k = skew(v);
  return ExtendedMatrix::Identity() + one_minus_cos(theta) * k + angle_minus_sin(theta) * k * k;
}

ExtendedMatrix exp_jacobian_inverse(const ExtendedVector& v) {
  const ExtendedMatrix k = skew(v);
  return ExtendedMatrix::Identity() - k / 2 + one_minus_half_cot(v.norm()) * k * k;
}

}  // namespace rotor
