// Where a run begins: any angle, and the state there is the start itself.
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "catch.hpp"
#include "motions.hpp"
#include "rotation/text.hpp"

namespace {

using namespace rotor;
using namespace rotor::motions;
using Catch::Matchers::Contains;

constexpr double kPi = std::numbers::pi;
const std::vector<double> kAngles = {
    5e-324,  1e-300,   -1e-300, 1e-17, 1e-8, -1e-8, 1,    -1,   kPi,   -kPi, 2 * kPi - 1e-9,
    2 * kPi, -2 * kPi, 4 * kPi, 7,     -7,   1e6,   -1e6, 1e15, -1e15, 1e22};

}  // namespace

TEST_CASE("the state at t0 is exactly the start") {
  for (const double theta0 : kAngles) {
    const Rotation from(Vector(1, 2, -3), theta0);
    for (const Vector& rate : {Vector(0, 0, 1), Vector(from.axis()), Vector(-from.axis())}) {
      for (const bool function : {false, true}) {
        for (const double t1 : {1.0, -1.0, 0.0}) {
          const Run run =
              evolve(scene(function ? as_function(rate) : AngularVelocity(rate), 0, t1), from);
          CAPTURE(theta0, function, t1);
          CHECK(run(0).angle == theta0);
          CHECK(run(0).axis == from.axis());
          CHECK((run(0).quaternion.coeffs() - from.quaternion().coeffs()).norm() < 4 * kEpsilon);
        }
      }
    }
  }
}

TEST_CASE("from any angle the angle counts on along the axis, and the axis stays") {
  for (const double theta0 : kAngles) {
    const Rotation from(Vector(0, 0.6, -0.8), theta0);
    for (const double sense : {1.0, -1.0}) {
      const Vector rate = sense * from.axis();
      for (const bool function : {false, true}) {
        const Run run =
            evolve(scene(function ? as_function(rate) : AngularVelocity(rate), 0, 0.5), from);
        for (const double t : {0.125, 0.5}) {
          CAPTURE(theta0, sense, function, t, run(t).axis.transpose());
          const double angle = theta0 + sense * t;
          // The angle may be between two doubles.
          if (std::abs(theta0) < kEpsilon) {
            // On which side of zero the run begins is below its error, E is the same.
            CHECK((run(t).euler_vector() - angle * from.axis()).norm() <=
                  rotation_tolerance(run, 1));
            continue;
          }
          CHECK(std::abs(run(t).angle - angle) <= rotation_tolerance(run, angle));
          CHECK((run(t).axis - from.axis()).norm() < 1e-9);  // the error / sin(0.06)
        }
      }
    }
  }
}

TEST_CASE("from the identity a constant and the same function agree, whatever axis it was given") {
  for (const Vector& axis : {Vector(0, 0, 1), Vector(0, 0, -1), Vector(1, 0, 0)}) {
    const Rotation from(axis, 0);
    const Run constant = evolve(scene(Vector(0, 0, 1), 0, 1), from);
    const Run function = evolve(scene(as_function(Vector(0, 0, 1)), 0, 1), from);
    for (const double t : {0.0, 0.5, 1.0}) {
      INFO("axis " << axis.transpose() << "  t " << t);
      CHECK(constant(t).angle == Approx(function(t).angle).epsilon(0).margin(1e-10));
      CHECK((constant(t).axis - function(t).axis).norm() < 1e-9);
      CHECK((constant(t).euler_vector() - Vector(0, 0, t)).norm() < 1e-15);
    }
  }
}

TEST_CASE("the parity of the turns is in the quaternion") {
  for (const double theta0 : kAngles) {
    const Rotation from(Vector(1, 2, -3), theta0);
    const Run run = evolve(scene(as_function(Vector(0.2, -0.3, 1)), 0, 3), from);
    const Quaternion turned = run.propagator()(3) * from.quaternion();
    CAPTURE(theta0);
    CHECK((run(3).quaternion.coeffs() - turned.coeffs()).norm() < 4 * kEpsilon);
    if (std::abs(theta0) > 1e9) continue;  // sin of a half angle rounded to double means nothing
    const Quaternion read = run(3).rotation().quaternion();
    CHECK((read.coeffs() - turned.coeffs()).norm() < 4 * kEpsilon * (1 + std::abs(theta0)));
  }
}

TEST_CASE("a run of no length is its start, and nothing else") {
  const Rotation from(Vector(1, 2, 3), 7);
  for (const AngularVelocity& omega :
       {AngularVelocity(Vector(0, 0, 1)), as_function(Vector(0, 0, 1))}) {
    const Run run = evolve(scene(omega, 2, 2), from);
    CHECK(run.complete());
    CHECK(run(2).rotation() == from);
    CHECK(run.crossings().empty());
    CHECK_THROWS_AS(run(2.5), std::out_of_range);
  }
}

TEST_CASE("outside the run there is no state, and the message gives t and the run") {
  for (const double t1 : {10.0, -10.0}) {
    const Run run = evolve(scene(as_function(Vector(0, 0, 1)), 0, t1), Rotation());
    for (const double t : {t1 * 1.0000001, -t1, std::nan("")}) {
      CHECK_THROWS_AS(run(t), std::out_of_range);
      CHECK_THROWS_WITH(run(t), Contains("t = " + text(t)) && Contains("0.0 .. " + text(t1)));
    }
    CHECK_NOTHROW(run(t1));
  }
}

TEST_CASE("a run that was stopped is a run up to there") {
  const Rotation from(Vector(1, 0, 0), 1);
  const Run run =
      evolve(scene(as_function(Vector(0, 0, 1)), 0, 100), from, [](double t) { return t < 20; });
  CHECK(!run.complete());
  CHECK(run.t1() >= 20);
  CHECK(run.t1() < 100);
  CHECK_NOTHROW(run(run.t1()));
  CHECK_THROWS_AS(run(100), std::out_of_range);
}

TEST_CASE("where omega fails at its first call the start is left, and can be read") {
  const AngularVelocity omega([](double) -> Vector { throw std::runtime_error("line 2"); });
  for (const Rotation& from : {Rotation(), Rotation(Vector(1, 2, 3), 1)}) {
    const Run run = evolve(scene(omega, 0, 1), from);
    CHECK(!run.complete());
    CHECK(run.t1() == 0);
    REQUIRE_NOTHROW(run(0));
    CHECK(run(0).rotation() == from);
  }
}
