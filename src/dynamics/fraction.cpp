#include "dynamics/fraction.hpp"

#include <algorithm>
#include <cmath>

namespace rotor {

std::size_t largest_denominator(double error) {
  constexpr double kMost = 1000;
  constexpr double kByChance = 1e-6;
  // Up to n there are n^2/2 fractions in a turn, or fewer, but for n = 1; each takes 2 error of it.
  return static_cast<std::size_t>(std::min(kMost, std::sqrt(kByChance / (2 * error))));
}

std::optional<Fraction> fraction_within(double number, double error) {
  const auto most = static_cast<long>(largest_denominator(error));
  for (long denominator = 1; denominator <= most; ++denominator) {
    const auto n = static_cast<double>(denominator);
    const double numerator = std::nearbyint(n * number);
    if (std::abs(number - numerator / n) <= error)
      return Fraction{static_cast<long>(numerator), denominator};
  }
  return std::nullopt;
}

}  // namespace rotor
