// Integration in extended precision on the nodes of Gauss and Legendre.
#pragma once

#include <Eigen/Core>

#include "rotation/rotation.hpp"

namespace rotor {

/// What 32 samples of a function on [-1, 1], at the zeros of P_32, say of it: the series
/// sum c_k P_k(x), k = 0 ... 31, that goes through them.
struct LegendreRule {
  static constexpr int kNodes = 32;
  using Values = Eigen::Matrix<Extended, kNodes, 1>;
  using Square = Eigen::Matrix<Extended, kNodes, kNodes>;

  Values nodes;         // rising
  Square coefficients;  // times the samples: c
  Square slopes;        // times the samples: the derivative of the series at the nodes
};
const LegendreRule& legendre_rule();

/// The series at x.
Extended legendre_sum(const LegendreRule::Values& c, Extended x);
/// Its integral from -1 to x.
Extended legendre_integral(const LegendreRule::Values& c, Extended x);

}  // namespace rotor
