// Panels: what 64 samples tell of a function, and how well they say that they know it.
#include "integrate/panel.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "catch.hpp"
#include "integrate/fgl_tables.hpp"
#include "integrate/gauss_tables.hpp"

namespace {

using namespace rotor;

constexpr double kUnit = std::numeric_limits<double>::epsilon() / 2;

// The root mean square of panel - f, at 2000 places evenly.
double size_of_error(const Panel& panel, const std::function<Vector(double)>& f) {
  double squares = 0;
  for (int i = 0; i < 2000; ++i) {
    const double t = panel.begin() + (panel.end() - panel.begin()) * ((i + 0.5) / 2000);
    squares += (panel.at(static_cast<double>(panel.place(t))) - f(t)).squaredNorm() / 2000;
  }
  return std::sqrt(squares);
}

template <std::size_t N>
void check_gauss(const std::array<Extended, N>& nodes, const std::array<double, N>& weights) {
  // Exact up to degree 4 N - 1; what is odd is so by symmetry. Each weight is rounded by half an
  // ulp, so the sum of positive terms by a relative 2^-53.
  for (std::size_t k = 0; k < 4 * N; k += 2) {
    Extended sum = 0;
    for (std::size_t i = 0; i < N; ++i) {
      sum += 2 * Extended{weights[i]} * std::pow(nodes[i], static_cast<Extended>(k));
    }
    const Extended truth = Extended{2} / static_cast<Extended>(k + 1);
    CAPTURE(k);
    CHECK(std::abs(static_cast<double>(sum / truth - 1)) <= 1.01 * kUnit);
  }
}

}  // namespace

TEST_CASE("the nodes of Gauss and Legendre integrate every power that they should") {
  check_gauss(kGauss16Nodes, kGauss16Weights);
  check_gauss(kGauss64Nodes, kGauss64Weights);
}

TEST_CASE("a panel is a polynomial of degree 63 exactly, and its integral") {
  // T_63(z) and T_62(z): |T| <= 1; each sum of 64 terms has some 64 roundings of terms below 10.
  for (const auto& [begin, end] : {std::pair{-1.0, 1.0}, std::pair{3.0, -2.0}}) {
    const auto z = [b = begin, e = end](double t) { return ((t - b) - (e - t)) / (e - b); };
    const auto f = [&](double t) {
      const double angle = std::acos(std::clamp(z(t), -1.0, 1.0));
      return Vector(std::cos(63 * angle), std::cos(62 * angle), 1);
    };
    const Panel panel = Panel::of(f, begin, end);
    for (const double x : {-1.0, -0.999, -0.3, 0.0, 0.77, 1.0}) {
      const double t = begin + (end - begin) * ((1 + x) / 2);
      CHECK((panel.at(z(t)) - f(t)).norm() < 2e-12);
      // The integral of T_n is (T_(n+1)/(n+1) - T_(n-1)/(n-1))/2.
      const auto integral = [](double n, double y) {
        const double angle = std::acos(y);
        return (std::cos((n + 1) * angle) / (n + 1) - std::cos((n - 1) * angle) / (n - 1)) / 2;
      };
      const double half = (end - begin) / 2;
      const ExtendedVector sum = panel.integral(x);
      CHECK(static_cast<double>(sum.x()) ==
            Approx(half * (integral(63, x) - integral(63, -1))).epsilon(0).margin(1e-12));
      CHECK(static_cast<double>(sum.y()) ==
            Approx(half * (integral(62, x) - integral(62, -1))).epsilon(0).margin(1e-12));
      CHECK(static_cast<double>(sum.z()) == Approx(half * (x + 1)).epsilon(0).margin(1e-12));
    }
  }
}

TEST_CASE("a panel knows what it leaves out, from waves too fast to smooth ones") {
  // Waves cos(kappa z), poles at +-i/kappa * 20, a jump and a bend; kappa from resolved to lost.
  const auto families = std::vector<std::function<Vector(double, double)>>{
      [](double k, double z) { return Vector(std::cos(k * z), std::sin(k * z), 0.2); },
      [](double k, double z) { return Vector(1 / (1 + k * k / 64 * z * z), z, 0); },
      [](double k, double z) { return Vector(z > k / 100 - 0.2 ? 1 : 0, 0, 0); },
      [](double k, double z) { return Vector(1, std::abs(z - k / 100), 0); }};
  for (std::size_t family = 0; family < families.size(); ++family) {
    for (double kappa = 4; kappa < 60; kappa *= 1.07) {
      const auto f = [&](double t) { return families[family](kappa, t); };
      const Panel panel = Panel::of(f, -1, 1);
      const double truth = size_of_error(panel, f);
      CAPTURE(family, kappa, truth, panel.error());
      // Honest to a factor of 3 above the noise: the terms go on as they last fell, at the most.
      CHECK(truth <= 3 * panel.error() + 16 * kUnit);
      // And no more than a hundred times too careful, where waves fall ever faster.
      if (truth > 1e-9 && truth < 1e-3 && family < 2) CHECK(panel.error() <= 100 * truth);
    }
  }
}

TEST_CASE("a jump or a bend between the last node and an end is seen") {
  for (const double place : {0.9999, -0.9999}) {
    const auto f = [&](double t) { return Vector((t > place) == (place > 0) ? 1 : 0, 0, 1); };
    const Panel panel = Panel::of(f, -1, 1);
    // The integral is off by 1e-4 of 2.
    CHECK(2 * panel.error() > 1e-4);
  }
}

TEST_CASE("noise shows as noise: its size is that of the terms, and no error") {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  const auto f = [&](double t) {
    return Vector(std::cos(3 * t) + 1e-16 * normal(random), 1 + 1e-16 * normal(random), 0);
  };
  const Panel panel = Panel::of(f, 0, 1);
  CHECK(panel.error() == 0);
  // sqrt(2) 1e-16 in each sample makes sqrt(2)/8 1e-16 of each term; rounding adds to it.
  CAPTURE(panel.noise() / kUnit);
  CHECK(panel.noise() > 1e-17);
  CHECK(panel.noise() < 2e-16);
  CHECK(panel.length_factor(1e-30) > 1);
}

TEST_CASE("lengths go to where the error is allowed, and no further") {
  // cos(kappa z) of every kappa: the panel that is proposed has what is allowed, or next to it.
  for (double kappa = 1; kappa < 200; kappa *= 1.3) {
    const auto panel = [](double k) {
      return Panel::of([k](double z) { return Vector(std::cos(k * z), std::sin(k * z), 1); }, -1,
                       1);
    };
    double k = kappa;
    int tries = 0;
    while (panel(k).error() > 1e-10 && tries < 20) {
      k *= std::min(0.7, panel(k).length_factor(1e-10));
      ++tries;
    }
    CAPTURE(kappa, k, tries);
    CHECK(tries <= 5);
    for (int i = 0; i < 5; ++i) k *= panel(k).length_factor(1e-10);
    CHECK(panel(k).error() <= 1e-10);
    CHECK(k > 20);  // 64 nodes resolve some 29 to 1e-13
  }
}

TEST_CASE("samples far from t = 0 are corrected for the rounding of their times") {
  // The times are rounded to 6e-8; uncorrected, that would be the error.
  const auto f = [](double t) { return Vector(std::cos(t - 1e9), std::sin(t - 1e9), 0); };
  const Panel panel = Panel::of(f, 1e9, 1e9 + 10);
  // In the middle, at an exact time; 64 terms and their slopes' rounding.
  const double off = (panel.at(0) - f(1e9 + 5)).norm();
  CAPTURE(off / kUnit);
  CHECK(off < 1e-13);
  CHECK(static_cast<double>(panel.integral(1).x()) ==
        Approx(std::sin(10.0)).epsilon(0).margin(1e-12));
}

TEST_CASE("panels of constant, huge and tiny functions") {
  for (const double size : {0.0, 5e-324, 1e-300, 1.0, 1e8, 1e300}) {
    const Vector value(size, -size, size / 2);
    const Panel panel = Panel::of([&](double) { return value; }, 2, 5);
    CHECK(panel.is_constant());
    CHECK(panel.error() == 0);
    CHECK(panel.at(0.3) == value);
    CHECK(panel.integral(1) == ExtendedVector(value.cast<Extended>() * 3));
    CHECK(panel.length_factor(0) == 16);
  }
  const Panel wave = Panel::of([](double t) { return Vector(1e-300 * std::cos(t), 0, 0); }, 0, 1);
  CHECK(!wave.is_constant());
  CHECK(wave.error() <= 1e-315);
  CHECK(wave.at(0).x() == Approx(1e-300 * std::cos(0.5)).epsilon(1e-14));
}
