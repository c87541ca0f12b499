// The quadrature on the nodes of a DOP853 step against the integrals of polynomials.
#include <cmath>
#include <limits>

#include "catch.hpp"
#include "integrate/dop853.hpp"

namespace {

using namespace rotor;
using Values = Eigen::Matrix<Extended, 15, 1>;

// (2x - 1)^k at the nodes: at most 1, so that the errors below are absolute.
Values power(int k) {
  Values values;
  for (std::size_t i = 0; i < 15; ++i) {
    const Extended x = 2 * Extended{i < 12 ? kDop853.c[i] : kDop853DenseC[i - 12]} - 1;
    values[static_cast<Eigen::Index>(i)] = std::pow(x, k);
  }
  return values;
}
Extended integral(int k) { return k % 2 == 0 ? Extended{1} / (k + 1) : 0; }

// Householder's QR of 15 columns of 10 is backward stable to some 15 * 10 u.
constexpr double kTolerance = 150 * std::numeric_limits<double>::epsilon() / 2;

}  // namespace

TEST_CASE("the node quadrature integrates polynomials of degree 9, and not of degree 10") {
  const auto weights = node_quadrature().weights.cast<Extended>().eval();
  const auto error = [&](int k) {
    return std::abs(static_cast<double>(weights.dot(power(k)) - integral(k)));
  };
  for (int k = 0; k <= 9; ++k) {
    CAPTURE(k);
    CHECK(error(k) < kTolerance);
  }
  CHECK(error(10) > 1e-3);
}

TEST_CASE("the residual annihilates polynomials of degree 9, and not of degree 10") {
  const auto residual = node_quadrature().residual.cast<Extended>().eval();
  const auto left = [&](int k) { return static_cast<double>((residual * power(k)).norm()); };
  for (int k = 0; k <= 9; ++k) {
    CAPTURE(k);
    CHECK(left(k) < kTolerance);
  }
  CHECK(left(10) > 1e-4);
}

TEST_CASE("the rows of the residual are orthonormal, and the weights of least norm") {
  const NodeQuadrature& q = node_quadrature();
  CHECK((q.residual * q.residual.transpose() - Eigen::Matrix<double, 5, 5>::Identity()).norm() <
        kTolerance);
  CHECK((q.residual * q.weights.transpose()).norm() < kTolerance);
}
