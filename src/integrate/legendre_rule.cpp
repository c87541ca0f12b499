#include "integrate/legendre_rule.hpp"

#include <cmath>
#include <numbers>

namespace rotor {
namespace {

constexpr int kNodes = LegendreRule::kNodes;
using Polynomials = Eigen::Matrix<Extended, kNodes + 1, 1>;

// P_0 ... P_32 at x: (k + 1) P_(k+1) = (2k + 1) x P_k - k P_(k-1).
Polynomials legendre(Extended x) {
  Polynomials p;
  p[0] = 1;
  p[1] = x;
  for (int k = 1; k < kNodes; ++k) p[k + 1] = ((2 * k + 1) * x * p[k] - k * p[k - 1]) / (k + 1);
  return p;
}

// P_k' = k (P_(k-1) - x P_k)/(1 - x^2).
Extended slope(const Polynomials& p, int k, Extended x) {
  return k == 0 ? 0 : k * (p[k - 1] - x * p[k]) / (1 - x * x);
}

LegendreRule made() {
  LegendreRule rule;
  LegendreRule::Square slopes_of_series;
  for (int i = 0; i < kNodes; ++i) {
    Extended x = -std::cos(std::numbers::pi_v<Extended> * (i + Extended{0.75}) / (kNodes + 0.5L));
    for (int newton = 0; newton < 6; ++newton) {
      const auto p = legendre(x);
      x -= p[kNodes] / slope(p, kNodes, x);
    }
    const auto p = legendre(x);
    const Extended end = slope(p, kNodes, x);
    const Extended weight = 2 / ((1 - x * x) * end * end);
    rule.nodes[i] = x;
    for (int k = 0; k < kNodes; ++k) {
      rule.coefficients(k, i) = (k + Extended{0.5}) * weight * p[k];
      slopes_of_series(i, k) = slope(p, k, x);
    }
  }
  rule.slopes = slopes_of_series * rule.coefficients;
  return rule;
}

}  // namespace

const LegendreRule& legendre_rule() {
  static const LegendreRule rule = made();
  return rule;
}

Extended legendre_sum(const LegendreRule::Values& c, Extended x) {
  const auto p = legendre(x);
  Extended sum = 0;
  for (int k = kNodes - 1; k >= 0; --k) sum += c[k] * p[k];
  return sum;
}

// The integral of P_k from -1 is (P_(k+1) - P_(k-1))/(2k + 1), of P_0 it is P_1 + P_0.
Extended legendre_integral(const LegendreRule::Values& c, Extended x) {
  const auto p = legendre(x);
  Extended sum = 0;
  for (int k = kNodes - 1; k > 0; --k) sum += c[k] * (p[k + 1] - p[k - 1]) / (2 * k + 1);
  return sum + c[0] * (x + 1);
}

}  // namespace rotor
