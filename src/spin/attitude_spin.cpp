#include "spin/attitude_spin.hpp"

#include <algorithm>
#include <array>

#include "rotation/text.hpp"

namespace rotor {
namespace {

Jet dot(const VectorJet& a, const VectorJet& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
VectorJet cross(const VectorJet& a, const VectorJet& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// sum_k (-x)^k/(2k + first)!: (1 - cos theta)/theta^2 for first = 2, (theta - sin theta)/theta^3
// for 3, where x = theta^2. Of the 20 terms the last is 1e-19 of the first for theta = 2 pi.
Jet even_series(const Jet& x, int first) {
  std::array<double, 20> c{};
  double factorial = 1;
  for (int i = 2; i <= first; ++i) factorial *= i;
  for (std::size_t k = 0; k < c.size(); ++k) {
    const auto n = 2 * static_cast<double>(k) + first;
    c[k] = (k % 2 == 0 ? 1 : -1) / factorial;
    factorial *= (n + 1) * (n + 2);
  }
  Jet sum;
  for (std::size_t k = c.size(); k-- > 0;) sum = sum * x + Jet::constant(c[k]);
  return sum;
}

}  // namespace

// In the frame of the first attitude of the interval, omega = phi' + (1 - cos theta)/theta^2 phi x
// phi' + (theta - sin theta)/theta^3 phi x (phi x phi') with theta = |phi|.
VectorJet AttitudeSpin::jet(double t) const {
  const Vector now = value(t);
  const std::vector<double>& times = spline_.times();
  if (t != times.front() && t != times.back() &&
      std::binary_search(times.begin(), times.end(), t)) {
    throw NotDifferentiable("t = " + text(t) + " is that of an attitude (" + description() +
                            "): a derivative of omega jumps there");
  }
  const auto [from, curve] = spline_.expansion(t);
  VectorJet phi;
  VectorJet rate;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t k = 0; k < curve.size(); ++k) {
      const auto c = static_cast<double>(curve[k](static_cast<Eigen::Index>(axis)));
      phi[axis].c[k] = c;
      if (k > 0) rate[axis].c[k - 1] = static_cast<double>(k) * c;
    }
  }
  const Jet x = dot(phi, phi);
  const VectorJet across = cross(phi, rate);
  const VectorJet twice = cross(phi, across);
  const Jet first = even_series(x, 2);
  const Jet second = even_series(x, 3);
  VectorJet turned;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    turned[axis] = rate[axis] + first * across[axis] + second * twice[axis];
  }
  const Matrix q = from.cast<double>().toRotationMatrix();
  VectorJet jet;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto row = static_cast<Eigen::Index>(axis);
    jet[axis] = turned[0] * q(row, 0) + turned[1] * q(row, 1) + turned[2] * q(row, 2);
    jet[axis].c[0] = now(row);
  }
  return jet;
}

std::string AttitudeSpin::description() const {
  return "the omega of " + std::to_string(spline_.times().size()) + " attitudes";
}

std::vector<double> AttitudeSpin::breaks(double low, double high) const {
  const std::vector<double>& times = spline_.times();
  const auto first = std::upper_bound(times.begin(), times.end(), low);
  return {first, std::lower_bound(first, times.end(), high)};
}

}  // namespace rotor
