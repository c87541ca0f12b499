#include "rotation/small_angle.hpp"

#include <array>
#include <cmath>

namespace rotor {
namespace {

// (-1)^k/(2k+3)!, k = 0 ... 11.
constexpr std::array<Extended, 12> series_coefficients() {
  std::array<Extended, 12> c{};
  Extended term = 1.0L / 6;
  for (int k = 0; k < 12; ++k) {
    c[static_cast<std::size_t>(k)] = term;
    term /= -(2 * k + 4) * (2 * k + 5);
  }
  return c;
}
constexpr auto kSeries = series_coefficients();

constexpr Extended kSmall = 1.5L;

}  // namespace

Extended sinc(Extended theta) { return theta == 0 ? 1 : std::sin(theta) / theta; }

Extended one_minus_cos(Extended theta) {
  const Extended s = sinc(theta / 2);
  return s * s / 2;
}

Extended angle_minus_sin(Extended theta) {
  if (std::abs(theta) > kSmall) return (theta - std::sin(theta)) / theta / theta / theta;
  Extended sum = 0;
  for (auto c = kSeries.rbegin(); c != kSeries.rend(); ++c) sum = sum * theta * theta + *c;
  return sum;
}

Extended half_cot(Extended theta) {
  const Extended h = theta / 2;
  return h == 0 ? 1 : h / std::tan(h);
}

Extended one_minus_half_cot(Extended theta) {
  const Extended h = theta / 2;
  if (std::abs(h) > kSmall) return (1 - half_cot(theta)) / theta / theta;
  return (one_minus_cos(h) - angle_minus_sin(h)) / (4 * sinc(h));
}

}  // namespace rotor
