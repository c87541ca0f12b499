// Unit vectors and unit quaternions in extended precision, for formulas that round once.
#pragma once

#include <Eigen/Geometry>

#include "rotation/extended.hpp"

namespace rotor {

/// v/|v|. Throws as unit(v, what) does.
inline ExtendedVector direction(const Vector& v, const char* what) {
  unit(v, what);
  return v.cast<Extended>().normalized();
}

/// (cos angle/2, u sin angle/2) of a unit vector u.
inline ExtendedQuaternion turn(const ExtendedVector& u, Extended angle) {
  return ExtendedQuaternion(Eigen::AngleAxis<Extended>(angle, u));
}

/// As half_angle_quaternion, but unit to extended precision: of an axis that is unit only to
/// double.
inline ExtendedQuaternion turn(const Rotation& r) {
  return turn(r.axis().cast<Extended>().normalized(), r.angle());
}

}  // namespace rotor
