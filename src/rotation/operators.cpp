#include "rotation/operators.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "rotation/extended.hpp"
#include "rotation/spaces.hpp"
#include "rotation/text.hpp"

namespace rotor {

Matrix outer(const Vector& a, const Vector& b) { return a * b.transpose(); }

Vector axial(const Matrix& m) {
  const ExtendedMatrix e = m.cast<Extended>();
  const ExtendedVector twice(e(2, 1) - e(1, 2), e(0, 2) - e(2, 0), e(1, 0) - e(0, 1));
  return (twice / 2).cast<double>();
}

std::array<Vector, 3> orthonormal_basis(const Vector& u) {
  const Vector first = unit(u);
  const ExtendedVector wide = u.cast<Extended>().normalized();
  Eigen::Index largest = 0;
  wide.cwiseAbs().maxCoeff(&largest);
  // The component of u along any other basis vector is at most 1/sqrt(2).
  const ExtendedVector w = wide.cross(ExtendedVector::Unit((largest + 1) % 3)).normalized();
  return {first, w.cross(wide).cast<double>(), w.cast<double>()};
}

Properness proper_orthogonal(const Matrix& m, double tolerance) {
  if (!(tolerance >= 0 && std::isfinite(tolerance))) {
    throw std::invalid_argument("the tolerance must be finite, 0 or more, got " + text(tolerance));
  }
  if (!m.allFinite()) return {false, "not all entries are finite: " + text(m)};
  const ExtendedMatrix e = m.cast<Extended>();
  const auto defect =
      static_cast<double>((e.transpose() * e - ExtendedMatrix::Identity()).cwiseAbs().maxCoeff());
  const double det = determinant(m);
  return {defect <= tolerance && det > 0, "the largest entry of m^T m - 1 is " + text(defect, 3) +
                                              " and the determinant is " + text(det, 3) +
                                              (det < 0 ? ", a reflection" : "")};
}

void require_proper_orthogonal(const Matrix& m, const char* what) {
  require_finite(m, what);
  const Properness found = proper_orthogonal(m);
  if (!found.proper) {
    throw std::invalid_argument(
        std::string(what) + ": expected a proper orthogonal matrix (within 1e-06), but " +
        found.measured + "; rotation.nearest(m) gives the nearest rotation");
  }
}

Rotation from_eigenvectors(const Matrix& m) {
  require_proper_orthogonal(m, "from_eigenvectors");
  const Eigen::EigenSolver<ExtendedMatrix> solver(m.cast<Extended>());
  const auto& values = solver.eigenvalues();
  const auto vectors = solver.eigenvectors();
  // Either 1 and a pair e^(+-i theta), or all three real: 1, 1, 1 or 1, -1, -1.
  Eigen::Index above = 0;
  values.imag().maxCoeff(&above);
  const bool pair = values(above).imag() > 0;
  Eigen::Index real = 0;
  (pair ? values.imag().cwiseAbs().eval() : (-values.real()).eval()).minCoeff(&real);
  ExtendedVector axis = vectors.col(real).real().normalized();
  Extended half = values.real().sum() > 0 ? 0 : std::numbers::pi_v<Extended> / 2;
  if (pair) {
    half = std::arg(values(above)) / 2;
    ExtendedMatrix basis;
    basis << vectors.col(above).real(), vectors.col(above).imag(), axis;
    if (basis.determinant() > 0) axis = -axis;
  }
  axis *= std::sin(half);
  return canonical_of({std::cos(half), axis.x(), axis.y(), axis.z()});
}

}  // namespace rotor
