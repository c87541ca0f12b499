#include "integrate/node_quadrature.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <vector>

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

double row_end(Eigen::Index row) { return row == 0 ? 1 : static_cast<double>(row) / 8; }

// Between two neighbours among the nodes and the ends of the integrals, the samples of a jump do
// not change and its integrals are linear: the greatest errors are at those places, from either
// side.
void find_jump_factors(NodeQuadrature& quadrature) {
  std::vector<double> places;
  for (std::size_t i = 0; i < 15; ++i) places.push_back(step_node(i));
  for (Eigen::Index row = 0; row < 8; ++row) places.push_back(row_end(row));
  quadrature.jump_by_residual = 0;
  quadrature.jump_by_size = 0;
  for (const double place : places) {
    for (const bool at_place : {false, true}) {
      Eigen::Matrix<double, 15, 1> samples;
      for (std::size_t j = 0; j < 15; ++j) {
        const double x = step_node(j);
        samples(static_cast<Eigen::Index>(j)) = x > place || (at_place && x == place) ? 1 : 0;
      }
      double error = 0;
      for (Eigen::Index row = 0; row < 8; ++row) {
        const double exact = std::max(0.0, row_end(row) - place);
        error = std::max(error, std::abs(quadrature.weights.row(row) * samples - exact));
      }
      // A jump at an end leaves nothing to be seen, and nothing to be wrong.
      const double residual = (quadrature.residual * samples).norm();
      if (residual < 1e-12) continue;
      quadrature.jump_by_residual = std::max(quadrature.jump_by_residual, error / residual);
      quadrature.jump_by_size = std::max(quadrature.jump_by_size, error);
    }
  }
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
    const Coefficients c =
        r.triangularView<Eigen::Upper>().transpose().solve(integrals(row_end(row)));
    quadrature.weights.row(row) = (q.leftCols<kDegree + 1>() * c).transpose();
  }
  quadrature.residual = q.rightCols<5>().transpose();
  find_jump_factors(quadrature);
  return quadrature;
}

}  // namespace

const NodeQuadrature& node_quadrature() {
  static const NodeQuadrature quadrature = make_node_quadrature();
  return quadrature;
}

}  // namespace rotor
