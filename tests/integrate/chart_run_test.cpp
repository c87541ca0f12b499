// Runs in the charts: Theorem 3.2 (every equation moves the same points of the body), honest error
// estimates, singularities, restarts.
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "catch.hpp"
#include "charts.hpp"
#include "closed_forms.hpp"
#include "refusal.hpp"

namespace {

using namespace rotor;
using closed_form::by_dop853, closed_form::by_rk4, closed_form::scene;

constexpr double kPi = std::numbers::pi;

// [P15], T = 40, from E = (1, 1, 1)/sqrt(3): theta stays within (0.70, 5.58), so that E, F and axis
// and angle never come near a singularity [theory 5].
const closed_form::Turning kMotion = closed_form::turning(40);
const Rotation kFrom(Vector(1, 1, 1), 1);

struct Chart {
  std::string name;
  Equation equation;
  std::shared_ptr<const GeneralizedAngle> f = nullptr;
};
std::vector<Chart> charts() {
  return {{"quaternion", Equation::kQuaternion},
          {"modified_gibbs", Equation::kModifiedGibbs},
          {"body_points", Equation::kBodyPoints},
          {"euler", Equation::kEuler},
          {"axis_angle", Equation::kAxisAngle},
          {"generalized cubic", Equation::kGeneralized, cubic_angle()},
          {"generalized identity", Equation::kGeneralized, identity_angle()}};
}
// Those that end at theta = pi, for shorter motions.
std::vector<Chart> half_charts() {
  return {{"gibbs", Equation::kGibbs},
          {"half tangent", Equation::kGeneralized, half_tangent_angle()},
          {"half sine", Equation::kGeneralized, half_sine_angle()}};
}

Scene in(const Chart& chart, Scene s) {
  s.equation = chart.equation;
  s.f = chart.f;
  return s;
}
Scene in_body_frame(Scene s) {
  s.omega = s.omega.in_body_frame();
  return s;
}

// The images of e1, e2, e3 at t.
Matrix points(const Propagator& run, double t) {
  return run(t, kFrom.quaternion()).toRotationMatrix();
}

// 0.8: of first order, and the greatest error may lie between the nodes of the estimate.
void check_honest(const Propagator& run, double error) {
  CAPTURE(run.method, error, run.error_estimate, run.cost.steps);
  CHECK(run.error_estimate >= 0.8 * error);
  if (error > 1e-9) CHECK(run.error_estimate <= 10 * error);
}

void check_same_motion(const Chart& chart, double end, double accuracy, double step) {
  CAPTURE(chart.name, end, accuracy, step);
  for (const bool body : {false, true}) {
    Scene s = scene(kMotion.omega(), 0, end);
    if (body) s = in_body_frame(s);
    Chart p1{"body_points", Equation::kBodyPoints};
    const Propagator reference = propagate(in(p1, by_dop853(1e-12, s)), {}, kFrom);
    for (const Scene& asked : {by_dop853(accuracy, s), by_rk4(step, s)}) {
      const Propagator run = propagate(in(chart, asked), {}, kFrom);
      CAPTURE(body, run.method);
      REQUIRE(!run.stop);
      REQUIRE(run.t1 == end);
      double worst = 0;
      for (int i = 0; i <= 50; ++i) {
        const double t = end * i / 50;
        // No point of the unit sphere moves by more than the angle between.
        worst =
            std::max(worst, (points(run, t) - points(reference, t)).colwise().norm().maxCoeff());
      }
      // Estimates are of first order.
      CHECK(worst <= 1.25 * (run.error_estimate + reference.error_estimate));
      if (run.method == "dop853") CHECK(worst <= accuracy);
    }
  }
}

}  // namespace

TEST_CASE("every equation moves the same points of the body (Theorem 3.2)") {
  for (const Chart& chart : charts()) {
    check_same_motion(chart, 15, 1e-9, 0.05);
    check_same_motion(chart, -15, 1e-6, 0.1);
  }
  // theta < pi there: the closed form has 2.59 for its greatest.
  for (const Chart& chart : half_charts()) {
    check_same_motion(chart, 1.5, 1e-9, 0.01);
    check_same_motion(chart, -1.5, 1e-6, 0.02);
  }
}

TEST_CASE("in every equation the error estimate is the error, and the accuracy is kept") {
  for (const Chart& chart : charts()) {
    CAPTURE(chart.name);
    for (const double accuracy : {1e-4, 1e-8, 1e-12, 1e-15}) {
      const Propagator run =
          propagate(in(chart, by_dop853(accuracy, scene(kMotion.omega(), 0, 40))), {}, kFrom);
      REQUIRE(!run.stop);
      const double error = closed_form::greatest_error(run, kMotion, 100);
      CAPTURE(accuracy);
      check_honest(run, error);
      CHECK(error <= std::max(accuracy, run.error_estimate));
    }
    // Longer ones are no longer short beside the 0.7 rad that are left to the full turn.
    for (const double step : {0.1, 0.03}) {
      const Propagator run =
          propagate(in(chart, by_rk4(step, scene(kMotion.omega(), 0, 40))), {}, kFrom);
      CAPTURE(step);
      check_honest(run, closed_form::greatest_error(run, kMotion, 100));
    }
  }
}

TEST_CASE("the paper's RK4 on the Euler vector has the paper's error") {
  // A rotation error of 4.82e-3 rad at t = 4200 for h = 0.1 [theory 5].
  const Propagator run = propagate(
      in({"euler", Equation::kEuler}, by_rk4(0.1, scene(kMotion.omega(), 0, 4200))), {}, kFrom);
  REQUIRE(!run.stop);
  const Quaternion end = run(4200, Quaternion::Identity());
  CHECK(closed_form::rotation_error(end, kMotion(4200)) == Approx(4.82e-3).epsilon(2e-3));
  check_honest(run, closed_form::greatest_error(run, kMotion, 200));
}

TEST_CASE("the generator of a run is omega but for its defect, in every equation") {
  // A difference quotient of the flow errs by d^2/6 of its third derivative and by rounding,
  // 1e-16/d: 1e-10 in all. What the generator is off omega by is an accuracy of 1e-4 over some
  // steps.
  for (const Chart& chart : charts()) {
    const Propagator run =
        propagate(in(chart, by_dop853(1e-4, scene(kMotion.omega(), 0, 30))), {}, kFrom);
    CAPTURE(chart.name);
    const std::vector<double> mesh = run.flow->mesh();
    for (std::size_t i = 0; i + 1 < mesh.size(); i += 3) {
      const double t = mesh[i] + 0.37 * (mesh[i + 1] - mesh[i]);
      constexpr double d = 1e-5;
      const Quaternion turn = run.flow->at(t + d) * run.flow->at(t - d).conjugate();
      CAPTURE(t);
      CHECK((turn.vec() / d - run.flow->generator(t)).norm() < 1e-9);
      CHECK((run.flow->generator(t) - kMotion.omega()(t)).norm() < 1e-2);
    }
  }
}

namespace {

// From the identity about k at a unit rate: theta = t.
const AngularVelocity kAboutK([](double) { return Vector(0, 0, 1); });

struct Ending {
  Chart chart;
  Rotation from;
  double t;
  std::string place;
};
std::vector<Ending> endings() {
  const Rotation identity;
  const Rotation small(Vector(0, 0, 1), 0.25);
  const Rotation turned(Vector(0, 0, 1), 7);
  return {{{"E", Equation::kEuler}, identity, 2 * kPi, "|E| = 2 pi"},
          {{"E", Equation::kEuler}, turned, 4 * kPi - 7, "|E| = 4 pi"},
          {{"G", Equation::kGibbs}, identity, kPi, "theta = pi"},
          {{"n", Equation::kAxisAngle}, small, 2 * kPi - 0.25, "theta = 2 pi"},
          {{"F", Equation::kGeneralized, cubic_angle()}, identity, 2 * kPi, "theta = 2 pi"},
          {{"M", Equation::kGeneralized, half_sine_angle()}, identity, kPi, "theta = 3.14159"},
          {{"G", Equation::kGeneralized, half_tangent_angle()}, identity, kPi, "theta = 3.14159"}};
}

}  // namespace

TEST_CASE("each equation ends at its own singularity, by name, with the part done") {
  for (const Ending& ending : endings()) {
    for (const double t0 : {0.0, 10.0}) {
      for (const bool body : {false, true}) {
        Scene s = in(ending.chart, by_dop853(1e-10, scene(kAboutK, t0, t0 + 20)));
        if (body) s = in_body_frame(s);
        const Propagator run = propagate(s, {}, ending.from);
        CAPTURE(ending.chart.name, t0, body, run.cost.steps, run.cost.rejected);
        REQUIRE(run.stop);
        CAPTURE(run.stop->message);
        CHECK(run.stop->reason == "singularity");
        CHECK(run.stop->message.find(ending.place) != std::string::npos);
        CHECK(run.stop->message.find("quaternion") != std::string::npos);
        // Where f' = 0, F tells theta to u/(distance): an accuracy of 1e-10 ends at some 1e-4.
        CHECK(run.t1 ==
              Approx(t0 + ending.t).epsilon(0).margin(ending.chart.name == "M" ? 1e-3 : 1e-9));
        CHECK(run.t1 <= t0 + ending.t + 1e-10);  // the error of theta
        CHECK(run.error_estimate < 1e-10);
        const double half = t0 + ending.t / 2;
        const Quaternion q = run.flow->at(half);
        const double sign = body ? -1 : 1;
        CHECK((q.vec() - Vector(0, 0, sign * std::sin(ending.t / 4))).norm() < 1e-10);
      }
    }
  }
}

TEST_CASE("fixed steps end before the singularity that the next one would pass") {
  for (const Ending& ending : endings()) {
    const double step = 0.07;
    const Propagator run =
        propagate(in(ending.chart, by_rk4(step, scene(kAboutK, 0, 14))), {}, ending.from);
    CAPTURE(ending.chart.name, run.t1);
    REQUIRE(run.stop);
    CHECK(run.stop->reason == "singularity");
    CHECK(run.t1 <= ending.t);
    CHECK(run.t1 > ending.t - 1.01 * step);
    CHECK(run.cost.rejected == 1);
  }
}

TEST_CASE("near misses of a full turn are followed, and said as well as they are known") {
  // About k from a start that is delta off that axis: theta comes as near to 2 pi as some 2 delta.
  for (const double delta : {0.3, 1e-2, 1e-4, 1e-6}) {
    const Rotation from =
        from_quaternion(Quaternion(std::cos(0.5), delta, 0, std::sin(0.5)).normalized());
    const auto truth = [](double t) { return closed_form::turn({0, 0, Extended{t}}); };
    for (const Chart& chart : {Chart{"E", Equation::kEuler}, Chart{"n", Equation::kAxisAngle},
                               Chart{"F", Equation::kGeneralized, cubic_angle()}}) {
      // For a vector n f(theta) the steps are as the root of the distance, and there many.
      if (delta < 1e-5 && chart.equation != Equation::kAxisAngle) continue;
      for (const double accuracy : {1e-5, 1e-9}) {
        const Propagator run =
            propagate(in(chart, by_dop853(accuracy, scene(kAboutK, 0, 8))), {}, from);
        CAPTURE(chart.name, delta, accuracy, run.cost.steps);
        REQUIRE(!run.stop);
        const double error = closed_form::greatest_error(run, truth, 100);
        CAPTURE(error, run.error_estimate);
        CHECK(error <= std::max(accuracy, run.error_estimate));
        CHECK(run.error_estimate >= 0.8 * error);
      }
      // Fixed steps either say their error or end.
      const Propagator fixed = propagate(in(chart, by_rk4(0.05, scene(kAboutK, 0, 8))), {}, from);
      CAPTURE(chart.name, delta);
      if (fixed.stop) {
        CHECK(fixed.stop->reason == "singularity");
        CHECK(fixed.t1 == Approx(2 * kPi - 1).epsilon(0).margin(0.2));
      }
      const double error = closed_form::greatest_error(fixed, truth);
      CHECK(fixed.error_estimate >= 0.8 * error);
    }
  }
}

TEST_CASE("with restart the Euler vector goes on for ever, and U is continuous") {
  const auto truth = [](double t) { return closed_form::turn({0, 0, Extended{t}}); };
  for (const Chart& chart :
       {Chart{"E", Equation::kEuler}, Chart{"F", Equation::kGeneralized, cubic_angle()}}) {
    for (Scene s :
         {by_dop853(1e-10, scene(kAboutK, 0, 60)), by_rk4(0.05, scene(kAboutK, 0, -60))}) {
      s.restart = true;
      const Propagator run = propagate(in(chart, s), {}, Rotation(Vector(0, 0, 1), 7));
      CAPTURE(chart.name, run.method);
      REQUIRE(!run.stop);
      // Signs too: 2 pi is an error of 2 pi here.
      const double error = closed_form::greatest_error(run, truth, 100);
      CHECK(0.8 * error <= run.error_estimate);
      CHECK(run.error_estimate < 1e-5);
    }
    Scene s = in(chart, by_dop853(1e-9, scene(kMotion.omega(), 0, 100)));
    s.restart = true;
    const Propagator run = propagate(s, {}, Rotation());
    REQUIRE(!run.stop);
    const double error = closed_form::greatest_error(run, kMotion, 100);
    CHECK(error <= 1e-9);
    CHECK(run.error_estimate >= 0.8 * error);
    // The paper's fixed steps across its restarts.
    Scene fixed = in(chart, by_rk4(0.02, scene(kMotion.omega(), 0, 100)));
    fixed.restart = true;
    const Propagator rk4 = propagate(fixed, {}, Rotation());
    REQUIRE(!rk4.stop);
    check_honest(rk4, closed_form::greatest_error(rk4, kMotion, 100));
  }
}

TEST_CASE("steps end at breaks, and the fixed ones are equal in between") {
  const closed_form::Piecewise motion{{1.0, 2.05}, {{0, 0, 1}, {1, 0, 0}, {0, -1, 0.5}}};
  for (const double direction : {1.0, -1.0}) {
    // Backward in t the same way is gone with the other sign of omega.
    const AngularVelocity omega(
        [&](double t) { return Vector(direction * motion.omega()(direction * t)); });
    const auto truth = [&](double t) { return motion(direction * t); };
    for (const Chart& chart :
         {Chart{"quaternion", Equation::kQuaternion}, Chart{"E", Equation::kEuler}}) {
      Scene s = by_rk4(0.1, scene(omega, 0, 3 * direction));
      s.breaks = {2.05 * direction, direction};
      const Propagator run = propagate(in(chart, s), {}, Rotation());
      CAPTURE(chart.name, direction);
      REQUIRE(!run.stop);
      CHECK(run.cost.steps == 10 + 11 + 10);
      // Two calls a step, one more for the first of each part and for its end.
      CHECK(run.cost.omega_calls == 2 * 31 + 3);
      check_honest(run, closed_form::greatest_error(run, truth));
      CHECK(run.error_estimate < 1e-6);
      Scene adaptive = by_dop853(1e-12, s);
      adaptive.step.reset();
      const Propagator fine = propagate(in(chart, adaptive), {}, Rotation());
      REQUIRE(!fine.stop);
      CHECK(closed_form::greatest_error(fine, truth) <= fine.error_estimate);
      CHECK(fine.error_estimate < 2e-12);
      CHECK(fine.cost.rejected <= 8);
    }
  }
}

TEST_CASE("what an equation does not take is refused") {
  const auto refuse = [](Scene s, const std::vector<std::string>& words) {
    refused([&] { propagate(s, {}, kFrom); }, words);
  };
  Scene s = by_dop853(1e-6, scene(kAboutK, 0, 1));
  s.equation = Equation::kGeneralized;
  refuse(s, {"\"generalized\" needs f"});
  s.equation = Equation::kGibbs;
  s.restart = true;
  refuse(s, {"restart", "\"euler\""});
  s = scene(kAboutK, 0, 1);
  s.restart = true;  // nothing would restart
  refuse(s, {"restart", "\"euler\""});
  s = by_dop853(1e-6, scene(kAboutK, 0, 1));
  s.equation = Equation::kEuler;
  s.f = cubic_angle();
  refuse(s, {"f is for"});
  s.f = nullptr;
  s.equation = Equation::kAxisAngle;
  refused([&] { propagate(s); }, {"\"axis_angle\"", "angle is 0.0"});
}

TEST_CASE("a way of no length is the identity in every equation") {
  for (const Chart& chart : charts()) {
    for (const Scene& s :
         {by_dop853(1e-9, scene(kAboutK, 3, 3)), by_rk4(0.1, scene(kAboutK, 3, 3))}) {
      const Propagator run = propagate(in(chart, s), {}, kFrom);
      CHECK(!run.stop);
      CHECK(run.flow->at(3).coeffs() == Quaternion::Identity().coeffs());
      CHECK(run.flow->mesh() == std::vector{3.0});
      CHECK(run.error_estimate < 1e-14);
    }
  }
}
