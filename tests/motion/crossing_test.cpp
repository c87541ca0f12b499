// Through theta = 2 pi k: found, told apart from a near miss, and continuous.
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "catch.hpp"
#include "motions.hpp"

namespace {

using namespace rotor;
using namespace rotor::motions;

constexpr double kPi = std::numbers::pi;

AngularVelocity function(AngularVelocity::Function f) { return {std::move(f)}; }

// A run that is at the identity, turned by 2 pi turns, at t = 1: the start comes from going back.
Run through_identity(const AngularVelocity& omega, double turns, double t1, double accuracy) {
  const Run back = evolve(scene(omega, 1, 0, 1e-13), Rotation());
  const Rotation at0 = back(0).rotation();
  return evolve(scene(omega, 0, t1, accuracy), Rotation(at0.axis(), at0.angle() + 2 * kPi * turns));
}

}  // namespace

TEST_CASE("Figure 6 of the paper: E(1) of omega = i + t j, and its reverse through 2 pi") {
  const Run there =
      evolve(scene(function([](double t) { return Vector(1, t, 0); }), 0, 1, 1e-13), Rotation());
  const State end = there(1);
  CHECK((end.euler_vector() - Vector(0.995675, 0.499982, -0.084964)).cwiseAbs().maxCoeff() <
        5.1e-7);
  CHECK(end.angle == Approx(1.11739399539503).epsilon(0).margin(2e-13));
  CHECK(there.crossings().empty());

  const Run run =
      evolve(scene(function([](double t) { return Vector(-1, t - 1, 0); }), 0, 60, 1e-11),
             Rotation(-end.axis, 2 * kPi - end.angle));
  const std::vector<Crossing> crossings = run.crossings();
  REQUIRE(crossings.size() == 1);
  CHECK(crossings[0].t == Approx(1).epsilon(0).margin(1e-11));  // |omega| = 1 there
  CHECK(crossings[0].kind == Passage::kThrough);
  CHECK(crossings[0].turn_before == 0);
  CHECK(crossings[0].turn_after == 1);
  // The motion comes back to where it was at 0, a turn on.
  CHECK(run(2).angle == Approx(2 * kPi + end.angle).epsilon(0).margin(1e-10));
  CHECK(run(5).angle == Approx(9.735346).epsilon(0).margin(5.1e-7));
  CHECK(run(10).angle == Approx(10.378385).epsilon(0).margin(5.1e-7));
  double least = 100, greatest = 0;
  for (const double t : times(1 + 1e-6, 60, 20000)) {
    least = std::min(least, run(t).angle);
    greatest = std::max(greatest, run(t).angle);
  }
  CHECK(least > 2 * kPi);
  CHECK(greatest ==
        Approx(11.71399).epsilon(0).margin(5.1e-6 + 1e-4));  // of 3 ms: 1e-5 |omega'| = 1e-4
}

TEST_CASE("axis and angle are continuous through a crossing, at every distance from it") {
  // theta = 2 pi - (t - 1) + O((t-1)^3), n = i + O(t-1): the axis errs by half the error of the
  // rotation over |M|, and where that says nothing (M within the error) it is the limit of Lemma
  // 5.3, the direction of omega.
  for (const double accuracy : {1e-5, 1e-10}) {
    const Run run =
        through_identity(function([](double t) { return Vector(-1, t - 1, 0); }), 1, 2, accuracy);
    REQUIRE(run.crossings().size() == 1);
    const double t1 = run.crossings()[0].t;
    for (double away = 1e-16; away < 0.1; away *= 1.5) {
      for (const double t : {1 - away, 1.0, 1 + away, t1 - away, t1, t1 + away}) {
        const State state = run(t);
        CAPTURE(accuracy, t1, t, state.axis.transpose());
        CHECK(std::abs(state.angle - (2 * kPi - (t - 1))) <=
              std::pow(t - 1, 2) + 2 * rotation_tolerance(run, 2 * kPi));
        const double lost = run.propagator().error_estimate / std::abs(t - 1);
        CHECK((state.axis - Vector(1, 0, 0)).norm() < std::abs(t - 1) + std::min(2 * lost, 0.5));
      }
    }
  }
}

TEST_CASE("a zero of omega of odd order turns the angle back") {
  // omega(1) = 0, omega'(1) = k: M goes as (t - 1)^2 k/4. n is continuous [Lemma 5.3, i = 1].
  const auto omega = function([](double t) { return Vector(0, (t - 1) * (t - 1), t - 1); });
  for (const double turns : {0.0, 1.0, -1.0, 5.0}) {
    for (const double accuracy : {1e-7, 1e-10}) {
      CAPTURE(turns, accuracy);
      const Run run = through_identity(omega, turns, 3, accuracy);
      const std::vector<Crossing> crossings = run.crossings();
      REQUIRE(crossings.size() == 1);
      CHECK(crossings[0].kind == Passage::kBack);
      // At 0 the angle is 2 pi turns + 0.6 about its axis: in the interval `turns`.
      CHECK(crossings[0].turn_before == turns);
      CHECK(crossings[0].turn_after == turns);
      // (t - 1)^2/2 is known to the error of the rotation.
      CHECK(std::abs(crossings[0].t - 1) <= std::sqrt(4 * rotation_tolerance(run, 0)) + 1e-8);
      // The motion is even about t = 1, but for the sign of j.
      for (const double dt : {0.1, 0.3, 0.9}) {
        const State before = run(1 - dt);
        const State after = run(1 + dt);
        CHECK(std::abs(after.angle - before.angle) <= 2 * rotation_tolerance(run, after.angle));
        CHECK(after.angle > 2 * kPi * turns);
        CHECK((after.axis - before.axis.cwiseProduct(Vector(-1, -1, 1))).norm() <=
              2 * axis_tolerance(run, after.angle));
      }
    }
  }
}

TEST_CASE("a zero of omega of even order goes through") {
  // omega = (t - 1)^2 k with a j of the next order: theta - 2 pi goes as (t - 1)^3/3.
  const auto omega =
      function([](double t) { return Vector(0, std::pow(t - 1, 3), (t - 1) * (t - 1)); });
  const Run run = through_identity(omega, 1, 3, 1e-10);
  const std::vector<Crossing> crossings = run.crossings();
  REQUIRE(crossings.size() == 1);
  CHECK(crossings[0].kind == Passage::kThrough);
  CHECK(crossings[0].turn_after - crossings[0].turn_before == -1);  // axis near -k: downward
  CHECK(std::abs(crossings[0].t - 1) <= std::cbrt(6 * rotation_tolerance(run, 0)));
  CHECK(run(3).angle < 2 * kPi);
}

TEST_CASE("a near miss is no crossing: the axis swings round and the angle turns back") {
  // omega = k from an axis a little aside: by Theorem 4.1 theta comes to 2 asin(sqrt(1 - a^2)) of
  // 2 pi and of 0, here 1e-3 and 1e-6.
  for (const double miss : {1e-3, 1e-6}) {
    const double theta0 = 1;
    const double aside = std::asin(std::sin(miss / 2) / std::sin(theta0 / 2));
    const Rotation from(Vector(std::sin(aside), 0, std::cos(aside)), theta0);
    const Run run = evolve(scene(as_function(Vector(0, 0, 1)), 0, 20), from);
    CAPTURE(miss);
    CHECK(run.crossings().empty());
    double greatest = 0, least = 10;
    for (const double t : times(0, 20, 1000)) {
      greatest = std::max(greatest, run(t).angle);
      least = std::min(least, run(t).angle);
    }
    CHECK(least > 0);
    CHECK(greatest < 2 * kPi);
    const double nearest = 2 * kPi - theta0;  // b = theta0/2 to order aside^2
    CHECK(2 * kPi - run(nearest).angle == Approx(miss).epsilon(1e-3));
    CHECK(run(nearest - 0.5).axis.z() > 0.99);
    CHECK(run(nearest + 0.5).axis.z() < -0.99);
  }
}

TEST_CASE("a crossing in the first step or the last is found like any other") {
  for (const double theta0 : {2 * kPi - 1e-9, 2 * kPi - 1e-3, -1e-8, -1e-3, 4 * kPi - 1e-6}) {
    const Run run =
        evolve(scene(as_function(Vector(0, 0, 1)), 0, 0.5), Rotation(Vector(0, 0, 1), theta0));
    const double turn = std::ceil(theta0 / (2 * kPi));
    CAPTURE(theta0, turn);
    const std::vector<Crossing> crossings = run.crossings();
    REQUIRE(crossings.size() == 1);
    CHECK(std::abs(crossings[0].t - (2 * kPi * turn - theta0)) <= rotation_tolerance(run, theta0));
    CHECK(crossings[0].turn_before == turn - 1);
    CHECK(crossings[0].turn_after == turn);
    for (const double t : times(0, 0.5, 50)) {
      CHECK(std::abs(run(t).angle - (theta0 + t)) <= rotation_tolerance(run, theta0 + t));
    }
  }
  for (const double rest : {1e-3, 1e-6, 1e-9}) {
    const double theta0 = 2 * kPi - 0.5 + rest;
    const Run run =
        evolve(scene(as_function(Vector(0, 0, 1)), 0, 0.5), Rotation(Vector(0, 0, 1), theta0));
    CAPTURE(rest);
    CHECK(run.crossings().size() == 1);
    CHECK(std::abs(run(0.5).angle - (theta0 + 0.5)) <= rotation_tolerance(run, 7));
    CHECK(run(0.5).axis.z() > 0.99);
  }
}

TEST_CASE("a run of whole turns from the identity ends with its axis and angle") {
  for (const int turns : {1, 2, 3}) {
    const double end = 2 * kPi * turns;
    for (const AngularVelocity& omega :
         {AngularVelocity(Vector(0, 0, 1)), as_function(Vector(0, 0, 1)),
          function([](double t) { return Vector(0, 0, 1 + std::cos(t)); })}) {
      for (const double accuracy : {1e-6, 1e-10, 1e-13}) {
        const Run run = evolve(scene(omega, 0, end, accuracy), Rotation());
        CAPTURE(turns, accuracy);
        CHECK(std::abs(run(end).angle - end) <= rotation_tolerance(run, end));
        CHECK(run(end).axis.z() > 0.99);
      }
    }
  }
}
