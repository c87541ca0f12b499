#include "spin/jet_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "rotation/text.hpp"

namespace rotor {
namespace {

constexpr double kUlp = std::numeric_limits<double>::epsilon();

using Jets = std::span<const Jet>;
using Sizes = std::array<double, Jet::kOrder + 1>;

double magnitude(const Vector& v) { return v.lpNorm<Eigen::Infinity>(); }

Vector coefficient(Jets jets, std::size_t k) {
  Vector result = Vector::Zero();
  for (std::size_t i = 0; i < jets.size(); ++i) result(static_cast<int>(i)) = jets[i].c[k];
  return result;
}

std::string text_of(Jets jets, const Vector& v) { return jets.size() == 1 ? text(v.x()) : text(v); }

Sizes sizes_of(Jets jets) {
  Sizes sizes{};
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    const Vector c = coefficient(jets, k);
    if (!c.allFinite()) {
      throw NotDifferentiable("its derivative of order " + std::to_string(k) + " is " +
                              text_of(jets, c));
    }
    sizes[k] = magnitude(c);
  }
  return sizes;
}

// The time in which the terms of the series after order j grow to that one, for the j among 0, 1
// and 2 (a coefficient may vanish, or be rounding alone) for which it is longest; at most |t|, or
// what takes its place where t is about 0.
double time_scale(const Sizes& sizes, double t) {
  double longest = 0;
  for (std::size_t j = 0; j < 3; ++j) {
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t k = j + 1; k < sizes.size() && sizes[j] > 0; ++k) {
      const double ratio = sizes[j] / sizes[k];
      shortest = std::min(shortest, std::pow(ratio, 1 / static_cast<double>(k - j)));
    }
    if (sizes[j] > 0) longest = std::max(longest, shortest);
  }
  const double most = std::max(std::abs(t), 0x1p-10);
  return longest > 0 ? std::min(longest, most) : most;
}

Vector foretold(Jets jets, double step) {
  Vector sum = Vector::Zero();
  for (std::size_t k = Jet::kOrder + 1; k-- > 0;) sum = sum * step + coefficient(jets, k);
  return sum;
}

// By how much values nearer to t than h differ from what the series foretells, on that side where
// they do less: a kink or a jump leaves one side of t as foretold, but where digits were lost
// inside (1 - cos s for a small s) there is noise on both. Eight times that.
double noise(Jets jets, double t, double h, const std::function<Vector(double)>& value) {
  double least = std::numeric_limits<double>::infinity();
  for (const double side : {-1.0, 1.0}) {
    double greatest = 0;
    for (const double part : {0.005, 0.01, 0.015, 0.02, 0.03, 0.04}) {
      const Vector there = value(t + side * part * h);
      const double difference = magnitude(there - foretold(jets, side * part * h));
      if (std::isfinite(difference)) greatest = std::max(greatest, difference);
    }
    least = std::min(least, greatest);
  }
  return 8 * least;
}

}  // namespace

// The step h is 2^-10 of the time scale T: what the series leaves out there, some M (h/T)^9 = 2^-90
// M with M the largest |c_k| T^k for k >= 1, is below rounding. That is 2^6 ulp of the value and of
// what an error of one ulp of t makes of it, for functions of some dozen operations; one that loses
// digits inside is noisier, therefore it is only asked that what omega changes by is foretold to
// one part in 2^13. Then a jump J of the first derivative, wrong by J h on one side, is seen from J
// of 2^-13 M/T on, one of the second from 2^-2 M/T^2.
void check_jet(Jets jets, double t, const std::function<Vector(double)>& value) {
  const Sizes sizes = sizes_of(jets);
  const Vector here = value(t);
  if (!here.allFinite()) throw NotDifferentiable("it gives " + text_of(jets, here));
  const Vector with_jet = coefficient(jets, 0);
  if (!(magnitude(with_jet - here) <= 4 * kUlp * magnitude(here))) {
    throw NotDifferentiable("called with a number it gives " + text_of(jets, here) +
                            ", with a jet " + text_of(jets, with_jet) +
                            " (t == 1 is true of no jet; t <= 1 can be)");
  }
  const double scale = time_scale(sizes, t);
  double change = 0;
  for (std::size_t k = 1; k < sizes.size(); ++k) {
    change = std::max(change, sizes[k] * std::pow(scale, static_cast<double>(k)));
  }
  const double h = std::max(0x1p-10 * scale, 0x1p-42 * std::abs(t));
  if (h > 0x1p-3 * scale) return;  // doubles about t are too far apart to show what is there
  const double tolerance = 0x1p-13 * h / scale * change + std::numeric_limits<double>::min() +
                           0x1p6 * kUlp * (sizes[0] + std::abs(t) * sizes[1]);
  int sides = 0;
  for (const double s : {t - h, t + h}) {
    const Vector there = value(s);
    if (!there.allFinite()) continue;
    ++sides;
    const Vector expected = foretold(jets, s - t);
    const double difference = magnitude(there - expected);
    if (difference <= tolerance || difference <= tolerance + noise(jets, t, h, value)) continue;
    throw NotDifferentiable("a kink or a jump: its derivatives there foretell " +
                            text_of(jets, expected) + " at t = " + text(s) + ", where it is " +
                            text_of(jets, there));
  }
  if (sides == 0) throw NotDifferentiable("it has no values on either side");
}

}  // namespace rotor
