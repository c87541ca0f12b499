// The equations of motion, y' = F(omega(t), y), with what an integrator must know of each.
//
// omega stands for the generator of the flow (flow.hpp), so that the unit quaternion q of y obeys
// q' = omega q / 2. Errors are rotation vectors e of the body frame, q + dq = q (1 + e/2): seen
// from there they stay as they are while the motion goes on, and may be added up along a run.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <string>

#include "rotation/rotation.hpp"

namespace rotor {

/// What an equation is, and the answers of one that is singular nowhere. Each has besides
///   Value start(const Rotation& r)     the y of a start; throws std::invalid_argument if none
///   Value rate(omega, y)               y'
///   Vector body_error(y, dy)           the rotation vector that dy is; exact for a rate too where
///                                      y has left the rotations a little (|q| = 1, say)
///   Value turning(y, v)                its inverse: the dy of a small rotation vector v
///   Quaternion quaternion(y)           the unit quaternion, of either sign
template <class V>
struct RegularEquation {
  using Value = V;

  /// What must be added to y to bring it back to the rotations.
  Value restoring(const Value&) const { return Value::Zero(); }
  /// How far, in rad, y is from where the equation is singular.
  double distance(const Value&) const { return std::numeric_limits<double>::infinity(); }
  /// How far a step from y0 to y1 goes, in units of what a singularity allows: by more than 1 it
  /// goes through, or so near by that it cannot be told. `turn` is the integral of omega over it.
  double reach(const Value& /*y0*/, const Vector& /*turn*/, const Value& /*y1*/) const { return 0; }
  /// The singularity next to y, for people: "equation = ... is singular at ...; ways out".
  std::string singularity(const Value&) const { return {}; }
  /// The angle, in rad, by which y turns where it grows by its own length: u times that is what a
  /// rounding of y does.
  double stretch(const Value&) const { return 0; }
  /// Whether the run is to go on from another y of the same operator, and that y.
  bool is_due(const Value&) const { return false; }
  Value restarted(const Value& y) const { return y; }
};

/// [P9] with its scalar part: Q' = omega Q / 2, linear, never singular. [P8] with the cosine that
/// it needs carried along, M' = omega M0 / 2 + omega x M / 2, is the same equation.
struct QuaternionEquation : RegularEquation<Eigen::Vector4d> {
  // Value: (x, y, z, w), the order of Eigen's coeffs(), inside only.

  /// 1, whatever the start: linear, U(t) serves every one.
  static Value start(const Rotation&) { return {0, 0, 0, 1}; }

  static Value rate(const Vector& omega, const Value& q) {
    Value dq;
    dq.head<3>() = 0.5 * (q.w() * omega + omega.cross(q.head<3>()));
    dq.w() = -0.5 * omega.dot(q.head<3>());
    return dq;
  }

  /// 2 vec(q^-1 dq).
  static Vector body_error(const Value& q, const Value& dq) {
    const Vector half =
        q.w() * dq.head<3>() - dq.w() * q.head<3>() - q.head<3>().cross(dq.head<3>());
    return 2 / q.squaredNorm() * half;
  }

  /// q v / 2.
  static Value turning(const Value& q, const Vector& v) {
    Value dq;
    dq.head<3>() = 0.5 * (q.w() * v + q.head<3>().cross(v));
    dq.w() = -0.5 * q.head<3>().dot(v);
    return dq;
  }

  static Value restoring(const Value& q) { return q * (1 / q.norm() - 1); }
  static Quaternion quaternion(const Value& q) { return Quaternion(Value(q.normalized())); }
};

}  // namespace rotor
