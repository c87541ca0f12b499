// omega constant in a uniformly turning frame: the closed form against 50-digit numbers
// (turning.csv, made by make_turning.py), and against integration.
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "catch.hpp"
#include "flows.hpp"
#include "refusal.hpp"
#include "spin/models.hpp"
#include "table.hpp"

namespace {

using namespace rotor;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

struct Case {
  Vector v, about;
  double rate, t0, t;
  Quaternion q;
};

std::vector<Case> cases() {
  std::vector<Case> result;
  for (reference::Row& row : reference::table("integrate/turning.csv")) {
    const Vector v = row.vector();
    const Vector about = row.vector();
    const double rate = row.number();
    const double t0 = row.number();
    const double t = row.number();
    result.push_back({v, about, rate, t0, t, row.quaternion()});
  }
  return result;
}

AngularVelocity turning(const Vector& v, const Vector& about, double rate,
                        Frame frame = Frame::kSpace) {
  return {std::make_shared<const TurningSpin>(v, about, rate), frame};
}

}  // namespace

TEST_CASE("omega in a turning frame is exact to the error stated, at every rate and time") {
  const std::vector<Case> all = cases();
  REQUIRE(all.size() == 375);
  for (const Case& c : all) {
    INFO("v " << c.v.transpose() << "  about " << c.about.transpose() << "  rate " << c.rate
              << "  t0 " << c.t0 << "  t " << c.t);
    const Propagator run = propagate(flows::scene(turning(c.v, c.about, c.rate), c.t0, c.t));
    CHECK(run.method == "exact");
    CHECK(run.t1 == c.t);
    CHECK(run.accuracy == 0);
    CHECK(run.cost.omega_calls == 0);
    // The reference is rounded to half an ulp in each component, the angle twice that.
    const double error = flows::angle_between(run.flow->at(c.t), c.q);
    CHECK(error <= run.error_estimate + kEpsilon);
    CHECK(std::abs(run.flow->at(c.t).norm() - 1) < 4 * kEpsilon);
    CHECK(flows::angle_between(run.flow->at(c.t0), Quaternion::Identity()) <= 2 * kEpsilon);
    // -omega in the space frame is omega in the body frame, as generators, about the same axis.
    const auto body = flows::scene(turning(-c.v, c.about, c.rate, Frame::kBody), c.t0, c.t);
    const Propagator in_body = propagate(body);
    CHECK(in_body.flow->at(c.t).coeffs() == run.flow->at(c.t).coeffs());
    CHECK(in_body.frame == Frame::kBody);
  }
}

TEST_CASE("the error stated of a turning omega is rounding, as long as its angle has digits") {
  const auto stated = [](double rate, double t0, double t) {
    return propagate(flows::scene(turning({1, 0, 0}, {0, 0, 1}, rate), t0, t)).error_estimate;
  };
  CHECK(stated(0.157, 0, 1) < 2e-15);
  CHECK(stated(0.157, 1e9, 1e9 + 1) < 2e-15);  // the frame's own angles are exact
  CHECK(stated(0.157, 0, 1e9) < 1e-9);         // 1.2e9 rad to 64 bits, 4 roundings
  CHECK(stated(1e300, 0, 1) > 3);
}

TEST_CASE("omega in a turning frame agrees with its integration, both ways and in both frames") {
  for (const Frame frame : {Frame::kSpace, Frame::kBody}) {
    flows::check_against_dop853(flows::scene(turning({1, 0, 0}, {0, 0, 1}, 0.157, frame), 0, 300),
                                1e-10);
    flows::check_against_dop853(
        flows::scene(turning({0.3, -0.2, 1.1}, {1, 2, 2}, -1.3, frame), 5, -40), 1e-10);
    // There omega itself is rounded by the rounding of its argument, 1e9 * 2^-53.
    flows::check_against_dop853(
        flows::scene(turning({1, 0, 0.5}, {0, 1, 0}, 1, frame), 1e9, 1e9 + 20), 1e-6);
  }
}

TEST_CASE("the generator and the mesh of a turning omega fit its motion") {
  for (const Frame frame : {Frame::kSpace, Frame::kBody}) {
    const AngularVelocity omega = turning({0.3, -0.2, 1.1}, {1, 2, 2}, -1.3, frame);
    const Propagator run = propagate(flows::scene(omega, -3, 50));
    for (const double t : flows::times(-3, 50)) {
      if (t > -3 && t < 50) flows::check_generator(*run.flow, t, 3);
      const double sign = frame == Frame::kSpace ? 1 : -1;
      // omega is computed in double: of a few roundings, one of an argument of up to 65 rad.
      CHECK((run.flow->generator(t) - sign * omega(t)).norm() <= 80 * kEpsilon);
    }
    flows::check_mesh(*run.flow, -3, 50);
    flows::check_mesh(*propagate(flows::scene(omega, 50, -3)).flow, 50, -3);
  }
  const Propagator still = propagate(flows::scene(turning({0, 0, 0}, {0, 0, 1}, 1e6), 0, 1e9));
  CHECK(still.flow->mesh() == std::vector<double>{0, 1e9});
  CHECK(still.flow->at(12345).coeffs() == Eigen::Vector4d(0, 0, 0, 1));
  CHECK(still.error_estimate < 1e-3);
  const Propagator far = propagate(flows::scene(turning({1, 0, 0}, {0, 0, 1}, 1), 0, 1e9));
  CHECK_THROWS_AS(far.flow->mesh(), std::length_error);
}

TEST_CASE("what a turning omega can reach is told, and nothing that it does reach is denied") {
  std::mt19937 random(20251);
  std::normal_distribution<double> normal;
  const auto vector = [&] { return Vector(normal(random), normal(random), normal(random)); };
  int denied = 0;
  for (int i = 0; i < 200; ++i) {
    CAPTURE(i);
    const double rate = i % 5 == 0 ? 0 : normal(random);
    const Vector k = vector();
    const Vector v = i % 7 == 0 ? Vector(k.normalized() * normal(random)) : vector();
    const Propagator run = propagate(flows::scene(turning(v, k, rate), 0.5, 60));
    // A place on the way, and one at a known distance from that.
    const Quaternion there = run.flow->at(0.5 + 59.5 * i / 200);
    CHECK(!run.flow->approaches(there, 1e-15).empty());
    CHECK(!run.flow->approaches(Quaternion(-there.coeffs()), 1e-15).empty());
    const Quaternion aim =
        Quaternion(normal(random), normal(random), normal(random), normal(random)).normalized();
    double nearest = 2;
    for (const double t : flows::times(0.5, 60)) {
      const Eigen::Vector4d u = run.flow->at(t).coeffs();
      nearest = std::min({nearest, (u - aim.coeffs()).norm(), (u + aim.coeffs()).norm()});
    }
    CHECK(!run.flow->approaches(aim, nearest + 1e-15).empty());
    if (run.flow->approaches(aim, 1e-12).empty()) ++denied;
  }
  // A surface in a space of three dimensions: a place at random is not on it.
  CHECK(denied == 200);
}

TEST_CASE("an angle that overflows is refused") {
  refused(
      [] {
        propagate(flows::scene(turning({1e300, 0, 0}, {0, 0, 1}, 1), 0, 1e9));
      },
      {"too large"});
  refused(
      [] {
        propagate(flows::scene(turning({1, 0, 0}, {0, 0, 1}, 1e300), -1e9, 0));
      },
      {"too large"});
}
