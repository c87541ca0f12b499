// The certificate: the error of a run measured on the run itself is its true error.
#include "integrate/certify.hpp"

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <tuple>

#include "catch.hpp"
#include "closed_forms.hpp"
#include "rotation/text.hpp"
#include "spin/models.hpp"

namespace {

using namespace rotor;
using closed_form::by_dop853, closed_form::by_rk4, closed_form::greatest_error,
    closed_form::rotation_error, closed_form::scene, closed_form::turning;

constexpr double kPi = std::numbers::pi;
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

Certificate certificate(const Propagator& run, const Scene& s, const CertifyOptions& options = {}) {
  return certify(*run.flow, s.omega, options);
}

Quaternion turn(const Vector& v) { return closed_form::turn(v.cast<Extended>()).cast<double>(); }

// A turn about e3 at the rate 1 that leaps about e1 by `leap` at the time `when`.
class Leaping : public Flow {
 public:
  Leaping(double leap, double when, std::vector<double> mesh)
      : leap_(leap), when_(when), mesh_(std::move(mesh)) {}
  Quaternion at(double t) const override {
    const Quaternion q = turn(Vector(0, 0, t));
    return (t < when_) == (mesh_.front() < when_) ? q : q * turn(Vector(leap_, 0, 0));
  }
  Vector generator(double) const override { return Vector::UnitZ(); }
  std::vector<double> mesh() const override { return mesh_; }

 private:
  double leap_;
  double when_;
  std::vector<double> mesh_;
};

}  // namespace

TEST_CASE("the estimate is the error of RK4, the bound is above it, and the run can be corrected") {
  const auto motion = turning(40);
  for (const auto& [step, error, digit] :
       {std::tuple{0.5, 2.9747e-3, 1e-7}, std::tuple{0.2, 7.784e-5, 1e-8},
        std::tuple{0.1, 4.8801e-6, 1e-10}}) {
    for (const double end : {100.0, -100.0}) {
      CAPTURE(step, end);
      const Scene s = by_rk4(step, scene(motion.omega(), 0, end));
      const Propagator run = propagate(s);
      const Certificate found = certificate(run, s);
      // The digits given [theory 4.9]: the estimate is of first order.
      CHECK(found.estimate == Approx(error).epsilon(0).margin(digit / 2 + error * error));
      CHECK(found.estimate == Approx(norm(found.error)).epsilon(1e-3));
      CHECK(found.bound > 2 * found.estimate);
      CHECK_FALSE(found.at_rounding);
      CHECK(found.omega_calls == 22 * run.cost.steps);
      // What is left is of second order: the error times the turns within a step that make it, at
      // most the bound.
      const Quaternion corrected = turn(-found.error) * run(end);
      CHECK(rotation_error(corrected, motion(end)) < 10 * error * found.bound);
    }
  }
}

TEST_CASE("the bound is the integral of the defect's size") {
  const Scene s = by_rk4(0.5, scene(turning(40).omega(), 0, 100));
  const Propagator run = propagate(s);
  // The midpoint rule with 300 places a step: its kinks, where the defect turns, are O(1/300^2).
  double sum = 0;
  constexpr int kPlaces = 200 * 300;
  for (int i = 0; i < kPlaces; ++i) {
    const double t = 100 * (i + 0.5) / kPlaces;
    sum += (run.flow->generator(t) - s.omega(t)).norm() * 100 / kPlaces;
  }
  // Where the defect nearly vanishes within a step its size has a kink, and n points a step see
  // that to some 1/n^2.
  CHECK(certificate(run, s).bound == Approx(sum).epsilon(0.005));
  CHECK(certificate(run, s, {.n = 60}).bound == Approx(sum).epsilon(0.001));
}

TEST_CASE("the estimate is the error of any method, wherever it is above rounding") {
  for (const auto& [period, end] : {std::pair{40.0, 40.0}, std::pair{40.0, -400.0},
                                    std::pair{kPi, 40.0}, std::pair{kPi, -400.0}}) {
    for (const auto& [method, accuracy] : {std::pair{Method::kDop853, 1e-2},
                                           {Method::kDop853, 1e-6},
                                           {Method::kDop853, 1e-10},
                                           {Method::kDop853, 1e-15},
                                           {Method::kFgl, 1e-2},
                                           {Method::kFgl, 1e-4},
                                           {Method::kFgl, 1e-6},
                                           {Method::kFgl, 1e-15}}) {
      CAPTURE(period, end, static_cast<int>(method), accuracy);
      const auto motion = turning(period);
      Scene s = scene(motion.omega(), 0, end);
      s.method = method;
      s.accuracy = accuracy;
      const Propagator run = propagate(s);
      const Certificate found = certificate(run, s);
      const double error = greatest_error(run, motion, 300, 100);
      CAPTURE(error, found.estimate, found.bound, found.rounding);
      CHECK(found.estimate >= error / 10);
      CHECK(found.bound >= error);
      CHECK(found.bound >= found.estimate);
      if (error > 20 * found.rounding) {
        CHECK(found.estimate == Approx(error).epsilon(0.05));
        CHECK_FALSE(found.at_rounding);
      }
      if (accuracy < 1e-14) CHECK(found.at_rounding);
    }
  }
}

TEST_CASE("what a run states of its error holds against the certificate") {
  struct Problem {
    const char* name;
    Vector (*omega)(double);
    double t0;
    double t1;
  };
  const Problem problems[] = {
      {"mixed",
       [](double t) {
         return Vector(std::sin(3 * t) + 0.3 * std::cos(17 * t),
                       std::exp(-t / 50) * std::cos(t * t / 40), 0.5 * std::log(1 + t));
       },
       0, 30},
      {"fast", [](double t) { return Vector(30 * std::cos(100 * t), 100 * std::sin(30 * t), 20); },
       0, 2},
      {"backward", [](double t) { return Vector(std::cos(t), std::sin(2 * t), t / 10); }, 5, -25},
      {"kinks", [](double t) { return Vector(std::abs(std::sin(t)), 0.3, t / 10); }, 0, 10},
      {"a jump", [](double t) { return Vector(t < kPi ? 1 : -1, 0.3, std::sin(t)); }, 0, 10},
      {"late", [](double t) { return Vector(std::sin(3 * t), std::cos(3.1 * t), 0.1); }, 1e9,
       1e9 + 20}};
  const auto check = [](const char* name, const Scene& s) {
    const Propagator run = propagate(s);
    REQUIRE(!run.stop);
    const Certificate found = certificate(run, s);
    CAPTURE(name, run.method, s.accuracy, text(run.error_estimate), text(found.estimate),
            text(found.rounding));
    // DOP853 and RK4 state theirs to a fifth. Near rounding both are estimates of what noise does,
    // by other samples: an order of magnitude.
    const bool clear = found.estimate > 4 * found.rounding;
    CHECK(run.error_estimate >= (clear ? 0.8 : 0.1) * found.estimate);
    CHECK(found.bound >= found.estimate);
  };
  for (const Problem& problem : problems) {
    const Scene s = scene(AngularVelocity(problem.omega), problem.t0, problem.t1);
    for (const double accuracy : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
      check(problem.name, closed_form::to_accuracy(accuracy, s));
      if (problem.t0 < 1e9) check(problem.name, by_dop853(accuracy, s));
    }
    if (problem.t0 < 1e9) check(problem.name, by_rk4(1e-3 * std::abs(problem.t1 - problem.t0), s));
  }
}

TEST_CASE("a late motion is certified to the noise that omega has there, not to what it might") {
  // cos t is as good at 1e9 as at 0: only multiples of t are rounded.
  for (const double t0 : {0.0, 1e6, 1e9}) {
    CAPTURE(t0);
    const AngularVelocity omega([](double t) { return Vector(std::cos(t), std::sin(t), 0.1); });
    const Scene s = closed_form::to_accuracy(1e-10, scene(omega, t0, t0 + 10));
    // The motion turns by 10 rad, and the generator's noise is that of 512 roundings a step.
    CHECK(certificate(propagate(s), s).estimate < 1e-12);
  }
}

TEST_CASE("jumps that are not told cost the certificate no more than the run") {
  const AngularVelocity omega(
      [](double t) { return Vector(std::fmod(t, 1.2) < 0.6 ? 1 : -1, 0.3, t / 10); });
  const Scene s = closed_form::to_accuracy(1e-9, scene(omega, 0, 10));
  const Propagator run = propagate(s);
  CHECK(certificate(run, s).omega_calls < run.cost.omega_calls);
}

TEST_CASE("few points a step or many give the same") {
  const Scene s = by_dop853(1e-6, scene(turning(kPi).omega(), 0, 20));
  const Propagator run = propagate(s);
  const double found = certificate(run, s).estimate;
  for (const std::size_t n : {3U, 4U, 5U, 20U, 64U}) {
    CAPTURE(n);
    CHECK(certificate(run, s, {.n = n}).estimate == Approx(found).epsilon(0.01));
  }
}

TEST_CASE("in the body frame too, and the error has its frame and sign") {
  // U of -omega is the inverse of the motion: Q = q0 U*.
  const auto motion = turning(kPi);
  const AngularVelocity omega =
      AngularVelocity([&](double t) { return Vector(-motion.omega()(t)); }).in_body_frame();
  const Scene s = by_rk4(0.05, scene(omega, 0, 30));
  const Propagator run = propagate(s);
  const Certificate found = certificate(run, s);
  const Quaternion q0 = turn({0.3, -1, 2});
  const auto truth = q0.cast<Extended>() * motion(30).conjugate();
  const double error = rotation_error(run(30, q0), truth);
  CHECK(norm(found.error) == Approx(error).epsilon(1e-3));
  CHECK(rotation_error(run(30, q0) * turn(-found.error), truth) < 0.01 * error);
}

TEST_CASE("a motion that is exact is at rounding") {
  for (const double end : {1.0, -1e3, 1e5}) {
    CAPTURE(end);
    const Vector omega(1, -0.3, 1e-9);
    const Certificate found = certify(UniformTurn(omega, 0, end), omega);
    CHECK(found.at_rounding);
    CHECK(found.estimate == found.rounding);
    // 2 u |omega| over the way, and the roundings of a panel each.
    CHECK(found.rounding < 4 * kEpsilon * (std::abs(end) * norm(omega) + 5));
    CHECK(found.bound < 0.1 * found.rounding * std::abs(end) + 10 * found.rounding);
  }
  for (const double size : {0.0, 5e-324, 1e-300, 1e300}) {
    CAPTURE(size);
    const Vector omega(0, size, 0);
    CHECK(certify(UniformTurn(omega, 0, 2 / std::max(size, 1.0)), omega).at_rounding);
  }
}

TEST_CASE("a motion that leaps is off by its leap, forward and backward") {
  for (const double when : {2.0, 3.0}) {  // an end of a mesh interval, the middle of one
    for (const bool forward : {true, false}) {
      CAPTURE(when, forward);
      const std::vector<double> rising = {0, 2, 4};
      const std::vector<double> falling = {4, 2, 0};
      const Leaping flow(1e-5, when, forward ? rising : falling);
      const Certificate found = certify(flow, Vector(Vector::UnitZ()));
      // From the body: about e1, as the leap is; at the end seen in space.
      CHECK(found.estimate == Approx(1e-5).epsilon(1e-6));
      CHECK(found.bound == Approx(1e-5).epsilon(1e-6));
      const double end = forward ? 4 : 0;
      CHECK((found.error - turn(Vector(0, 0, end)) * Vector(1e-5, 0, 0)).norm() < 1e-10);
    }
  }
}

TEST_CASE("what omega does between the nodes of a method is found") {
  // The motion is that of omega = e3; in (3, 4) omega is twice that.
  const UniformTurn flow(Vector::UnitZ(), 0, 10);
  const AngularVelocity omega([](double t) { return Vector(0, 0, t > 3 && t < 4 ? 2 : 1); });
  const Certificate found = certify(flow, omega);
  // A jump lies in a 64th of an interval of 5, and twenty Gauss points miss it by at most half the
  // greatest weight, 0.04 of that: 0.003 at each. The bound has in it what might be missed.
  CHECK(found.estimate == Approx(1).epsilon(0).margin(0.006));
  CHECK(found.bound >= found.estimate);
  CHECK(found.bound == Approx(1).epsilon(0).margin(0.3));
  CHECK_FALSE(found.at_rounding);
  // Where the model says when it jumps, nothing is missed.
  const AngularVelocity told(std::make_shared<const PiecewiseSpin>(
      std::vector{3.0, 4.0},
      std::vector<AngularVelocity>{Vector(0, 0, 1), Vector(0, 0, 2), Vector(0, 0, 1)}));
  const Certificate exact = certify(flow, told);
  CHECK(exact.estimate == Approx(1).epsilon(1e-14));
  CHECK(exact.bound == Approx(1).epsilon(1e-13));
}

TEST_CASE("a jump between an end of the mesh and the first point is found") {
  // The mesh has the ends 0, 5 and 10, and the first of twenty points of an interval is 0.017 from
  // its end.
  const UniformTurn flow(Vector::UnitZ(), 0, 10);
  for (const double end : {0.0, 5.0, 10.0}) {
    CAPTURE(end);
    const AngularVelocity omega(
        [end](double t) { return Vector(0, 0, std::abs(t - end) < 0.008 ? 3 : 1); });
    const Certificate found = certify(flow, omega);
    const double error = end == 5 ? 0.032 : 0.016;  // twice that, on one side or on both
    // Each of up to two jumps by 2 lies in a 4096th of an interval of 5, and the points miss it by
    // half the greatest weight, 0.08, at most.
    const double missed = 2 * 2 * 5.0 / 4096 * 0.04;
    CHECK(found.estimate == Approx(error).epsilon(0).margin(missed));
    CHECK(found.bound >= error - missed);
  }
}

TEST_CASE("noise and bias of omega bound the attitude") {
  const UniformTurn flow(Vector::UnitZ(), 1, -9);
  const Vector omega = Vector::UnitZ();
  const double bound = certify(flow, omega).bound;
  CHECK(certify(flow, omega, {.noise = 1e-3, .bias = 2e-3}).bound ==
        Approx(bound + 0.03).epsilon(1e-15));
  const double estimate = certify(flow, omega).estimate;
  CHECK(certify(flow, omega, {.noise = 1e-3}).estimate == estimate);
}

TEST_CASE("a run of no length is at rounding") {
  const Certificate found = certify(UniformTurn(Vector::UnitX(), 3, 3), Vector(Vector::UnitX()));
  CHECK(found.at_rounding);
  CHECK(found.bound <= 4 * kEpsilon);
  CHECK(found.error == Vector::Zero());
}

TEST_CASE("what cannot be measured is said") {
  const UniformTurn flow(Vector::UnitZ(), 0, 10);
  const Vector omega = Vector::UnitZ();
  const auto said = [&](const CertifyOptions& options) {
    try {
      certify(flow, omega, options);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  CHECK(said({.n = 2}) == "n: expected 3 to 64 points an interval, got 2");
  CHECK(said({.n = 65}) == "n: expected 3 to 64 points an interval, got 65");
  CHECK(said({.noise = -1}) == "noise: expected a bound in rad per unit of t, 0 or more, got -1.0");
  CHECK(said({.bias = std::nan("")}) ==
        "bias: expected a bound in rad per unit of t, 0 or more, got nan");
  CHECK_THROWS_AS(certify(flow, AngularVelocity([](double t) { return Vector(0, t / 0.0, 1); })),
                  NonFiniteOmega);
  CHECK_THROWS_AS(certify(flow, omega, {}, [](double t) { return t < 4; }), Interrupted);
}
