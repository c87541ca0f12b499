#include "dynamics/section.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "catch.hpp"

namespace {

using namespace rotor;

constexpr double kPi = std::numbers::pi;

Run turn(double t0, double t1) {
  return evolve({AngularVelocity(Vector(0, 0, 1)), t0, t1}, Rotation(Vector(1, 0, 0), 1));
}

}  // namespace

TEST_CASE("a section has the zeros of f in the order of the motion, to the rounding of t") {
  const auto f = [](double t) { return std::sin(t) - 0.5; };
  const std::vector<double> up{kPi / 6, kPi / 6 + 2 * kPi, kPi / 6 + 4 * kPi};
  const std::vector<double> down{5 * kPi / 6, 5 * kPi / 6 + 2 * kPi};
  const auto check = [](const std::vector<double>& zeros, const std::vector<double>& known) {
    REQUIRE(zeros.size() == known.size());
    for (std::size_t i = 0; i < known.size(); ++i) {
      CHECK(std::abs(zeros[i] - known[i]) <= 2e-15);  // an ulp of t, and of the sine over its slope
    }
  };
  const Run run = turn(0, 15);
  check(section(run, f, Direction::kUp), up);
  check(section(run, f, Direction::kDown), down);
  CHECK(section(run, f, Direction::kBoth).size() == 5);
  // Backward what rose falls.
  check(section(turn(15, 0), f, Direction::kDown), {up.rbegin(), up.rend()});
  CHECK(section(turn(15, 0), f, Direction::kUp).size() == 2);
}

TEST_CASE("no zero where f jumps over it, touches it, is NaN, or starts on it") {
  const Run run = turn(0, 10);
  CHECK(section(
            run, [](double t) { return std::tan(t / 2); }, Direction::kDown)
            .empty());
  CHECK(section(
            run, [](double t) { return std::tan(t / 2); }, Direction::kUp)
            .size() == 1);
  CHECK(section(
            run, [](double t) { return t < 5 ? -1.0 : 1.0; }, Direction::kBoth)
            .empty());
  CHECK(section(
            run, [](double t) { return (t - 5) * (t - 5) + 1e-9; }, Direction::kBoth)
            .empty());
  CHECK(section(
            run, [](double t) { return t; }, Direction::kBoth)
            .empty());
  CHECK(section(
            run, [](double t) { return t < 9 ? std::nan("") : t; }, Direction::kBoth)
            .empty());
  CHECK_THROWS_WITH(section(
                        run, [](double) { return std::nan(""); }, Direction::kBoth),
                    Catch::Matchers::Contains("nan at all"));
  CHECK(section(
            run, [](double) { return 0.0; }, Direction::kBoth)
            .empty());
}

TEST_CASE("steep and flat zeros are found to the rounding of f") {
  const Run run = turn(0, 10);
  for (const double place : {1e-3, 1.0, 3.3, 9.99}) {
    CAPTURE(place);
    for (const int power : {1, 3, 5}) {
      const auto zeros = section(
          run, [&](double t) { return std::pow(t - place, power); }, Direction::kBoth);
      REQUIRE(zeros.size() == 1);
      CHECK(std::abs(zeros[0] - place) <= 4e-16 * place);  // two ulps
    }
    const auto steep = section(
        run, [&](double t) { return std::atan(1e9 * (t - place)); }, Direction::kBoth);
    REQUIRE(steep.size() == 1);
    CHECK(std::abs(steep[0] - place) <= 4e-16 * place);
  }
}

TEST_CASE("two zeros between two looks are found where f comes near and goes back") {
  const Run run = turn(0, 10);  // looked at every 0.6 or so
  for (const double depth : {1e-9, 1e-4, 1e-2}) {
    for (const double middle : {3.3, 5.0, 7.123}) {
      CAPTURE(depth, middle);
      const auto dip = [=](double t) {
        const double s = std::sin((t - middle) / 4);
        return 16 * s * s - depth;
      };
      // f is rounded by some 1e-16 of (t - middle)^2 and depth, its slope is 2 sqrt(depth).
      const double half = 4 * std::asin(std::sqrt(depth) / 4);
      const double known = 4e-15 + 1e-15 * depth / std::sqrt(depth);
      const auto both = section(run, dip, Direction::kBoth);
      REQUIRE(both.size() == 2);
      CHECK(std::abs(both[0] - (middle - half)) <= known);
      CHECK(std::abs(both[1] - (middle + half)) <= known);
      CHECK(section(run, dip, Direction::kDown) == std::vector{both[0]});
      CHECK(section(run, dip, Direction::kUp) == std::vector{both[1]});
      const auto hill = [=](double t) { return -dip(t); };
      CHECK(section(run, hill, Direction::kUp) == std::vector{both[0]});
      CHECK(section(
                run, [=](double t) { return dip(t) + 2 * depth; }, Direction::kBoth)
                .empty());
    }
  }
}

TEST_CASE("as many looks as are asked for") {
  const auto fast = [](double t) { return std::sin(200 * t + 0.1); };
  const Run run = turn(0, 1);
  CHECK(section(run, fast, Direction::kBoth, 1000).size() == 63);
  CHECK_THROWS_WITH(section(run, fast, Direction::kBoth, 1), Catch::Matchers::Contains("got 1"));
}
