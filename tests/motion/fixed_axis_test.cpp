// Motions about one direction: the axis stays, the angle counts on.
#include <cmath>
#include <numbers>

#include "catch.hpp"
#include "motions.hpp"

namespace {

using namespace rotor;
using namespace rotor::motions;

constexpr double kPi = std::numbers::pi;

}  // namespace

TEST_CASE("with a constant omega along the axis the angle counts on, and back, without limit") {
  for (const Vector& n : {Vector(0, 0, 1), Vector(1, 2, -2), Vector(0.1, -0.7, 0.3)}) {
    for (const double theta0 : {0.5, -0.5, 7.0, 1e-300, -3 * kPi, 1e6}) {
      for (const double rate : {1.0, -1.0, 3.5, -1e-8}) {
        const Rotation from(n, theta0);
        const Run run = evolve(scene(Vector(from.axis() * rate), -10, 1e9), from);
        for (const double t : {-10.0, -9.0, 0.0, 10.0, 1e4, 123456789.0, 1e9}) {
          CAPTURE(theta0, rate, t);
          const State state = run(t);
          const double angle = theta0 + rate * (t + 10);
          // The unit axis and its multiple are rounded: rate by an ulp or two.
          CHECK(std::abs(state.angle - angle) <=
                3 * kEpsilon * (std::abs(rate) * (t + 10) + std::abs(theta0)));
          CHECK(state.axis == from.axis());
        }
        CHECK(run(-10).angle == theta0);
      }
    }
  }
}

TEST_CASE("backward in time the angle counts down through zero") {
  const Run run = evolve(scene(Vector(0, 0, 2), 0, -1e9), Rotation(Vector(0, 0, 1), 1));
  CHECK(run(-0.5).angle == 0);
  CHECK(run(-100).angle == -199);
  CHECK(run(-1e9).angle == 1 - 2e9);
  CHECK(run(-1e9).axis == Vector(0, 0, 1));
}

TEST_CASE("from the identity the body turns about omega, whatever it is") {
  for (const Vector& omega : {Vector(1, -2, 2), Vector(1e-300, 0, 0), Vector(0, 3e8, 4e8)}) {
    for (const bool function : {false, true}) {
      const double end = 5 / norm(omega);
      const Run run =
          evolve(scene(function ? as_function(omega) : AngularVelocity(omega), 0, end), Rotation());
      for (const double t : times(0, end, 20)) {
        CHECK(run(t).angle ==
              Approx(norm(omega) * t).epsilon(0).margin(rotation_tolerance(run, 5)));
        if (t > 0)
          CHECK((run(t).axis - unit(omega)).norm() <= axis_tolerance(run, norm(omega) * t));
      }
      CHECK((run(0).axis - unit(omega)).norm() < 4 * kEpsilon);
    }
  }
}

TEST_CASE("without omega nothing moves") {
  for (const Rotation& from : {Rotation(Vector(0, 0, 1), 2 * kPi), Rotation(Vector(1, 2, 3), 7),
                               Rotation(Vector(0, 1, 0), -1)}) {
    for (const bool function : {false, true}) {
      const Run run = evolve(
          scene(function ? as_function(Vector::Zero()) : AngularVelocity(Vector(0, 0, 0)), 0, 1e9),
          from);
      CHECK(run.crossings().empty());
      for (const double t : {0.0, 1.0, 1e9}) {
        CAPTURE(function, t);
        CHECK(run(t).angle == Approx(from.angle()).epsilon(0).margin(4 * kEpsilon));
        CHECK((run(t).axis - from.axis()).norm() <= 4 * kEpsilon);
      }
    }
  }
}

TEST_CASE("the crossings about a fixed axis are the multiples of 2 pi between the ends") {
  const Rotation from(Vector(0, 0, 1), 1);
  const auto check = [&](double rate, double t1, const std::vector<double>& turns) {
    const Run run = evolve(scene(Vector(0, 0, rate), 0, t1), from);
    const std::vector<Crossing> crossings = run.crossings();
    REQUIRE(crossings.size() == turns.size());
    for (std::size_t i = 0; i < turns.size(); ++i) {
      CAPTURE(rate, i);
      CHECK(crossings[i].t == Approx((2 * kPi * turns[i] - 1) / rate).epsilon(1e-15));
      CHECK(crossings[i].kind == Passage::kThrough);
      const bool up = rate * t1 > 0;
      CHECK(crossings[i].turn_before == turns[i] - (up ? 1 : 0));
      CHECK(crossings[i].turn_after == turns[i] - (up ? 0 : 1));
    }
  };
  check(1, 5, {});
  check(1, 20, {1, 2, 3});
  check(-1, 15, {0, -1, -2});
  check(2, -8, {0, -1, -2});
  check(-0.5, -12, {1});
  const Run forever = evolve(scene(Vector(0, 0, 1), 0, 1e9), from);
  CHECK_THROWS_AS(forever.crossings(), std::length_error);
  CHECK_THROWS_WITH(forever.crossings(), Catch::Matchers::Contains("159000000"));  // 1e9 / 2 pi
}

TEST_CASE("a start beside the axis is never turned to the identity, however long the motion") {
  const Rotation from(Vector(1, 0, 0.2), 1);
  const Run run = evolve(scene(Vector(0, 0, 1), 0, 1e9), from);
  CHECK(run.crossings().empty());
  const double t = 1e9;
  const Extended half = Extended{t} / 2;
  const auto truth = Eigen::Quaternion<Extended>(std::cos(half), 0, 0, std::sin(half)) *
                     from.quaternion().cast<Extended>();
  const State state = run(t);
  CHECK(state.angle >= 0);
  CHECK(state.angle <= 2 * std::numbers::pi);
  CHECK(std::abs(std::cos(state.angle) - static_cast<double>(2 * truth.w() * truth.w() - 1)) <
        1e-14);
}

TEST_CASE("a function along a fixed direction swings through zero and keeps its axis") {
  // omega = cos t k from 0.5: theta = 0.5 + sin t, zero at 7 pi/6 and 11 pi/6 and so on.
  const AngularVelocity omega([](double t) { return Vector(0, 0, std::cos(t)); });
  for (const double accuracy : {1e-6, 1e-10}) {
    const Run run = evolve(scene(omega, 0, 20, accuracy), Rotation(Vector(0, 0, 1), 0.5));
    const std::vector<double> expected = {7 * kPi / 6,  11 * kPi / 6, 19 * kPi / 6,
                                          23 * kPi / 6, 31 * kPi / 6, 35 * kPi / 6};
    const std::vector<Crossing> crossings = run.crossings();
    REQUIRE(crossings.size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      // |omega| = cos(pi/6) there: t errs by the angle's error / 0.87.
      CHECK(std::abs(crossings[i].t - expected[i]) <= 1.2 * rotation_tolerance(run, 1));
      CHECK(crossings[i].kind == Passage::kThrough);
      CHECK(crossings[i].turn_before == (i % 2 == 0 ? 0 : -1));
      CHECK(crossings[i].turn_after == (i % 2 == 0 ? -1 : 0));
    }
    for (const double t : times(0, 20, 2000)) {
      const double angle = 0.5 + std::sin(t);
      CAPTURE(accuracy, t);
      CHECK(std::abs(run(t).angle - angle) <= rotation_tolerance(run, angle));
      CHECK((run(t).axis - Vector(0, 0, 1)).norm() <= axis_tolerance(run, angle));
    }
  }
}

TEST_CASE("a constant omega that ends on 2 pi k has not crossed it, whenever it began") {
  const double rate = 292.97346892601416;
  const double t1 = 100.17157008326284;  // 8 turns after 100, to the rounding of t
  const Run run = evolve(scene(Vector(0, 0, rate), 100, t1), Rotation());
  CHECK(run.crossings().size() == 7);
}
