// omega of a fixed direction: its angle against integrals known in closed form.
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "catch.hpp"
#include "flows.hpp"
#include "integrate/legendre_rule.hpp"
#include "spin/models.hpp"

namespace {

using namespace rotor;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

AngularVelocity along(std::function<double(double)> rate, Frame frame = Frame::kSpace,
                      const Vector& direction = {2, -1, 2}) {
  ScalarFunction function;
  function.value = std::move(rate);
  function.name = "rate";
  return {std::make_shared<const AlongSpin>(direction, function), frame};
}

struct Integral {
  std::string name;
  std::function<double(double)> rate;
  std::function<Extended(Extended)> integral;
};

// The greatest error of the angle.
double greatest_error(const Propagator& run, const Integral& known) {
  const FixedAxisFlow* turn = run.fixed_axis();
  REQUIRE(turn != nullptr);
  const Extended sign = run.frame == Frame::kSpace ? 1 : -1;
  Extended worst = 0;
  for (const double t : flows::times(run.t0, run.t1)) {
    const Extended truth = sign * (known.integral(t) - known.integral(run.t0));
    const Extended error = std::abs(turn->angle(t) - truth);
    if (!(error <= worst)) worst = error;
  }
  return static_cast<double>(worst);
}

const std::vector<Integral> kSmooth = {
    {"2 + cos 3t", [](double t) { return 2 + std::cos(3 * t); },
     [](Extended t) { return 2 * t + std::sin(3 * t) / 3; }},
    {"sin t/7", [](double t) { return std::sin(t / 7); },
     [](Extended t) { return -7 * std::cos(t / 7); }},
    {"1/(1 + t^2)", [](double t) { return 1 / (1 + t * t); },
     [](Extended t) { return std::atan(t); }},
    {"t cos t^2/40", [](double t) { return t * std::cos(t * t / 40); },
     [](Extended t) { return 20 * std::sin(t * t / 40); }},
    {"0", [](double) { return 0.0; }, [](Extended) { return Extended{0}; }},
    {"1e-300", [](double) { return 1e-300; }, [](Extended t) { return 1e-300 * t; }},
};

}  // namespace

TEST_CASE("the nodes of Gauss and Legendre integrate every power of degree 63") {
  // Coefficient 0 is half the integral. 32 products and sums of extended numbers of at most 1.
  const LegendreRule& rule = legendre_rule();
  for (int power = 0; power < 64; ++power) {
    const LegendreRule::Values x = rule.nodes.array().pow(power);
    const Extended integral = 2 * rule.coefficients.row(0).dot(x);
    const Extended truth = power % 2 == 0 ? Extended{2} / (power + 1) : 0;
    CAPTURE(power);
    CHECK(static_cast<double>(std::abs(integral - truth)) < 64 * 1.1e-19);
  }
}

TEST_CASE("a series of Legendre's polynomials goes through its samples, with slope and integral") {
  const LegendreRule& rule = legendre_rule();
  LegendreRule::Values samples;
  for (int i = 0; i < LegendreRule::kNodes; ++i) samples[i] = std::exp(rule.nodes[i]);
  const LegendreRule::Values c = rule.coefficients * samples;
  // The series of e^x ends at 31!: far below rounding. Slopes amplify that by 32^2.
  CHECK(static_cast<double>((rule.slopes * samples - samples).norm()) < 64 * 32 * 32 * 1.1e-19);
  for (const Extended x : {-1.0L, -0.5L, 0.0L, 0.3L, 1.0L}) {
    CHECK(static_cast<double>(std::abs(legendre_sum(c, x) - std::exp(x))) < 3e-17);
    CHECK(static_cast<double>(
              std::abs(legendre_integral(c, x) - (std::exp(x) - std::exp(Extended{-1})))) < 1e-17);
  }
}

TEST_CASE("a fixed direction keeps the accuracy asked for over the whole interval, both ways") {
  for (const Integral& known : kSmooth) {
    for (const Frame frame : {Frame::kSpace, Frame::kBody}) {
      for (const auto& [t0, t1] : {std::pair{0.0, 40.0}, {40.0, 0.0}, {-7.5, 21.0}, {3.0, 3.0}}) {
        for (const double accuracy : {1e-4, 1e-8, 1e-12, 1e-16}) {
          const Propagator run =
              propagate(flows::scene(along(known.rate, frame), t0, t1, accuracy));
          const double error = greatest_error(run, known);
          CAPTURE(known.name, t0, t1, accuracy, error, run.error_estimate, run.cost.omega_calls);
          REQUIRE(!run.stop);
          CHECK(run.method == "exact");
          CHECK(run.accuracy == accuracy);
          CHECK(error <= run.error_estimate);
          CHECK(error <= std::max(accuracy, 1e-13));
          CHECK(run.error_estimate <= std::max(accuracy, 1e-12));
          CHECK(run.cost.omega_calls <= 12'000);
        }
      }
    }
  }
}

TEST_CASE("many radians keep their digits") {
  // s = t is sampled without error: the angle is exact to 64 bits, at 5e9 rad to 5e-10 / 2.
  const Integral ramp{"t", [](double t) { return t; }, [](Extended t) { return t * t / 2; }};
  const Propagator run = propagate(flows::scene(along(ramp.rate), 0, 1e5, 1e-12));
  CHECK(greatest_error(run, ramp) < 1e-8);
  CHECK(greatest_error(run, ramp) <= run.error_estimate);
  // Samples of 1e8 have no digit below 1e-8, and the run says so.
  const Integral fast{"1e8", [](double) { return 1e8; }, [](Extended t) { return 1e8L * t; }};
  const Propagator quick = propagate(flows::scene(along(fast.rate), 0, 10, 1e-10));
  CHECK(greatest_error(quick, fast) <= quick.error_estimate);
  CHECK(greatest_error(quick, fast) < 1e-9);
  CHECK(quick.error_estimate < 1e-6);
  CHECK(quick.cost.steps <= 32);
  // A whole long run: 6.4e5 periods' worth of panels add up.
  const Integral slow = kSmooth[1];
  const Propagator far = propagate(flows::scene(along(slow.rate), 0, 1e5, 1e-9));
  const double error = greatest_error(far, slow);
  CAPTURE(error, far.error_estimate, far.cost.omega_calls);
  CHECK(error <= std::min(1e-9, far.error_estimate));
}

TEST_CASE("far from zero the rounding of the times of samples is made good") {
  const Integral wave{"cos t", [](double t) { return std::cos(t); },
                      [](Extended t) { return std::sin(t); }};
  for (const auto& [t0, t1] : {std::pair{1e9, 1e9 + 20}, {1e9 + 20, 1e9}, {-1e9, -1e9 + 20}}) {
    const Propagator run = propagate(flows::scene(along(wave.rate), t0, t1, 1e-10));
    const double error = greatest_error(run, wave);
    CAPTURE(t0, t1, error, run.error_estimate);
    CHECK(error <= run.error_estimate);
    // cos t is exact at its double t, so nothing of 1e9 * 2^-53 = 1e-7 is left.
    CHECK(error < 1e-10);
  }
}

TEST_CASE("jumps and kinks of the rate cost no more than is stated, with breaks and without") {
  std::mt19937 random(7321);
  std::uniform_real_distribution<double> place(0.01, 9.99);
  for (int i = 0; i < 24; ++i) {
    const double where = place(random);
    const Integral jump{"jump", [where](double t) { return t < where ? 1.0 : -2.5; },
                        [where](Extended t) { return t < where ? t : where - 2.5L * (t - where); }};
    const Integral kink{"kink", [where](double t) { return std::abs(t - where); },
                        [where](Extended t) { return (t - where) * std::abs(t - where) / 2; }};
    for (const Integral& known : {jump, kink}) {
      for (const double accuracy : {1e-4, 1e-7, 1e-10}) {
        const bool backward = i % 2 == 1;
        Scene scene =
            flows::scene(along(known.rate), backward ? 10 : 0, backward ? 0 : 10, accuracy);
        const Propagator run = propagate(scene);
        const double error = greatest_error(run, known);
        CAPTURE(known.name, where, accuracy, error, run.error_estimate, run.cost.omega_calls);
        REQUIRE(!run.stop);
        CHECK(error <= run.error_estimate);
        CHECK(error <= accuracy);
        scene.breaks = {where, 4.0, -3.0, 25.0};
        const Propagator told = propagate(scene);
        CHECK(greatest_error(told, known) <= 1e-14);
        CHECK(told.cost.rejected == 0);
      }
    }
  }
}

TEST_CASE("a fixed direction agrees with its integration, and its generator with its motion") {
  const auto rate = [](double t) { return 0.4 + std::cos(t); };
  for (const Frame frame : {Frame::kSpace, Frame::kBody}) {
    for (const auto& [t0, t1] : {std::pair{0.0, 60.0}, {10.0, -50.0}}) {
      const Scene scene = flows::scene(along(rate, frame), t0, t1, 1e-10);
      flows::check_against_dop853(scene, 1e-10);
      const Propagator run = propagate(scene);
      flows::check_mesh(*run.flow, t0, t1);
      for (const double t : flows::times(t0 + (t1 - t0) * 1e-3, t1 - (t1 - t0) * 1e-3)) {
        flows::check_generator(*run.flow, t, 3);
      }
      CHECK(run.fixed_axis()->direction().isApprox(Vector(2, -1, 2) / 3, 2 * kEpsilon));
    }
  }
}

TEST_CASE("a rate that fails ends the run with its reason and the part done") {
  const auto part = [](const AngularVelocity& omega, double t1) {
    return propagate(flows::scene(omega, 0, t1, 1e-8));
  };
  const Propagator nan = part(along([](double t) { return std::sqrt(3 - t); }), 10);
  REQUIRE(nan.stop);
  CHECK(nan.stop->reason == "omega failed");
  CHECK(nan.stop->message.find("rate gave nan at t = ") == 0);
  CHECK(nan.t1 == nan.stop->t);
  CHECK(nan.t1 >= 0);
  CHECK(nan.t1 < 10);
  CHECK(nan.flow->at(0).coeffs() == Eigen::Vector4d(0, 0, 0, 1));
  CHECK(std::isfinite(nan.flow->at(nan.t1).norm()));
  CHECK(nan.flow->mesh().back() == nan.t1);

  const Propagator over = part(along([](double) { return 1e300; }), 1e20);
  REQUIRE(over.stop);
  CHECK(over.stop->reason == "step overflow");

  Scene scene = flows::scene(along([](double t) { return std::sin(t); }), 0, 1e4, 1e-10);
  scene.max_steps = 20;
  const Propagator limited = propagate(scene);
  REQUIRE(limited.stop);
  CHECK(limited.stop->reason == "step limit");

  int calls = 0;
  const Propagator stopped = propagate(flows::scene(along([](double t) { return t; }), 0, 10),
                                       [&](double) { return ++calls <= 3; });
  REQUIRE(stopped.stop);
  CHECK(stopped.stop->reason == "interrupted");
  CHECK(stopped.cost.steps == 3);
  CHECK(stopped.fixed_axis()->angle(stopped.t1) ==
        Approx(stopped.t1 * stopped.t1 / 2).epsilon(1e-15));
}
