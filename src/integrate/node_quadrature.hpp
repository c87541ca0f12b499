// Integration on the nodes that a step of DOP853 has anyway.
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "integrate/dop853_tableau.hpp"

namespace rotor {

/// Node i of the fifteen distinct ones of a step and its dense output, as a fraction of the step.
inline double step_node(std::size_t i) {
  return i < 12 ? kDop853Tableau.c[i] : kDop853DenseC[i - 12];
}

/// What fifteen values on the distinct nodes x of a step and its dense output say of a function.
struct NodeQuadrature {
  /// Row by row: sum_i weights_i p(x_i) = the integral of p from 0 to 1, 1/8, 2/8 ... 7/8 for every
  /// polynomial p of degree 9; the weights of least norm.
  Eigen::Matrix<double, 8, 15> weights;
  /// Orthonormal rows that annihilate the polynomials of degree 9: what is left is not smooth.
  Eigen::Matrix<double, 5, 15> residual;
  /// The greatest error of any of the integrals of a function with one jump, wherever it is: in
  /// units of the norm of its residual, and in units of the jump.
  double jump_by_residual;
  double jump_by_size;
};
const NodeQuadrature& node_quadrature();

}  // namespace rotor
