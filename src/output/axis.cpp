#include "output/axis.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace rotor {
namespace {

constexpr std::size_t kShort = 8;

std::string fixed(std::string digits, int exponent) {
  if (exponent >= 0) return digits.append(static_cast<std::size_t>(exponent), '0');
  const auto decimals = static_cast<std::size_t>(-exponent);
  if (digits.size() <= decimals) digits.insert(0, decimals + 1 - digits.size(), '0');
  return digits.insert(digits.size() - decimals, 1, '.');
}

std::string scientific(std::string digits, int exponent) {
  exponent += static_cast<int>(digits.size()) - 1;
  if (digits.size() > 1) digits.insert(1, 1, '.');
  const std::string size = std::to_string(std::abs(exponent));
  digits += exponent < 0 ? "e-" : "e+";
  if (size.size() < 2) digits += '0';
  return digits += size;
}

std::size_t longest(const std::vector<std::string>& labels) {
  std::size_t longest = 0;
  for (const std::string& label : labels) longest = std::max(longest, label.size());
  return longest;
}

}  // namespace

long double Step::size() const {
  return static_cast<long double>(digit) * std::pow(10.0L, exponent);
}

Step Step::next() const {
  if (digit == 5) return {1, exponent + 1};
  return {digit == 1 ? 2 : 5, exponent};
}

Step step_from(long double size) {
  Step step{1, static_cast<int>(std::floor(std::log10(size)))};
  while (step.size() < size * (1 - 1e-12L)) step = step.next();
  return step;
}

std::vector<std::string> tick_labels(Step step, std::int64_t first, std::int64_t last,
                                     Spacing spacing) {
  std::vector<std::string> plain;
  std::vector<std::string> powers;
  if (spacing == Spacing::kLogarithmic) {
    for (std::int64_t tick = first; tick <= last; ++tick) {
      powers.push_back(
          scientific("1", static_cast<int>(static_cast<long double>(tick) * step.size())));
    }
    return powers;
  }
  for (std::int64_t tick = first; tick <= last; ++tick) {
    const std::string sign = tick < 0 ? "-" : "";
    const std::string digits = std::to_string(std::abs(tick) * step.digit);
    plain.push_back(
        sign + (tick == 0 ? fixed("0", std::min(step.exponent, 0)) : fixed(digits, step.exponent)));
    powers.push_back(tick == 0 ? "0" : sign + scientific(digits, step.exponent));
  }
  return longest(plain) <= std::max(kShort, longest(powers)) ? plain : powers;
}

Extent drawable(double low, double high, Spacing spacing) {
  if (spacing == Spacing::kLogarithmic) {
    const Extent decades{std::floor(low), std::ceil(high)};
    return decades.low < decades.high ? decades : Extent{decades.low - 1, decades.high + 1};
  }
  const long double size = std::max(std::abs(low), std::abs(high));
  const long double least = 16 * std::numeric_limits<double>::epsilon() * size;
  if (static_cast<long double>(high) - low > least) return {low, high};
  const long double margin = size > 0 ? size / 2 : 1;
  return {low - margin, high + margin};
}

}  // namespace rotor
