// What a rotation is: an axis and any real angle, and the faces under which it is read.
//
// Active, right-handed, angles in radians and counted through full turns. Quaternions are scalar
// first in every interface of rotor; the operators of a rotation by theta and by theta + 2 pi are
// the same, their unit quaternions (cos theta/2, n sin theta/2) are opposite.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace rotor {

using Vector = Eigen::Vector3d;
using Matrix = Eigen::Matrix3d;
using Quaternion = Eigen::Quaterniond;

/// Faces and products are computed in extended precision and rounded once. Its wider exponent also
/// keeps |v| from over- and underflowing for every double v, without scaling.
using Extended = long double;

/// v/|v| for any finite non-zero v (subnormal and 1.7e308 too), each component within 0.51 ulp. A v
/// of length 1 to within 1.0625 * 2^-53, as every result of this is, comes back as it is.
/// Throws std::invalid_argument for a zero or non-finite v; `what` names it in the message.
Vector unit(const Vector& v, const char* what = "vector");

/// |v| for any finite v; infinite only if the true norm exceeds the largest double.
double norm(const Vector& v);

/// An immutable rotation: unit axis n and angle theta, any real number; the angle given is kept.
class Rotation {
 public:
  /// The identity: angle 0, axis e1 (the rule of N3 for an axis that nothing determines).
  Rotation() = default;

  /// Axis of any length but zero. Throws std::invalid_argument on a zero or non-finite axis, or a
  /// non-finite angle.
  Rotation(const Vector& axis, double angle);

  const Vector& axis() const { return axis_; }
  double angle() const { return angle_; }

  /// Unit quaternion (cos theta/2, n sin theta/2); its sign carries the parity of the turns.
  Quaternion quaternion() const;
  /// Proper orthogonal matrix of the operator [N5].
  Matrix matrix() const;
  /// E = n theta (rotation vector). May overflow only where |theta| does.
  Vector euler_vector() const;
  /// M = n sin(theta/2).
  Vector modified_gibbs() const;
  /// G = n tan(theta/2) (Rodrigues vector); finite at every double, 1.6e16 at the double nearest
  /// pi.
  Vector gibbs() const;
  /// n tan(theta/4), modified Rodrigues parameters.
  Vector mrp() const;
  /// Those of the same operator the other way round, n tan((theta - 2 pi)/4) = -n cot(theta/4):
  /// infinite along the axis at theta = 0, where the components across it stay 0.
  Vector shadow_mrp() const;

  /// Composition R2 * R1 (R1 first) by Rodrigues' formula [P11, P12]; the angle is in [0, 2 pi],
  /// the axis of an exact identity is e1.
  friend Rotation operator*(const Rotation& second, const Rotation& first);
  /// Rodrigues' formula [P3, N4]: r cos theta + n (n.r)(1 - cos theta) + (n x r) sin theta.
  Vector operator*(const Vector& r) const;

  /// Same axis, opposite angle.
  Rotation inverse() const;
  /// Same axis, angle times x. Throws std::invalid_argument if that is not finite.
  Rotation power(double x) const;
  /// The operator's own rotation by N3's rule: angle in [0, pi]; at 0 the axis is e1; at pi (an
  /// angle within an ulp of pi is a half turn) the last non-zero axis component is positive.
  Rotation canonical() const;

  /// Same axis and same angle, bit for bit; not: same operator.
  friend bool operator==(const Rotation&, const Rotation&) = default;

 private:
  struct Normalised {};  // the axis is a unit vector already
  Rotation(const Vector& axis, double angle, Normalised) : axis_(axis), angle_(angle) {}
  template <class Scalar>
  friend Rotation rotation_of(const Eigen::Quaternion<Scalar>& q);

  Vector axis_ = Vector::UnitX();
  double angle_ = 0;
};

/// The rotation of a quaternion of any non-zero norm: angle 2 atan2(|v|, w) in [0, 2 pi], axis
/// v/|v| (e1 if v = 0).
template <class Scalar>
Rotation rotation_of(const Eigen::Quaternion<Scalar>& q);
extern template Rotation rotation_of(const Eigen::Quaternion<double>&);
extern template Rotation rotation_of(const Eigen::Quaternion<Extended>&);

/// From the faces. Each throws std::invalid_argument on non-finite components, and outside its
/// domain. Unit quaternion to 1e-6 in the norm, then normalised; angle in [0, 2 pi].
Rotation from_quaternion(const Quaternion& q);
/// Proper orthogonal to 1e-6 (the largest |entry| of m^T m - 1, and det > 0), then the nearest
/// rotation; canonical.
Rotation from_matrix(const Matrix& m);
/// Any vector whose length does not overflow; angle |v|, axis e1 for v = 0.
Rotation from_euler_vector(const Vector& v);
/// |m| <= 1 (to 1e-15); angle in [0, pi]: M does not carry the sign of cos(theta/2).
Rotation from_modified_gibbs(const Vector& m);
/// Any vector; angle in [0, pi].
Rotation from_gibbs(const Vector& g);
/// Any vector; angle in [0, 2 pi].
Rotation from_mrp(const Vector& p);

/// The rotation whose matrix is nearest to m in the Frobenius norm; canonical. There always is one;
/// std::invalid_argument where there are many: of rank below 2, or a reflection (det m < 0) whose
/// two least singular values are equal, to the rounding of the entries.
Rotation nearest_rotation(const Matrix& m);

/// The angle of R^-1 S as an operator, in [0, pi]: the geodesic distance on SO(3).
double distance(const Rotation& r, const Rotation& s);

enum class Way { kShort, kLong };
/// The geodesic of operators from r (s = 0) to s (s = 1), at constant rate, the short way or the
/// long way round. At distance pi both are as short: N3's axis decides.
Rotation slerp(const Rotation& r, const Rotation& s, double fraction, Way way = Way::kShort);

}  // namespace rotor
