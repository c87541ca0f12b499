// What the formulas of this floor are computed in: extended precision, rounded once at the end.
#pragma once

#include "rotation/rotation.hpp"

namespace rotor {

using ExtendedVector = Eigen::Matrix<Extended, 3, 1>;
using ExtendedMatrix = Eigen::Matrix<Extended, 3, 3>;
using ExtendedQuaternion = Eigen::Quaternion<Extended>;

/// (cos theta/2, n sin theta/2).
ExtendedQuaternion half_angle_quaternion(const Rotation& r);

/// N3's rule for the operator of a quaternion of any non-zero norm: the canonical rotation.
Rotation canonical_of(ExtendedQuaternion q);

/// Throws std::invalid_argument, "what: expected finite numbers, got value", unless finite.
void require_finite(double value, const char* what);
void require_finite(const Vector& value, const char* what);
void require_finite(const Quaternion& value, const char* what);
void require_finite(const Matrix& value, const char* what);

}  // namespace rotor
