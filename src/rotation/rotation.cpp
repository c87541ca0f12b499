#include "rotation/rotation.hpp"

#include <Eigen/SVD>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include "rotation/extended.hpp"
#include "rotation/operators.hpp"
#include "rotation/quaternion.hpp"
#include "rotation/text.hpp"

namespace rotor {
namespace {

[[noreturn]] void throw_not_finite(const char* what, const std::string& given) {
  throw std::invalid_argument(std::string(what) + ": expected finite numbers, got " + given);
}

static_assert(std::numeric_limits<Extended>::max_exponent >= 16384 &&
                  std::numeric_limits<Extended>::digits >= 64,
              "rotor needs a long double wider than double");

// How far from unit a quaternion may be and still be taken for one.
constexpr double kUnitTolerance = 1e-6;

// The rotation of angle `angle_of(|v|)` about v, the identity for v = 0.
template <class AngleOf>
Rotation along(const Vector& v, const char* what, AngleOf angle_of) {
  require_finite(v, what);
  if (v.isZero(0)) return {};
  const auto angle = static_cast<double>(angle_of(v.cast<Extended>().norm()));
  if (!std::isfinite(angle)) {
    throw std::invalid_argument(std::string(what) + ": the length of " + text(v) +
                                " exceeds the largest double");
  }
  return {v, angle};
}

double leading(const Vector& n) { return n.z() != 0 ? n.z() : n.y() != 0 ? n.y() : n.x(); }

// For e = a rotation matrix + noise: N = 4 q q^T + noise, whose column of largest diagonal is an
// approximate multiple of q. Three more products with N (the power method: the other eigenvalues
// are of the size of the noise, 1e-6 at most) make it the nearest rotation's q to 1e-24, and
// average the rounding.
Rotation rotation_of_proper(const ExtendedMatrix& e) {
  Eigen::Matrix<Extended, 4, 4> n;  // in the order w x y z
  n(0, 0) = 1 + e.trace();
  n(1, 1) = 1 + e(0, 0) - e(1, 1) - e(2, 2);
  n(2, 2) = 1 - e(0, 0) + e(1, 1) - e(2, 2);
  n(3, 3) = 1 - e(0, 0) - e(1, 1) + e(2, 2);
  n(0, 1) = n(1, 0) = e(2, 1) - e(1, 2);
  n(0, 2) = n(2, 0) = e(0, 2) - e(2, 0);
  n(0, 3) = n(3, 0) = e(1, 0) - e(0, 1);
  n(1, 2) = n(2, 1) = e(0, 1) + e(1, 0);
  n(2, 3) = n(3, 2) = e(1, 2) + e(2, 1);
  n(1, 3) = n(3, 1) = e(2, 0) + e(0, 2);
  Eigen::Index largest = 0;
  n.diagonal().maxCoeff(&largest);
  const Eigen::Matrix<Extended, 4, 1> q = n * (n * (n * n.col(largest)));
  return canonical_of(ExtendedQuaternion(q(0), q(1), q(2), q(3)));
}

}  // namespace

ExtendedQuaternion half_angle_quaternion(const Rotation& r) {
  const Extended half = Extended{r.angle()} / 2;
  const ExtendedVector v = r.axis().cast<Extended>() * std::sin(half);
  return {std::cos(half), v.x(), v.y(), v.z()};
}

Rotation canonical_of(ExtendedQuaternion q) {
  if (q.w() < 0) q.coeffs() *= -1;
  const Rotation r = rotation_of(q);
  constexpr double kPi = std::numbers::pi;
  if (r.angle() < std::nextafter(kPi, 0.0)) return r;
  const Vector& n = r.axis();
  return {leading(n) < 0 ? Vector(-n) : n, kPi};
}

void require_finite(double value, const char* what) {
  if (!std::isfinite(value)) throw_not_finite(what, text(value));
}
void require_finite(const Vector& value, const char* what) {
  if (!value.allFinite()) throw_not_finite(what, text(value));
}
void require_finite(const Quaternion& value, const char* what) {
  if (!value.coeffs().allFinite()) throw_not_finite(what, text(value));
}
void require_finite(const Matrix& value, const char* what) {
  if (!value.allFinite()) throw_not_finite(what, text(value));
}

Vector unit(const Vector& v, const char* what) {
  require_finite(v, what);
  if (v.isZero(0)) {
    throw std::invalid_argument(std::string(what) + ": the zero vector has no direction");
  }
  const ExtendedVector w = v.cast<Extended>();
  const Extended length = w.norm();
  // What rounding to double makes of a unit vector is one: unit(unit(v)) is unit(v).
  if (std::abs(length - 1) <= 0x1.1p-53L) return v;
  return (w / length).cast<double>();
}

double norm(const Vector& v) { return static_cast<double>(v.cast<Extended>().norm()); }

Rotation::Rotation(const Vector& axis, double angle) : axis_(unit(axis, "axis")), angle_(angle) {
  require_finite(angle, "angle");
}

template <class Scalar>
Rotation rotation_of(const Eigen::Quaternion<Scalar>& q) {
  const ExtendedVector v = q.vec().template cast<Extended>();
  const Extended length = v.norm();
  const auto angle = static_cast<double>(2 * std::atan2(length, Extended{q.w()}));
  if (length == 0) return {Vector::UnitX(), angle, Rotation::Normalised{}};
  return {(v / length).template cast<double>(), angle, Rotation::Normalised{}};
}
template Rotation rotation_of(const Eigen::Quaternion<double>&);
template Rotation rotation_of(const Eigen::Quaternion<Extended>&);

Quaternion Rotation::quaternion() const { return half_angle_quaternion(*this).cast<double>(); }

Matrix Rotation::matrix() const {
  // N5 with 1 - cos theta = 2 sin^2(theta/2).
  const ExtendedVector n = axis_.cast<Extended>();
  const Extended theta = angle_;
  const Extended half_sine = std::sin(theta / 2);
  const ExtendedVector s = n * std::sin(theta);
  ExtendedMatrix m = 2 * half_sine * half_sine * n * n.transpose();
  m.diagonal().array() += std::cos(theta);
  m(1, 0) += s.z();
  m(0, 1) -= s.z();
  m(2, 1) += s.x();
  m(1, 2) -= s.x();
  m(0, 2) += s.y();
  m(2, 0) -= s.y();
  return m.cast<double>();
}

Vector Rotation::euler_vector() const { return axis_ * angle_; }

Vector Rotation::modified_gibbs() const {
  return half_angle_quaternion(*this).vec().cast<double>();
}

Vector Rotation::gibbs() const {
  return (axis_.cast<Extended>() * std::tan(Extended{angle_} / 2)).cast<double>();
}

Vector Rotation::mrp() const {
  return (axis_.cast<Extended>() * std::tan(Extended{angle_} / 4)).cast<double>();
}

Vector Rotation::shadow_mrp() const {
  // The largest number instead of infinity, which times a zero of the axis would be NaN.
  const Extended cot = angle_ == 0 ? std::copysign(std::numeric_limits<Extended>::max(), angle_)
                                   : 1 / std::tan(Extended{angle_} / 4);
  return (axis_.cast<Extended>() * -cot).cast<double>();
}

Rotation operator*(const Rotation& second, const Rotation& first) {
  return rotation_of(half_angle_quaternion(second) * half_angle_quaternion(first));
}

Vector Rotation::operator*(const Vector& r) const {
  require_finite(r, "vector");
  const ExtendedVector n = axis_.cast<Extended>();
  const ExtendedVector x = r.cast<Extended>();
  const Extended theta = angle_;
  const Extended half_sine = std::sin(theta / 2);
  return (x * std::cos(theta) + n * (n.dot(x) * 2 * half_sine * half_sine) +
          n.cross(x) * std::sin(theta))
      .cast<double>();
}

Rotation Rotation::inverse() const { return {axis_, -angle_, Normalised{}}; }

Rotation Rotation::power(double x) const {
  const double angle = angle_ * x;
  if (!std::isfinite(angle)) {
    throw std::invalid_argument("the angle " + text(angle_) + " times " + text(x) +
                                " is not finite");
  }
  return {axis_, angle, Normalised{}};
}

Rotation Rotation::canonical() const {
  const bool is_canonical = (0 < angle_ && angle_ < std::nextafter(std::numbers::pi, 0.0)) ||
                            (angle_ == std::numbers::pi && leading(axis_) > 0);
  return is_canonical ? *this : canonical_of(half_angle_quaternion(*this));
}

Rotation from_quaternion(const Quaternion& q) {
  require_finite(q, "from_quaternion");
  const double size = norm(q);
  if (std::abs(size - 1) > kUnitTolerance) {
    throw std::invalid_argument(
        "from_quaternion: expected a unit quaternion (norm 1 within 1e-06), got " + text(q) +
        " of norm " + text(size) + "; :unit() normalises one");
  }
  return rotation_of(q);
}

Rotation from_matrix(const Matrix& m) {
  require_proper_orthogonal(m, "from_matrix");
  return rotation_of_proper(m.cast<Extended>());
}

Rotation from_euler_vector(const Vector& v) {
  return along(v, "from_euler_vector", [](Extended length) { return length; });
}

Rotation from_modified_gibbs(const Vector& m) {
  return along(m, "from_modified_gibbs", [&](Extended length) {
    if (length > 1 + 1e-15L) {
      throw std::invalid_argument("from_modified_gibbs: expected a length of at most 1, got " +
                                  text(m) + " of length " + text(static_cast<double>(length)));
    }
    return 2 * std::asin(std::min(length, Extended{1}));
  });
}

Rotation from_gibbs(const Vector& g) {
  return along(g, "from_gibbs", [](Extended length) { return 2 * std::atan(length); });
}

Rotation from_mrp(const Vector& p) {
  return along(p, "from_mrp", [](Extended length) { return 4 * std::atan(length); });
}

Rotation nearest_rotation(const Matrix& m) {
  require_finite(m, "nearest");
  // With m = U S V^T the nearest rotation is U diag(1, 1, d) V^T, d = det(U V^T). It is unique iff
  // s2 + d s3 > 0 (zero: any turn in the plane of the last two singular vectors is as near).
  const Eigen::JacobiSVD<ExtendedMatrix> svd(m.cast<Extended>(),
                                             Eigen::ComputeFullU | Eigen::ComputeFullV);
  const ExtendedVector& s = svd.singularValues();
  const Extended d = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  // Singular values below what the rounding of the entries can make of a zero count as zero.
  const Extended least = 8 * std::numeric_limits<double>::epsilon() * s(0);
  if (!(s(1) + d * s(2) > least)) {
    const auto rank = (s.array() > least).count();
    throw std::invalid_argument(
        "nearest: many rotations are as near: the matrix " +
        (rank < 2 ? "has rank " + std::to_string(rank) + ", less than 2"
                  : "is a reflection whose two least singular values are equal") +
        " (singular values " + text(Vector(s.cast<double>())) + ")");
  }
  const ExtendedMatrix nearest =
      svd.matrixU() * ExtendedVector(1, 1, d).asDiagonal() * svd.matrixV().transpose();
  return rotation_of_proper(nearest);
}

double distance(const Rotation& r, const Rotation& s) {
  const ExtendedQuaternion q = half_angle_quaternion(r).conjugate() * half_angle_quaternion(s);
  return static_cast<double>(2 * std::atan2(q.vec().norm(), std::abs(q.w())));
}

Rotation slerp(const Rotation& r, const Rotation& s, double fraction, Way way) {
  Rotation step = (s * r.inverse()).canonical();
  if (way == Way::kLong) step = {step.axis(), step.angle() - 2 * std::numbers::pi};
  return step.power(fraction) * r;
}

}  // namespace rotor
