#include "integrate/node_quadrature.hpp"

#include <Eigen/QR>

namespace rotor {
namespace {

constexpr Eigen::Index kDegree = 9;
using Coefficients = Eigen::Matrix<double, kDegree + 1, 1>;

// P_0 ... P_(degree + 1), Legendre's polynomials, at 2x - 1.
Eigen::Matrix<double, kDegree + 2, 1> legendre(double x) {
  Eigen::Matrix<double, kDegree + 2, 1> p;
  const double z = 2 * x - 1;
  p(0) = 1;
  p(1) = z;
  for (Eigen::Index n = 1; n <= kDegree; ++n) {
    const auto k = static_cast<double>(n);
    p(n + 1) = ((2 * k + 1) * z * p(n) - k * p(n - 1)) / (k + 1);
  }
  return p;
}

// Their integrals from 0 to x: (P_(n+1) - P_(n-1)) / (2 (2n + 1)).
Coefficients integrals(double x) {
  const auto p = legendre(x);
  Coefficients integral;
  integral(0) = x;
  for (Eigen::Index n = 1; n <= kDegree; ++n) {
    integral(n) = (p(n + 1) - p(n - 1)) / (2 * (2 * static_cast<double>(n) + 1));
  }
  return integral;
}

// Between two neighbouring nodes the samples of a jump do not change and its integral is linear:
// the greatest errors are at the nodes, from either side.
double jump_factor(const NodeQuadrature& quadrature) {
  double greatest = 0;
  for (std::size_t i = 0; i < 15; ++i) {
    for (const bool jumped : {false, true}) {
      Eigen::Matrix<double, 15, 1> samples;
      for (std::size_t j = 0; j < 15; ++j) {
        samples(static_cast<Eigen::Index>(j)) =
            step_node(j) > step_node(i) || (jumped && j == i) ? 1 : 0;
      }
      const double residual = (quadrature.residual * samples).norm();
      const double error = std::abs(quadrature.weights.row(0) * samples - (1 - step_node(i)));
      // A jump at an end leaves nothing to be seen, and nothing to be wrong.
      if (residual > 1e-12) greatest = std::max(greatest, error / residual);
    }
  }
  return greatest;
}

NodeQuadrature make_node_quadrature() {
  Eigen::Matrix<double, 15, kDegree + 1> values;
  for (std::size_t i = 0; i < 15; ++i) {
    values.row(static_cast<Eigen::Index>(i)) =
        legendre(step_node(i)).head<kDegree + 1>().transpose();
  }
  // values = Q R: the first columns of Q span the values of the polynomials, the others their
  // complement; the weights Q1 R^-T (integrals) integrate and have no part in the complement.
  const Eigen::HouseholderQR<decltype(values)> qr(values);
  const Eigen::Matrix<double, 15, 15> q = qr.householderQ();
  const Eigen::Matrix<double, kDegree + 1, kDegree + 1> r = qr.matrixQR().topRows<kDegree + 1>();
  NodeQuadrature quadrature;
  for (Eigen::Index row = 0; row < 8; ++row) {
    const double x = row == 0 ? 1 : static_cast<double>(row) / 8;
    const Coefficients c = r.triangularView<Eigen::Upper>().transpose().solve(integrals(x));
    quadrature.weights.row(row) = (q.leftCols<kDegree + 1>() * c).transpose();
  }
  quadrature.residual = q.rightCols<5>().transpose();
  quadrature.jump = jump_factor(quadrature);
  return quadrature;
}

}  // namespace

const NodeQuadrature& node_quadrature() {
  static const NodeQuadrature quadrature = make_node_quadrature();
  return quadrature;
}

}  // namespace rotor
