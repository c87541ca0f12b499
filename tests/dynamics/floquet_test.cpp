#include "dynamics/floquet.hpp"

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "catch.hpp"
#include "spin/models.hpp"

namespace {

using namespace rotor;
using Catch::Matchers::Contains;

constexpr double kTwoPi = 2 * std::numbers::pi;
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

AngularVelocity turning(double alpha) {
  return {std::make_shared<TurningSpin>(Vector(1, 0, 0), Vector(0, 0, 1), alpha)};
}

}  // namespace

TEST_CASE(
    "[P15] has the Floquet frequency (Omega - alpha)/(4 pi), and of it the part of theory 4.4") {
  for (const double alpha : {kTwoPi / 40, 2.0, 0.75, -0.3, 30.0}) {
    const double omega = std::sqrt(1 + alpha * alpha);
    // exp(k alpha t/2) has the parts (1 -+ k c)/2 before exp(+-c alpha t/2), c = (i - alpha k)/
    // Omega: of norm sqrt((1 +- |alpha|/Omega)/2), the slower one the stronger.
    const double slow = (omega - std::abs(alpha)) / (2 * kTwoPi);
    const double period = kTwoPi / std::abs(alpha);
    for (const AngularVelocity& drive : {turning(alpha), turning(alpha).in_body_frame()}) {
      for (const double t1 : {100.0, -100.0}) {
        const Run run = evolve({drive, 0, t1}, Rotation(Vector(1, 1, 1), 1));
        const auto basis = floquet_frequencies(run);
        REQUIRE(basis);
        INFO("alpha " << alpha << " to " << t1);
        CHECK(basis->drive == Approx(1 / period).epsilon(4 * kEpsilon));
        // beta is good to the angle of the run, a few ulp of 2 pi, over 2 pi T.
        CHECK(std::abs(basis->floquet - slow) <=
              (8 * kEpsilon + 2 * run.propagator().error_estimate) / period);
        CHECK(basis->amplitude ==
              Approx(std::sqrt((1 + std::abs(alpha) / omega) / 2)).epsilon(1e-12));
        CHECK(combination(*basis, (omega + std::abs(alpha)) / (2 * kTwoPi), 1e-9)->name() ==
              "drive + f_F");
      }
    }
  }
}

TEST_CASE("a function has them by a period that is given, a periodic model by its own") {
  const double alpha = 0.75;
  const auto function = [=](double t) {
    return Vector(std::cos(alpha * t), std::sin(alpha * t), 0);
  };
  const double slow = (1.25 - alpha) / (2 * kTwoPi);
  const Run run = evolve({AngularVelocity(function), 3, 40}, Rotation());
  CHECK_FALSE(floquet_frequencies(run));
  CHECK(std::abs(floquet_frequencies(run, kTwoPi / alpha).floquet - slow) <=
        run.propagator().error_estimate + 8 * kEpsilon);
  const AngularVelocity periodic(
      std::make_shared<PeriodicSpin>(kTwoPi / alpha, AngularVelocity(function)));
  const Run long_run = evolve({periodic, 3, 40}, Rotation());
  CHECK(std::abs(floquet_frequencies(long_run)->floquet - slow) <=
        run.propagator().error_estimate + 8 * kEpsilon);
  CHECK_FALSE(floquet_frequencies(evolve({periodic, 0, 1}, Rotation())));
  CHECK_THROWS_WITH(floquet_frequencies(run, 0), Contains("positive"));
  CHECK_THROWS_WITH(floquet_frequencies(run, 38), Contains("longer than the run"));
}

TEST_CASE("a constant omega has half its turns as Floquet frequency, and no drive") {
  const Run run = evolve({AngularVelocity(Vector(0, 3, 4)), 0, 1}, Rotation());
  const auto basis = floquet_frequencies(run);
  REQUIRE(basis);
  CHECK(basis->drive == 0);
  CHECK(basis->floquet == Approx(5 / (2 * kTwoPi)).epsilon(2 * kEpsilon));
  CHECK(combination(*basis, 2 * basis->floquet, 1e-9)->name() == "2 f_F");
  CHECK_FALSE(combination(*basis, 2.5 * basis->floquet, 1e-9));
}

TEST_CASE("combinations are the simplest that fit, or none") {
  const FloquetFrequencies basis = {0.1, 0.0618, 1};
  const auto name = [&](int j, int k) {
    const auto found = combination(basis, j * 0.1 + k * 0.0618, 1e-9);
    REQUIRE(found);
    CHECK(found->j == j);
    CHECK(found->k == k);
    CHECK(std::abs(found->difference) <= 4 * kEpsilon);
    return found->name();
  };
  CHECK(name(0, 1) == "f_F");
  CHECK(name(1, 0) == "drive");
  CHECK(name(3, 0) == "3 drive");
  CHECK(name(1, -1) == "drive - f_F");
  CHECK(name(-1, 2) == "2 f_F - drive");
  CHECK(name(2, 3) == "2 drive + 3 f_F");
  CHECK_FALSE(combination(basis, 0.05, 1e-9));
  CHECK_FALSE(combination(basis, 0.0618, 0.01));  // anything would fit
  CHECK_FALSE(combination(basis, 0.0618, std::numeric_limits<double>::quiet_NaN()));
}

TEST_CASE("f_F over the drive is (p/q - 1)/2 where alpha = q/sqrt(p^2 - q^2), else no fraction") {
  const auto ratio = [](double alpha) {
    return commensurate(*floquet_frequencies(evolve({turning(alpha), 0, 100}, Rotation())));
  };
  const auto three_quarters = ratio(0.75);  // p = 5, q = 3
  REQUIRE(three_quarters);
  CHECK(three_quarters->numerator == 1);
  CHECK(three_quarters->denominator == 3);
  const auto third = ratio(1 / std::sqrt(3.0));  // 2, 1
  REQUIRE(third);
  CHECK(third->numerator == 1);
  CHECK(third->denominator == 2);
  CHECK_FALSE(ratio(0.75 + 1e-12));
  CHECK_FALSE(ratio(kTwoPi / 40));
  CHECK_FALSE(ratio(2));
  CHECK_FALSE(commensurate(
      *floquet_frequencies(evolve({AngularVelocity(Vector(0, 3, 4)), 0, 1}, Rotation()))));
}
