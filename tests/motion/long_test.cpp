// Crossings of motions too long to be followed: turning and periodic omega know where to look.
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "catch.hpp"
#include "motions.hpp"
#include "spin/models.hpp"

namespace {

using namespace rotor;
using namespace rotor::motions;

constexpr double kPi = std::numbers::pi;
constexpr double kRate = 2 * kPi / 40;

AngularVelocity p15() {
  return {[](double t) { return Vector(std::cos(kRate * t), std::sin(kRate * t), 0); }};
}
AngularVelocity turning() {
  return {std::make_shared<const TurningSpin>(Vector(1, 0, 0), Vector(0, 0, 1), kRate)};
}
AngularVelocity periodic() { return {std::make_shared<const PeriodicSpin>(40, p15())}; }

Run run_of(const AngularVelocity& omega, double t1, const Rotation& from, double tolerance) {
  return evolve(scene(omega, 0, t1), from, {}, {}, tolerance);
}

}  // namespace

TEST_CASE("turning and periodic omega find the crossings that the whole way has") {
  for (const Rotation& from :
       {Rotation(), Rotation(Vector(1, 1, 1), 1), Rotation(Vector(1, 0, 0.3), 2 * kPi)}) {
    for (const double t1 : {4200.0, -3000.0, 30.0}) {
      for (const double tolerance : {0.05, 0.005}) {
        const Run whole = run_of(p15(), t1, from, tolerance);
        for (const AngularVelocity& omega : {turning(), periodic()}) {
          const Run run = run_of(omega, t1, from, tolerance);
          const auto list = run.crossings();
          const auto all = whole.crossings();
          CAPTURE(from.angle(), t1, tolerance);
          REQUIRE(list.size() == all.size());
          for (std::size_t i = 0; i < all.size(); ++i) {
            CHECK(std::abs(list[i].t - all[i].t) < 1e-6);
            CHECK(list[i].kind == all[i].kind);
            CHECK(list[i].turn_after == all[i].turn_after);
          }
          CHECK(std::abs(run(t1).angle - whole(t1).angle) < 1e-9);
        }
      }
    }
  }
}

TEST_CASE("a periodic run that ends on a crossing, or just after it, ends") {
  for (const double periods : {1.0, 2.0, 4.0}) {
    for (const double beyond : {0.0, 1e-14, 1e-12, 1e-9}) {
      const AngularVelocity omega(std::make_shared<const PeriodicSpin>(
          2.5, AngularVelocity([](double t) { return Vector(std::cos(t), 1, std::sin(t)); })));
      const double t1 = 2.5 * periods;
      const Run there = evolve(scene(omega, 0, t1), Rotation());
      for (const std::optional<double>& tolerance : {std::optional<double>(), {0.1}}) {
        const Run run =
            evolve(scene(omega, 0, t1 + beyond), there(t1).rotation().inverse(), {}, {}, tolerance);
        CAPTURE(periods, beyond);
        CHECK_NOTHROW(run.crossings());
        CHECK(std::abs(std::remainder(run(t1).angle, 2 * kPi)) < 1e-12);
      }
    }
  }
}

TEST_CASE("axis and angle are known at t = 1e9 too, and fit the quaternion") {
  // In M0 = cos(theta/2) the turns are counted modulo two.
  for (const AngularVelocity& omega : {turning(), periodic()}) {
    for (const Rotation& from : {Rotation(), Rotation(Vector(1, 1, 1), 1)}) {
      const Run run = evolve(scene(omega, 0, 1e9), from);
      for (const double t : {1e3, 1e6, 1e9}) {
        const State state = run(t);
        CAPTURE(t, state.angle);
        const double half = state.angle / 2;
        CHECK(std::abs(std::cos(half) - state.quaternion.w()) < 1e-13);
        CHECK((state.axis * std::sin(half) - state.quaternion.vec()).norm() < 1e-13);
      }
    }
  }
}
