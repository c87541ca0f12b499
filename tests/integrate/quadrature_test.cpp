// The quadrature on the nodes of a DOP853 step against the integrals of polynomials and of jumps.
#include <cmath>
#include <limits>

#include <algorithm>
#include <cmath>

#include "catch.hpp"
#include "integrate/node_quadrature.hpp"
#include "rotation/rotation.hpp"

namespace {

using namespace rotor;
using Values = Eigen::Matrix<Extended, 15, 1>;

constexpr double kEnds[] = {1,   0.125, 0.25, 0.375,
                            0.5, 0.625, 0.75, 0.875};  // of the integrals, row by row

template <class Function>
Values at_nodes(const Function& f) {
  Values values;
  for (std::size_t i = 0; i < 15; ++i) {
    values[static_cast<Eigen::Index>(i)] = f(i < 12 ? kDop853Tableau.c[i] : kDop853DenseC[i - 12]);
  }
  return values;
}

// (2x - 1)^k: at most 1, so that the errors below are absolute.
Values power(int k) {
  return at_nodes([k](double x) { return std::pow(2 * Extended{x} - 1, k); });
}
double weights_error(int row, int k) {
  const Extended sum = node_quadrature().weights.row(row).cast<Extended>() * power(k);
  const Extended z = 2 * Extended{kEnds[row]} - 1;
  const Extended integral = (std::pow(z, k + 1) - std::pow(Extended{-1}, k + 1)) / (2 * (k + 1));
  return std::abs(static_cast<double>(sum - integral));
}

// Householder's QR of 15 columns of 10 is backward stable to some 15 * 10 u.
constexpr double kTolerance = 150 * std::numeric_limits<double>::epsilon() / 2;

}  // namespace

TEST_CASE("the node quadrature integrates polynomials of degree 9, and not of degree 10") {
  for (int row = 0; row < 8; ++row) {
    for (int k = 0; k <= 9; ++k) {
      CAPTURE(row, k);
      CHECK(weights_error(row, k) < kTolerance);
    }
    CHECK(weights_error(row, 10) > 1e-5);
  }
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

TEST_CASE("a jump anywhere is integrated with the error stated at most, and nearly so") {
  const NodeQuadrature& q = node_quadrature();
  double by_residual = 0;
  double by_size = 0;
  for (int i = 1; i < 20000; ++i) {
    const double place = i / 20000.0;
    const auto step = at_nodes([place](double x) { return Extended{x > place ? 1.0 : 0.0}; });
    const auto residual = static_cast<double>((q.residual.cast<Extended>() * step).norm());
    for (int row = 0; row < 8; ++row) {
      const Extended exact = std::max(Extended{0}, kEnds[row] - Extended{place});
      const auto error =
          static_cast<double>(std::abs(q.weights.row(row).cast<Extended>() * step - exact));
      by_residual = std::max(by_residual, error / residual);
      by_size = std::max(by_size, error);
    }
  }
  CHECK(by_residual <= q.jump_by_residual * (1 + 1e-9));
  CHECK(by_residual >=
        q.jump_by_residual * 0.99);  // the places are 1/20000 apart, the gap that decides is 1/7
  CHECK(by_size <= q.jump_by_size * (1 + 1e-9));
  CHECK(by_size >= q.jump_by_size * 0.99);
}
