#include "integrate/dop853.hpp"

#include <Eigen/QR>

namespace rotor {
namespace {

NodeQuadrature make_node_quadrature() {
  constexpr Eigen::Index kDegree = 9;
  // Legendre polynomials on [0, 1], one a column: only the constant has an integral.
  Eigen::Matrix<double, 15, kDegree + 1> legendre;
  for (Eigen::Index i = 0; i < 15; ++i) {
    const auto node = static_cast<std::size_t>(i);
    const double x = 2 * (i < 12 ? kDop853.c[node] : kDop853DenseC[node - 12]) - 1;
    legendre(i, 0) = 1;
    legendre(i, 1) = x;
    for (Eigen::Index n = 1; n < kDegree; ++n) {
      const auto k = static_cast<double>(n);
      legendre(i, n + 1) = ((2 * k + 1) * x * legendre(i, n) - k * legendre(i, n - 1)) / (k + 1);
    }
  }
  // legendre = Q R: the first columns of Q span the polynomials' values, the others their
  // complement; weights Q1 R^-T e1 integrate and have no part in the complement.
  const Eigen::HouseholderQR<decltype(legendre)> qr(legendre);
  const Eigen::Matrix<double, 15, 15> q = qr.householderQ();
  const Eigen::Matrix<double, kDegree + 1, kDegree + 1> r =
      qr.matrixQR().topRows<kDegree + 1>().triangularView<Eigen::Upper>();
  const Eigen::Matrix<double, kDegree + 1, 1> coefficients =
      r.transpose().triangularView<Eigen::Lower>().solve(
          Eigen::Matrix<double, kDegree + 1, 1>::Unit(0));
  return {(q.leftCols<kDegree + 1>() * coefficients).transpose(), q.rightCols<5>().transpose()};
}

}  // namespace

const NodeQuadrature& node_quadrature() {
  static const NodeQuadrature quadrature = make_node_quadrature();
  return quadrature;
}

}  // namespace rotor
