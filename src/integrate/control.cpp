#include "integrate/control.hpp"

#include <algorithm>
#include <cmath>

namespace rotor {

double ErrorBudget::allowed(double h, double done) const {
  const double share = 0.5 * accuracy_ * (h / length_);
  const double granted = accuracy_ * (0.1 + 0.9 * (done / length_));
  return std::max(share, (granted - spent_) / 8);
}

double step_factor(double error, double allowed, double exponent) {
  if (error == 0) return 5;
  if (!std::isfinite(error) || !(allowed > 0)) return 0.2;
  return std::clamp(0.9 * std::pow(allowed / error, 1 / exponent), 0.2, 5.0);
}

}  // namespace rotor
