// omega in pieces: the chain of the pieces' motions.
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

#include "catch.hpp"
#include "closed_forms.hpp"
#include "flows.hpp"
#include "spin/models.hpp"

namespace {

using namespace rotor;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

AngularVelocity piecewise(std::vector<double> ends, std::vector<AngularVelocity> pieces,
                          Frame frame = Frame::kSpace) {
  return {std::make_shared<const PiecewiseSpin>(std::move(ends), std::move(pieces)), frame};
}

AngularVelocity function(double scale) {
  return AngularVelocity(
      [scale](double t) { return Vector(scale * std::sin(t), std::cos(scale * t), 0.3); });
}

// One of each kind: constant, turning, along, periodic, function; ends at 1, 3, 4.5 and 9.
AngularVelocity mixture(Frame frame = Frame::kSpace) {
  ScalarFunction rate;
  rate.value = [](double t) { return 1 / (1 + t); };
  rate.name = "rate";
  return piecewise({1, 3, 4.5, 9},
                   {Vector(1, 2, -0.5),
                    {std::make_shared<const TurningSpin>(Vector(1, 0, 0), Vector(0, 0, 1), 1.5)},
                    {std::make_shared<const AlongSpin>(Vector(1, 1, 0), rate)},
                    {std::make_shared<const PeriodicSpin>(1.5, function(2))},
                    function(0.7)},
                   frame);
}

}  // namespace

TEST_CASE("constant pieces are exact, one after the other, both ways") {
  const closed_form::Piecewise known{
      {1, 2.5, 2.75, 40}, {{1, 0, 0}, {0, -2, 1}, {100, 3, 0}, {0, 0, 0}, {0.1, 1, 0.2}}};
  const AngularVelocity omega = piecewise(known.t, {known.value.begin(), known.value.end()});
  const Propagator run = propagate(flows::scene(omega, 0, 60));
  CHECK(run.method == "exact");
  CHECK(run.accuracy == 0);
  CHECK(run.cost.omega_calls == 0);
  CHECK(run.why == "omega in 5 pieces, each by its cheapest method");
  CHECK(run.error_estimate < 1e-14);
  const Propagator back = propagate(flows::scene(omega, 60, 0));
  for (const double t : flows::times(0, 60)) {
    CAPTURE(t);
    CHECK(closed_form::rotation_error(run(t), known(t)) <= run.error_estimate);
    // From 60 to t.
    const auto truth = known(t) * known(60).conjugate();
    CHECK(closed_form::rotation_error(back(t), truth) <= back.error_estimate);
  }
  flows::check_mesh(*run.flow, 0, 60);
  flows::check_mesh(*back.flow, 60, 0);
}

TEST_CASE("pieces of every kind agree with their integration, both ways and in both frames") {
  for (const Frame frame : {Frame::kSpace, Frame::kBody}) {
    for (const auto& [t0, t1] : {std::pair{0.0, 12.0},
                                 {12.0, 0.0},
                                 {-2.0, 0.5},
                                 {1.0, 3.0},
                                 {3.0, 1.0},
                                 {2.0, 2.5},
                                 {4.5, 20.0},
                                 {9.0, 4.0}}) {
      flows::check_against_dop853(flows::scene(mixture(frame), t0, t1), 1e-10);
    }
  }
  const Propagator run = propagate(flows::scene(mixture(), 0, 12, 1e-8));
  CHECK(run.accuracy == 1e-8);
  CHECK(run.method == "exact, fgl");
  CHECK(run.error_estimate <= 1e-8);
  CHECK(propagate(flows::scene(mixture(), 1, 3)).why == "within one piece of omega");
  const Propagator nothing = propagate(flows::scene(mixture(), 3, 3));
  CHECK(nothing.flow->at(3).coeffs() == Eigen::Vector4d(0, 0, 0, 1));
  CHECK(!nothing.stop);
}

TEST_CASE("the generator and the mesh of a piecewise omega fit its motion, from far too") {
  for (const Frame frame : {Frame::kSpace, Frame::kBody}) {
    const Propagator run = propagate(flows::scene(mixture(frame), -1, 12));
    flows::check_mesh(*run.flow, -1, 12);
    for (const double t : flows::times(-0.99, 11.99)) {
      bool beside_a_jump = false;
      for (const double jump : mixture().breaks(-1, 12)) {
        if (std::abs(t - jump) < 1e-4) beside_a_jump = true;
      }
      if (!beside_a_jump) flows::check_generator(*run.flow, t, 5);
    }
  }
  const AngularVelocity far =
      piecewise({1e9 + 1, 1e9 + 2}, {Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1)});
  flows::check_against_dop853(flows::scene(far, 1e9, 1e9 + 3), 1e-10);
  flows::check_against_dop853(flows::scene(far, 1e9 + 3, 1e9), 1e-10);
}

TEST_CASE("thousands of pieces are followed and asked at once") {
  std::mt19937 random(90210);
  std::normal_distribution<double> normal;
  closed_form::Piecewise known;
  for (int i = 1; i <= 5000; ++i) {
    known.t.push_back(i * 0.37);
    known.value.emplace_back(normal(random), normal(random), normal(random));
  }
  known.value.emplace_back(0, 0, 1);
  const Propagator run = propagate(flows::scene(
      piecewise(known.t, {known.value.begin(), known.value.end()}), 0, 0.37 * 5000 + 1));
  CHECK(run.error_estimate < 1e-11);
  CHECK(closed_form::rotation_error(run(run.t1), known(run.t1)) <= run.error_estimate);
  for (const double t : {0.1, 500.3, 1849.9, 1850.0}) {
    CHECK(closed_form::rotation_error(run(t), known(t)) <= run.error_estimate);
  }
  CHECK(run.flow->mesh().size() == 5002);
}

TEST_CASE("what a piecewise omega can reach is told, and nothing that it does reach is denied") {
  std::mt19937 random(5150);
  std::normal_distribution<double> normal;
  const auto turning = [](const Vector& v, double rate) -> AngularVelocity {
    return {std::make_shared<const TurningSpin>(v, Vector(1, 2, 2), rate)};
  };
  const AngularVelocity omega = piecewise(
      {1, 3}, {turning({1, 2, -0.5}, 0.7), turning({1, 0, 0}, 1.5), turning({0, 0.4, 0}, 0)});
  const Propagator run = propagate(flows::scene(omega, 0, 20));
  int denied = 0;
  for (int i = 0; i < 50; ++i) {
    CAPTURE(i);
    CHECK(!run.flow->approaches(run.flow->at(20.0 * i / 50), 1e-14).empty());
    const Quaternion aim =
        Quaternion(normal(random), normal(random), normal(random), normal(random)).normalized();
    if (run.flow->approaches(aim, 1e-12).empty()) ++denied;
  }
  // Three surfaces in a space of three dimensions: a place at random is on none.
  CHECK(denied == 50);
}

TEST_CASE("a piece that fails or is stopped ends the run there, and the part done holds") {
  const AngularVelocity fails([](double t) -> Vector {
    if (t > 2.5) throw std::runtime_error("no omega");
    return Vector(0, 1, t);
  });
  const AngularVelocity omega =
      piecewise({1, 2, 4}, {Vector(1, 0, 0), function(1), fails, function(1)});
  const Propagator run = propagate(flows::scene(omega, 0, 10));
  REQUIRE(run.stop);
  CHECK(run.stop->reason == "omega failed");
  CHECK(run.stop->message == "no omega");
  CHECK(run.stop->cause);
  CHECK(run.t1 == run.stop->t);
  CHECK(run.t1 > 2);
  CHECK(run.t1 <= 2.5);
  flows::check_mesh(*run.flow, 0, run.t1);
  const Propagator part = propagate(flows::scene(omega, 0, run.t1));
  REQUIRE(!part.stop);
  CHECK(flows::angle_between(run.flow->at(run.t1), part.flow->at(run.t1)) <=
        run.error_estimate + part.error_estimate);

  // Backward the piece that fails comes at once.
  const Propagator back = propagate(flows::scene(omega, 3, 0));
  REQUIRE(back.stop);
  CHECK(back.t1 == 3);
  CHECK(back.flow->at(3).coeffs() == Eigen::Vector4d(0, 0, 0, 1));

  Scene few = flows::scene(mixture(), 0, 1000);
  few.max_steps = 40;
  const Propagator limited = propagate(few);
  REQUIRE(limited.stop);
  CHECK(limited.stop->reason == "step limit");
  CHECK(limited.stop->message == "step limit: max_steps = 40 are used up");
  CHECK(limited.cost.steps + limited.cost.rejected <= 40);

  double last = 0;
  const Propagator stopped = propagate(flows::scene(omega, 0, 10), [&](double t) {
    last = t;
    return t < 1;
  });
  REQUIRE(stopped.stop);
  CHECK(stopped.stop->reason == "interrupted");
  CHECK(stopped.t1 == 1);
  CHECK(last == 1);
  CHECK(stopped.flow->at(1).w() == Approx(std::cos(0.5)).epsilon(4 * kEpsilon));
}
