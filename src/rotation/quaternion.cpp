#include "rotation/quaternion.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "rotation/extended.hpp"
#include "rotation/text.hpp"

namespace rotor {
namespace {

ExtendedQuaternion extended(const Quaternion& q, const char* what) {
  require_finite(q, what);
  return q.cast<Extended>();
}

ExtendedQuaternion non_zero(const Quaternion& q, const char* what) {
  if (q.coeffs().isZero(0)) {
    throw std::invalid_argument(std::string(what) +
                                ": expected a quaternion other than zero, got " + text(q));
  }
  return extended(q, what);
}

Quaternion rounded(const ExtendedQuaternion& q, const std::string& what) {
  const Quaternion result = q.cast<double>();
  if (!result.coeffs().allFinite()) {
    throw std::invalid_argument(what + " exceeds the largest double");
  }
  return result;
}

ExtendedQuaternion inverse_of(const ExtendedQuaternion& q) {
  return ExtendedQuaternion((q.conjugate().coeffs() / q.squaredNorm()).eval());
}

ExtendedQuaternion exp_of(const ExtendedQuaternion& q) {
  const Extended length = q.vec().norm();
  const Extended size = std::exp(q.w());
  const ExtendedVector v = q.vec() * (length == 0 ? size : size * (std::sin(length) / length));
  return {size * std::cos(length), v.x(), v.y(), v.z()};
}

ExtendedQuaternion log_of(const ExtendedQuaternion& q) {
  // Near |q| = 1 by |q|^2 - 1 = (|w| - 1)(|w| + 1) + |v|^2, whose terms have no rounding to speak
  // of.
  const Extended length = q.vec().norm();
  const Extended w = std::abs(q.w());
  const Extended excess = (w - 1) * (w + 1) + length * length;
  const Extended size = std::abs(excess) < 0.5L ? std::log1p(excess) / 2 : std::log(q.norm());
  const Extended half_angle = std::atan2(length, q.w());
  const ExtendedVector axis =
      length == 0 ? ExtendedVector(ExtendedVector::UnitX()) : ExtendedVector(q.vec() / length);
  const ExtendedVector v = axis * half_angle;
  return {size, v.x(), v.y(), v.z()};
}

// q^n for a whole n >= 0, by squaring.
ExtendedQuaternion whole_power(ExtendedQuaternion q, Extended n) {
  ExtendedQuaternion result = ExtendedQuaternion::Identity();
  for (;;) {
    if (std::fmod(n, Extended{2}) == 1) result = result * q;
    n = std::floor(n / 2);
    if (n == 0) return result;
    q = q * q;
  }
}

}  // namespace

double norm(const Quaternion& q) { return static_cast<double>(q.cast<Extended>().norm()); }

Quaternion unit(const Quaternion& q) {
  const ExtendedQuaternion wide = non_zero(q, "unit");
  return Quaternion((wide.coeffs() / wide.norm()).cast<double>().eval());
}

Quaternion product(const Quaternion& p, const Quaternion& q) {
  return (p.cast<Extended>() * q.cast<Extended>()).cast<double>();
}

Quaternion inverse(const Quaternion& q) {
  return rounded(inverse_of(non_zero(q, "inverse")), "inverse: that of " + text(q));
}

Polar polar(const Quaternion& q) {
  non_zero(q, "polar");
  return {norm(q), rotation_of(q)};
}

Quaternion from_polar(double norm, const Rotation& rotation) {
  if (!(norm >= 0 && std::isfinite(norm))) {
    throw std::invalid_argument("from_polar: expected a finite norm, 0 or more, got " + text(norm));
  }
  return ExtendedQuaternion((half_angle_quaternion(rotation).coeffs() * Extended{norm}).eval())
      .cast<double>();
}

Quaternion exp(const Quaternion& q) {
  return rounded(exp_of(extended(q, "exp")), "exp: that of " + text(q));
}

Quaternion log(const Quaternion& q) { return log_of(non_zero(q, "log")).cast<double>(); }

Quaternion power(const Quaternion& q, double x) {
  require_finite(x, "exponent");
  const ExtendedQuaternion wide = extended(q, "quaternion");
  const bool is_zero = q.coeffs().isZero(0);
  if (is_zero && x < 0) throw std::invalid_argument("zero has no power " + text(x));
  const std::string what = "the power " + text(x) + " of " + text(q);
  if (x == std::floor(x)) {
    return rounded(whole_power(x < 0 ? inverse_of(wide) : wide, std::abs(x)), what);
  }
  if (is_zero) return q;
  const ExtendedQuaternion exponent((log_of(wide).coeffs() * Extended{x}).eval());
  return rounded(exp_of(exponent), what);
}

std::vector<Quaternion> continuous_quaternions(std::vector<Quaternion> quaternions) {
  for (std::size_t i = 0; i < quaternions.size(); ++i) {
    const ExtendedQuaternion q = extended(quaternions[i], "continuous_quaternions");
    if (i > 0 && q.dot(quaternions[i - 1].cast<Extended>()) < 0) quaternions[i].coeffs() *= -1;
  }
  return quaternions;
}

}  // namespace rotor
