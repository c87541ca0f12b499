// A constant omega: the closed form against 90-digit numbers (turns.csv, made by make_turns.py).
#include <limits>
#include <string>
#include <vector>

#include "catch.hpp"
#include "closed_forms.hpp"
#include "table.hpp"

namespace {

using namespace rotor;

struct Turn {
  Vector omega;
  double t0, t;
  Quaternion q;
};

std::vector<Turn> turns() {
  std::vector<Turn> result;
  for (reference::Row& row : reference::table("integrate/turns.csv")) {
    const Vector omega = row.vector();
    const double t0 = row.number();
    const double t = row.number();
    result.push_back({omega, t0, t, row.quaternion()});
  }
  return result;
}

// Twice the distance of the quaternions: the reference is rounded to 4 half ulps of 1 at most.
constexpr double kReference = 2 * std::numeric_limits<double>::epsilon();
double distance_of(const Quaternion& a, const Quaternion& b) {
  return 2 * (a.coeffs() - b.coeffs()).norm();
}

}  // namespace

TEST_CASE("a constant omega is exact to the error that is stated, at every size and time") {
  const std::vector<Turn> all = turns();
  REQUIRE(all.size() >= 30);
  for (const Turn& turn : all) {
    INFO("omega " << turn.omega.transpose() << "  t0 " << turn.t0 << "  t " << turn.t);
    const Propagator run = propagate(closed_form::scene(turn.omega, turn.t0, turn.t));
    CHECK(run.method == "exact");
    CHECK(distance_of(run(turn.t), turn.q) <= run.error_estimate + kReference);
    CHECK(run(turn.t0).coeffs() == Eigen::Vector4d(0, 0, 0, 1));
    CHECK(std::abs(run(turn.t).norm() - 1) < 1e-15);
    CHECK(run.cost.omega_calls == 0);
    CHECK(run.cost.steps == 0);
    CHECK(!run.stop);
  }
}

TEST_CASE("the stated error of a constant omega is rounding, as long as the angle has digits") {
  // An angle of 1e9 known to 64 bits: 1e9 * 2^-62, and some ulps of 1.
  CHECK(propagate(closed_form::scene(Vector(0, 0, 1), 0, 1e9)).error_estimate < 1e-9);
  CHECK(propagate(closed_form::scene(Vector(0, 0, 1), 0, 1)).error_estimate < 1e-15);
  CHECK(propagate(closed_form::scene(Vector(1e300, 0, 0), 0, 1)).error_estimate > 3);
}

TEST_CASE("a direction that is representable loses nothing even over 1e9 and 1e300 radians") {
  // Here the angle is exact in 64 bits, and its sine is reduced with all the digits of pi.
  for (const Turn& turn : turns()) {
    if ((turn.omega.array() != 0).count() != 1 || turn.t0 != 0) continue;
    INFO("omega " << turn.omega.transpose() << "  t " << turn.t);
    CHECK(distance_of(propagate(closed_form::scene(turn.omega, 0, turn.t))(turn.t), turn.q) <=
          2 * kReference);
  }
}

TEST_CASE(
    "methods that step agree with the closed form on a constant omega, within their estimate") {
  const Vector omega(0.3, -1.1, 0.7);
  const auto truth = [&](double t) { return closed_form::turn(omega.cast<Extended>() * t); };
  const AngularVelocity function([&](double) { return omega; });
  for (const double end : {30.0, -30.0}) {
    for (const AngularVelocity& driven : {AngularVelocity(omega), function}) {
      Scene adaptive = closed_form::to_accuracy(1e-9, closed_form::scene(driven, 0, end));
      adaptive.method = Method::kDop853;
      const Propagator by_dop853 = propagate(adaptive);
      CHECK(by_dop853.method == "dop853");
      const double error = closed_form::greatest_error(by_dop853, truth);
      CAPTURE(end, error, by_dop853.error_estimate);
      CHECK(error <= 1e-9);
      CHECK(by_dop853.error_estimate >= 0.8 * error);

      const Propagator by_rk4 = propagate(closed_form::by_rk4(0.05, adaptive));
      const double error4 = closed_form::greatest_error(by_rk4, truth);
      CAPTURE(error4, by_rk4.error_estimate);
      CHECK(by_rk4.error_estimate == Approx(error4).epsilon(0.1));
    }
  }
}
