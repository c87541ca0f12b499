// The equations of motion in the charts, y' = F(omega(t), y), with what an integrator must know of
// each.
#pragma once

#include <Eigen/Core>

#include "rotation/rotation.hpp"

namespace rotor {

/// [P9] with its scalar part: Q' = omega Q / 2 (omega in the space frame), linear, never singular.
struct QuaternionEquation {
  /// (x, y, z, w): the order of Eigen's coeffs(), inside only.
  using Value = Eigen::Vector4d;

  static Value rate(const Vector& omega, const Value& q) {
    Value dq;
    dq.head<3>() = 0.5 * (q.w() * omega + omega.cross(q.head<3>()));
    dq.w() = -0.5 * omega.dot(q.head<3>());
    return dq;
  }

  /// The rotation (rad, first order) by which q + dq differs from q: twice the part of dq across q.
  static double rotation_error(const Value& q, const Value& dq) {
    return 2 * (dq - q * q.dot(dq)).norm();
  }

  /// The same with its direction, as a rotation vector in the body frame: 2 vec(q* dq).
  static Vector body_error(const Value& q, const Value& dq) {
    return 2 * (q.w() * dq.head<3>() - dq.w() * q.head<3>() - q.head<3>().cross(dq.head<3>()));
  }

  /// What must be added to q to turn it by the small rotation vector v of the body frame: q v / 2.
  static Value turning(const Value& q, const Vector& v) {
    Value dq;
    dq.head<3>() = 0.5 * (q.w() * v + q.head<3>().cross(v));
    dq.w() = -0.5 * q.head<3>().dot(v);
    return dq;
  }

  /// What must be added to q to bring it back to the unit sphere.
  static Value restoring(const Value& q) { return q * (1 / q.norm() - 1); }
};

}  // namespace rotor
