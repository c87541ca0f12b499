// The nearest rotation to a matrix: by what defines it, and by the two classical characterisations.
#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include "elements.hpp"

using namespace rotor;
using namespace rotor::reference;

namespace {

Matrix random_matrix(Draw& draw) {
  Matrix m;
  for (int i = 0; i < 9; ++i) m(i / 3, i % 3) = draw.uniform(-1, 1);
  return m;
}

// s2 + d s3, d the sign of the determinant: how sharply the nearest rotation is determined.
double sharpness(const Matrix& m) {
  const Vector s = Eigen::JacobiSVD<Matrix>(m).singularValues();
  return s[1] + (m.determinant() < 0 ? -s[2] : s[2]);
}

}  // namespace

TEST_CASE("nearest rotation: nothing near it or far from it is nearer") {
  const std::uint64_t seed = 701;
  CAPTURE(seed);
  Draw draw(seed);
  Worst near, far;
  for (int i = 0; i < 500; ++i) {
    const Matrix m = random_matrix(draw);
    if (sharpness(m) < 1e-3) continue;
    const Rotation best = nearest_rotation(m);
    const double least = (m - best.matrix()).norm();
    const auto where = [&] { return "matrix " + std::to_string(i); };
    for (int k = 0; k < 40; ++k) {
      const Rotation step(draw.vector(), std::pow(10, draw.uniform(-7, -1)));
      near.add(least - (m - (step * best).matrix()).norm(), where);
      far.add(least - (m - draw.rotation().matrix()).norm(), where);
    }
  }
  // Both sides are norms of about 1 of matrices known to kMatrix.
  near.within("a rotation nearby", 4 * kMatrix);
  far.within("any rotation", 4 * kMatrix);
}

TEST_CASE("nearest rotation: the polar factor, and U V^T") {
  // m = R P with P symmetric and the sum of its two smallest eigenvalues positive; and R = U
  // diag(1, 1, d) V^T. A Jacobi SVD of a 3 by 3 matrix is some dozens of plane rotations, each good
  // to an ulp: fifty ulp, over the sharpness.
  const std::uint64_t seed = 702;
  CAPTURE(seed);
  Draw draw(seed);
  Worst symmetry, formula;
  for (int i = 0; i < 2000; ++i) {
    const Matrix m = random_matrix(draw);
    const double sharp = sharpness(m);
    if (sharp < 1e-3) continue;
    const Matrix r = nearest_rotation(m).matrix();
    const Matrix p = r.transpose() * m;
    const auto where = [&] { return "matrix " + std::to_string(i); };
    symmetry.add((p - p.transpose()).norm() / m.norm() * std::min(sharp, 1.0), where);
    const Vector eigenvalues =
        Eigen::SelfAdjointEigenSolver<Matrix>((p + p.transpose()) / 2).eigenvalues();
    if (eigenvalues[0] + eigenvalues[1] <= 0) {
      FAIL_CHECK(where() << ": P has eigenvalues " << text(eigenvalues));
    }
    const Eigen::JacobiSVD<Matrix> svd(m, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const double d = (svd.matrixU() * svd.matrixV().transpose()).determinant();
    const Matrix uv = svd.matrixU() * Vector(1, 1, d).asDiagonal() * svd.matrixV().transpose();
    formula.add((r - uv).norm() * std::min(sharp, 1.0), where);
  }
  symmetry.within("symmetry of P", 1e-14);
  formula.within("U diag(1, 1, d) V^T", 1e-14);
}

TEST_CASE("nearest rotation of a stretched rotation is the rotation") {
  // Q S with S symmetric positive: P = S, R = Q, at any scale.
  for (double scale : {1e-300, 1e-5, 1.0, 1e5, 1e300}) {
    CAPTURE(scale);
    Worst worst;
    for (const Rotation& r : elements(50, 703)) {
      Matrix stretch;
      stretch << 2, 0.5, 0, 0.5, 1, -0.25, 0, -0.25, 3;
      worst.add(operator_error(nearest_rotation(r.matrix() * (scale * stretch)), r),
                [&] { return described(r); });
    }
    worst.within("rad", 1e-14);
  }
}

TEST_CASE("nearest rotation of special matrices") {
  const Matrix one = Matrix::Identity();
  CHECK(nearest_rotation(one) == Rotation());
  CHECK(nearest_rotation(Vector(1, 1, 0).asDiagonal()).angle() <= 1e-15);  // rank 2
  CHECK(nearest_rotation(Vector(3, 2, -1).asDiagonal()).angle() <=
        1e-15);  // a reflection with an answer
  CHECK(nearest_rotation(Vector(-3, -2, 1).asDiagonal()) == Rotation({0, 0, 1}, kPi));
  within(operator_error(nearest_rotation(1.5 * Rotation({0, 0, -1}, 1).matrix()),
                        Rotation({0, 0, -1}, 1)),
         1e-14);
}
