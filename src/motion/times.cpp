#include "motion/times.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "rotation/text.hpp"

namespace rotor {
namespace {

constexpr std::size_t kMostTimes = 100'000'000;

}  // namespace

std::vector<double> times_in(double t0, double t1, std::size_t n) {
  if (n == 0 || n > kMostTimes) {
    throw std::invalid_argument("n must be from 1 to 1e8, got " + std::to_string(n));
  }
  std::vector<double> times(n, t0);
  const double length = t1 - t0;
  for (std::size_t i = 1; i < n; ++i) {
    const double s = static_cast<double>(i) / static_cast<double>(n - 1);
    // The weighted form, which need not rise from double to double, only where the length
    // overflows.
    const double t = std::isfinite(length) ? t0 + length * s : t0 * (1 - s) + t1 * s;
    times[i] = s == 1 ? t1 : std::clamp(t, std::min(t0, t1), std::max(t0, t1));
  }
  return times;
}

std::vector<double> times_every(double t0, double t1, double every) {
  if (!(every > 0 && std::isfinite(every))) {
    throw std::invalid_argument("every must be positive and finite, got " + text(every));
  }
  // A count that misses a whole number by rounding alone is that number.
  const double count = std::floor(std::abs(t1 - t0) / every * (1 + 1e-14));
  if (count >= static_cast<double>(kMostTimes)) {
    throw std::invalid_argument("every = " + text(every) + " makes " + text(count, 3) +
                                " times, more than 1e8");
  }
  std::vector<double> times;
  const auto last = static_cast<std::size_t>(count);
  times.reserve(last + 1);
  for (std::size_t i = 0; i <= last; ++i) {
    const double way = static_cast<double>(i) * every;
    const double t = t1 >= t0 ? t0 + way : t0 - way;
    times.push_back(t1 >= t0 ? std::min(t, t1) : std::max(t, t1));
  }
  return times;
}

}  // namespace rotor
