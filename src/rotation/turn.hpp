// Unit vectors and unit quaternions in extended precision, for formulas that round once.
#pragma once

#include "rotation/extended.hpp"

namespace rotor {

/// v/|v|. Throws as unit(v, what) does.
inline ExtendedVector direction(const Vector& v, const char* what) {
  unit(v, what);
  return v.cast<Extended>().normalized();
}

/// (cos x/2, u sin x/2) of a unit vector u, x = angle + rest, with a small rest that is below the
/// last digit of the angle. Good to 2^-61 for every finite angle.
ExtendedQuaternion turn(const ExtendedVector& u, Extended angle, Extended rest = 0);

/// As half_angle_quaternion, but unit to extended precision: of an axis that is unit only to
/// double.
inline ExtendedQuaternion turn(const Rotation& r) {
  return turn(r.axis().cast<Extended>().normalized(), r.angle());
}

}  // namespace rotor
