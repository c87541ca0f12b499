#include "rotation/small_angle.hpp"

#include <array>
#include <cmath>

namespace rotor {
namespace {

// (2k+2)/(2k+3)! with alternating sign, k = 0 ... 10.
constexpr std::array<double, 11> series_coefficients() {
  std::array<double, 11> c{};
  long double inverse_factorial = 1.0L / 6;  // 1/(2k+3)!
  for (int k = 0; k < 11; ++k) {
    c[static_cast<std::size_t>(k)] =
        static_cast<double>((k % 2 == 0 ? 1 : -1) * (2 * k + 2) * inverse_factorial);
    inverse_factorial /= (2 * k + 4) * (2 * k + 5);
  }
  return c;
}
constexpr auto kSeries = series_coefficients();

}  // namespace

double half_cot(double theta) {
  const double h = theta / 2;
  return h == 0 ? 1 : h / std::tan(h);
}

double one_minus_half_cot(double theta) {
  const double h = theta / 2;
  if (std::abs(h) > 1.5) return (1 - half_cot(theta)) / theta / theta;
  if (h == 0) return 1.0 / 12;
  double sum = 0;
  for (auto c = kSeries.rbegin(); c != kSeries.rend(); ++c) sum = sum * h * h + *c;
  return sum / (4 * (std::sin(h) / h));
}

}  // namespace rotor
