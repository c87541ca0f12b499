// One step of an explicit Runge-Kutta method for y' = F(omega(t), y).
//
// omega depends on t alone, so it is sampled at the nodes first, each distinct node once, and the
// stages are then pure arithmetic.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "integrate/tableau.hpp"
#include "rotation/rotation.hpp"

namespace rotor {

/// sum_i weights_i k_i; zero weights cost nothing but the test.
template <std::size_t N, std::size_t M, class Value>
Value weighted_sum(const std::array<double, N>& weights, const std::array<Value, M>& k,
                   std::size_t count = N) {
  static_assert(N <= M);
  Value sum = Value::Zero();
  for (std::size_t i = 0; i < count; ++i) {
    if (weights[i] != 0) sum += weights[i] * k[i];
  }
  return sum;
}

/// The slopes k_i of one step from y by h; `omega` holds its values at t + c_i h.
template <class Equation, std::size_t S>
std::array<typename Equation::Value, S> stages(const Equation& equation, const Tableau<S>& method,
                                               const std::array<Vector, S>& omega,
                                               const typename Equation::Value& y, double h) {
  std::array<typename Equation::Value, S> k;
  for (std::size_t i = 0; i < S; ++i) {
    k[i] = equation.rate(omega[i], y + h * weighted_sum(method.a[i], k, i));
  }
  return k;
}

/// The increment y1 - y of the step.
template <class Equation, std::size_t S>
typename Equation::Value increment(const Equation& equation, const Tableau<S>& method,
                                   const std::array<Vector, S>& omega,
                                   const typename Equation::Value& y, double h) {
  return h * weighted_sum(method.b, stages(equation, method, omega, y, h));
}

/// What the rounding of y adds to the error of a step that turns by `turn`, rad: y is off by
/// u stretch(y) as a rotation, and where a singularity is near, rates change by their own size over
/// the distance to it.
template <class Equation>
double state_rounding(const Equation& equation, const typename Equation::Value& y, double turn) {
  const double stretch = equation.stretch(y);
  if (stretch == 0) return 0;
  return std::numeric_limits<double>::epsilon() / 2 * turn * stretch /
         std::min(1.0, equation.distance(y));
}

/// A sum that carries its own rounding error (Kahan): after n additions it is as if added once.
template <class Value>
class CompensatedSum {
 public:
  explicit CompensatedSum(const Value& start) : value_(start), low_(Value::Zero()) {}
  const Value& value() const { return value_; }
  void add(const Value& increment) {
    const Value corrected = increment + low_;
    const Value sum = value_ + corrected;
    low_ = corrected - (sum - value_);
    value_ = sum;
  }

 private:
  Value value_;
  Value low_;
};

}  // namespace rotor
