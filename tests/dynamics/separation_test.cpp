#include "dynamics/separation.hpp"

#include <cmath>
#include <numbers>

#include "../motion/motions.hpp"
#include "../rotation/elements.hpp"
#include "catch.hpp"
#include "spin/models.hpp"

namespace {

using namespace rotor;
using namespace rotor::motions;

Vector wandering(double t) { return {std::cos(t * t / 50), 1 + std::sin(t), 0.3 * t - 1}; }

}  // namespace

TEST_CASE("two motions of one omega stay as far apart as they were") {
  reference::Draw draw(63);
  const auto at = times(0, 20, 500);
  for (const Frame frame : {Frame::kSpace, Frame::kBody}) {
    const AngularVelocity omega(std::make_shared<FunctionSpin>(wandering, "wandering"), frame);
    for (int i = 0; i < 5; ++i) {
      const Rotation p = draw.rotation(), q = draw.rotation();
      CAPTURE(i, frame == Frame::kSpace, p.angle(), q.angle());
      const Run a = evolve(scene(omega, 0, 20, 1e-8), p);
      const SeparationChange same = greatest_separation_change(a, a.with_start(q), at);
      CHECK(same.quaternion < 1e-13);
      CHECK(same.rotation < 1e-13);
      // Integrated by another method, on steps of its own: the errors of both, no more.
      Scene other = scene(omega, 0, 20, 1e-6);
      other.method = Method::kDop853;
      const Run b = evolve(other, q);
      const double allowed = rotation_tolerance(a, 0) + rotation_tolerance(b, 0);
      const SeparationChange apart = greatest_separation_change(a, b, at);
      CHECK(apart.quaternion <= allowed);
      CHECK(apart.rotation <= allowed);
    }
  }
}

TEST_CASE("motions of different omegas come apart") {
  const Run a = evolve(scene(Vector(0, 0, 1), 0, 1), Rotation());
  const Run b = evolve(scene(Vector(0, 0, 2), 0, 1), Rotation());
  const SeparationChange change = greatest_separation_change(a, b, times(0, 1, 4));
  CHECK(std::abs(change.rotation - 1) < 1e-15);
  CHECK(std::abs(change.quaternion - 2 * std::sin(0.25)) < 1e-15);
  CHECK_THROWS_AS(greatest_separation_change(a, b, std::vector<double>{0}), std::invalid_argument);
  CHECK_THROWS_AS(greatest_separation_change(a, b, std::vector<double>{0, 2}), std::out_of_range);
}
