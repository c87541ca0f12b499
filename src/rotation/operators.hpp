// Operators on E^3 as matrices in the basis (e1, e2, e3) [N sections 2 to 4]: what rotation
// operators are made of, what they are recognised by, and their axis from their eigenvectors.
#pragma once

#include <array>
#include <string>

#include "rotation/rotation.hpp"

namespace rotor {

/// a (x) b, the operator x -> a (b . x).
Matrix outer(const Vector& a, const Vector& b);

/// S_u, the operator x -> u x x [N4].
template <class Scalar>
Eigen::Matrix<Scalar, 3, 3> skew(const Eigen::Matrix<Scalar, 3, 1>& u) {
  Eigen::Matrix<Scalar, 3, 3> m;
  m << 0, -u.z(), u.y(), u.z(), 0, -u.x(), -u.y(), u.x(), 0;
  return m;
}

/// The axial vector of the skew part of m: skew(axial(m)) = (m - m^T)/2.
Vector axial(const Matrix& m);

/// A right-handed orthonormal basis (u, v, w) [N6], u the direction of the vector given; of e1, e2
/// and e3 the next two of them. Which v depends on u with jumps, as it must. Each component within
/// an ulp of 1. Throws std::invalid_argument for a zero or non-finite vector.
std::array<Vector, 3> orthonormal_basis(const Vector& u);

/// How far from proper orthogonal a matrix may be and still be taken for a rotation.
constexpr double kProperTolerance = 1e-6;

/// Whether an operator is proper orthogonal [N section 4], and what was measured, as a sentence.
struct Properness {
  bool proper;
  std::string measured;
};
/// Proper orthogonal: the largest |entry| of m^T m - 1 is at most the tolerance and det m > 0. A
/// matrix that is not finite is not. Throws std::invalid_argument unless the tolerance is finite
/// and 0 or more.
Properness proper_orthogonal(const Matrix& m, double tolerance = kProperTolerance);

/// Throws std::invalid_argument, "what: expected a proper orthogonal matrix ...", unless m is one
/// to kProperTolerance.
void require_proper_orthogonal(const Matrix& m, const char* what);

/// The canonical rotation by eigenvalues and eigenvectors [N14, eigMtoR]: the angle is the argument
/// of the eigenvalue with positive imaginary part, the axis the real eigenvector, oriented by the
/// complex one. Throws as from_matrix, which is the better way: an eigenvector is only as good as
/// its eigenvalue is apart from the others, so that the axis is off by about 1e-16/angle + 1e-16
/// near the identity, and an angle below 1e-18 is taken for 0.
Rotation from_eigenvectors(const Matrix& m);

}  // namespace rotor
