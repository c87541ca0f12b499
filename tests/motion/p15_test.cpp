// [P15] from E0 = (1, 1, 1)/sqrt 3: the values of E worked out with 50 digits, and the range of
// theta.
#include <cmath>
#include <numbers>

#include "catch.hpp"
#include "motions.hpp"

namespace {

using namespace rotor;
using namespace rotor::motions;

Run run_of(double period, double t1, double accuracy) {
  const double a = 2 * std::numbers::pi / period;
  const AngularVelocity omega(
      [a](double t) { return Vector(std::cos(a * t), std::sin(a * t), 0); });
  return evolve(scene(omega, 0, t1, accuracy), from_euler_vector(Vector(1, 1, 1) / std::sqrt(3)));
}

// E moves by at most theta/2 / sin(theta/2) of the rotation error, 8 for theta up to 5.6; the
// values have ten places.
void check_euler(const Run& run, double t, const Vector& e) {
  CAPTURE(t);
  CHECK((run(t).euler_vector() - e).norm() <= 8 * rotation_tolerance(run, 6) + 1e-10);
}

}  // namespace

TEST_CASE("the Euler vectors of P15 with T = 40") {
  const Run run = run_of(40, 4200, 1e-10);
  CHECK(run.propagator().error_estimate < 1e-9);
  check_euler(run, 10, Vector(-2.0714505365, -0.6623446028, 0.8668860171));
  check_euler(run, 40, Vector(-2.8341103375, 0.7904096874, -0.5504492928));
  check_euler(run, 4200, Vector(-1.6030497286, 0.9435684906, 0.0014697065));
  CHECK(run.crossings().empty());
  double least = 10, greatest = 0;
  for (const double t : times(0, 4200, 20000)) {
    least = std::min(least, run(t).angle);
    greatest = std::max(greatest, run(t).angle);
  }
  CHECK(least > 0.706988 - 1e-6);
  CHECK(greatest < 5.576197 + 1e-6);
}

TEST_CASE("the Euler vector of P15 with T = 40 at t = 42000") {
  check_euler(run_of(40, 42000, 1e-8), 42000, Vector(3.2463931764, -1.0141401422, 0.5620063052));
}

TEST_CASE("the Euler vectors of P15 with T = pi") {
  const Run run = run_of(std::numbers::pi, 400, 1e-11);
  check_euler(run, 10, Vector(1.8446923032, -0.0890832420, -1.5802434991));
  check_euler(run, 400, Vector(-3.3264353962, -2.9577275102, -1.1164568471));
  for (const double t : times(0, 400, 5000)) {
    CHECK(run(t).angle > 0.766051 - 1e-6);
    CHECK(run(t).angle < 5.517134 + 1e-6);
  }
}
