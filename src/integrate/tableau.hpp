// Explicit Runge-Kutta methods as data. One step of y' = f(t, y) from (t, y) by h:
//   k_i = f(t + c_i h, y + h sum_{j<i} a_ij k_j),   y1 = y + h sum_i b_i k_i.
#pragma once

#include <array>
#include <cstddef>

namespace rotor {

/// An explicit Runge-Kutta method of S stages: data only.
template <std::size_t S>
struct Tableau {
  std::array<double, S> c;                 ///< nodes, c_i = sum_j a_ij
  std::array<std::array<double, S>, S> a;  ///< strictly lower triangular
  std::array<double, S> b;                 ///< weights
  int order;                               ///< the error of one step is O(h^(order+1))
};

template <std::size_t S>
constexpr double sum_of_squares(const std::array<double, S>& weights) {
  double sum = 0;
  for (const double b : weights) sum += b * b;
  return sum;
}

/// The classical method of Kutta (1901), the one of the paper.
inline constexpr Tableau<4> kRk4Tableau = {.c = {0, 1.0 / 2, 1.0 / 2, 1},
                                           .a = {{{}, {1.0 / 2}, {0, 1.0 / 2}, {0, 0, 1}}},
                                           .b = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6},
                                           .order = 4};

}  // namespace rotor
