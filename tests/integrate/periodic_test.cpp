// A periodic omega: one period and its powers against closed forms and against integration through
// every period.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

#include "catch.hpp"
#include "closed_forms.hpp"
#include "flows.hpp"
#include "refusal.hpp"
#include "spin/models.hpp"

namespace {

using namespace rotor;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

AngularVelocity periodic(double period, const AngularVelocity& one, Frame frame = Frame::kSpace) {
  return {std::make_shared<const PeriodicSpin>(period, one), frame};
}

// omega with its mean, three harmonics and no symmetry; slope at most 2.4 times its 2 pi/T.
AngularVelocity wave(double period) {
  return AngularVelocity([period](double t) {
    const double x = 2 * std::numbers::pi * t / period;
    return Vector(0.3 + std::cos(x), std::sin(2 * x), 0.2 * std::cos(3 * x) - 0.4);
  });
}

// e1 for the first T/2, then e2: quarter turns where T = pi.
AngularVelocity square(double period) {
  std::vector<AngularVelocity> pieces{Vector(1, 0, 0), Vector(0, 1, 0)};
  return {std::make_shared<const PiecewiseSpin>(std::vector<double>{period / 2}, pieces)};
}

}  // namespace

TEST_CASE("a periodic omega agrees with its integration through all periods") {
  const double period = 2.5;
  const std::vector<std::pair<double, double>> ways{
      {0, 20},    {0, -20},   {0.7, 21.3}, {0.7, -13.1}, {-3.1, 9.4}, {-3.1, -14},
      {0.7, 1.3}, {1.9, 3.2}, {3.2, 1.9},  {5, 20},      {5, -10},    {1, 3.5},
      {2.5, 5},   {0.3, 2.5}, {2.5, 0.3},  {-2.5, 0},    {1e-20, 6},  {-1e-20, 6}};
  for (const auto& [t0, t1] : ways) {
    for (const Frame frame : {Frame::kSpace, Frame::kBody}) {
      flows::check_against_dop853(flows::scene(periodic(period, wave(period), frame), t0, t1),
                                  1e-10);
      flows::check_against_dop853(flows::scene(periodic(period, square(period), frame), t0, t1),
                                  1e-10);
    }
  }
}

TEST_CASE("no more of a period is followed than is asked") {
  // The phases at which omega is asked; none is outside a period.
  const auto asked = [](double t0, double t1) {
    double low = 1e300;
    double high = -1e300;
    const AngularVelocity one([&](double t) {
      low = std::min(low, t);
      high = std::max(high, t);
      return Vector(1, 0, std::cos(t));
    });
    REQUIRE(!propagate(flows::scene(periodic(2.5, one), t0, t1)).stop);
    return std::pair{low, high};
  };
  const auto within = [](const std::pair<double, double>& phases, double low, double high) {
    CAPTURE(phases.first, phases.second);
    CHECK(phases.first >= low);
    CHECK(phases.second <= high);
  };
  within(asked(0, 1e4), 0, 2.5);
  within(asked(-1e4 - 0.1, 3), 0, 2.5);
  within(asked(0, 1.25), 0, 1.25);
  within(asked(1.25, 0.5), 0.5, 1.25);
  within(asked(1e6 + 0.5, 1e6 + 1), 0.5, 1);
  CHECK(propagate(flows::scene(periodic(2.5, wave(2.5)), 0, 1e4)).why ==
        "periodic omega: one period, then Floquet");
  CHECK(propagate(flows::scene(periodic(2.5, wave(2.5)), 0, 2)).why == "within a period of omega");
}

TEST_CASE("a billion units of a periodic omega cost one period and keep what is stated") {
  // [P15] is periodic and has a closed form; the period is one of doubles, so omega turns by 2 pi
  // and some 1e-16 in it. The truth is that of the function that is repeated.
  const double period = 40;
  const closed_form::Turning drive = closed_form::turning(period);
  const AngularVelocity omega = periodic(period, drive.omega());
  const auto power = [&](double k) {
    const closed_form::ExtendedQuaternion w = drive(period);
    const Extended half = std::atan2(w.vec().norm(), w.w());
    closed_form::ExtendedQuaternion q;
    q.w() = std::cos(k * half);
    q.vec() = w.vec().normalized() * std::sin(k * half);
    return q;
  };
  for (const double sign : {1.0, -1.0}) {
    for (const double k : {0.0, 1.0, 105.0, 25e6}) {
      const double t1 = sign * (k * period + 7);
      const Propagator run = propagate(flows::scene(omega, 0, t1, 1e-9));
      const auto truth = sign > 0 ? drive(7) * power(k) : drive(period - 7) * power(-k - 1);
      const double error = closed_form::rotation_error(run(t1), truth);
      CAPTURE(t1, error, run.error_estimate, run.cost.omega_calls);
      CHECK(error <= run.error_estimate);
      CHECK(run.error_estimate <= std::max(1e-9, (k + 1) * 1e-14));
      CHECK(run.cost.omega_calls < 20'000);  // of 3e8 and more for every period
      CHECK(run.t1 == t1);
    }
  }
}

TEST_CASE("quarter turns in turn come back to the identity after so many periods as they must") {
  // i then j by pi/2 each: a turn by 2 pi/3 (about (1, 1, -1)): U(T)^3 = -1, U(T)^6 = 1.
  const double period = std::numbers::pi;
  const Propagator run = propagate(flows::scene(periodic(period, square(period)), 0, 3e5 * period));
  CHECK(run.method == "exact");
  CHECK(run.accuracy == 0);
  CHECK(run.cost.omega_calls == 0);
  const auto off = [&](double periods, double sign) {
    const Quaternion one(sign, 0, 0, 0);
    // The time is rounded by half an ulp, and the period of doubles is pi to 1.3e-16.
    return flows::angle_between(run.flow->at(periods * period), one) -
           (run.error_estimate + 2 * kEpsilon * periods * period);
  };
  CHECK(off(3, -1) <= 0);
  CHECK(off(6, 1) <= 0);
  CHECK(off(3e5, 1) <= 0);
  CHECK(off(3e5 - 3, -1) <= 0);
  CHECK(run.error_estimate < 1e-9);
}

TEST_CASE("a time before zero keeps its digits in a period far longer") {
  // -0.3 is the phase 2^20 - 0.3, which a double has to 1.2e-10 only.
  const double period = 0x1p20;
  const auto turn = [](const Vector& v, Extended t) {
    return closed_form::turn(v.cast<Extended>() * t);
  };
  const AngularVelocity omega = periodic(period, square(period));
  for (const double t : {-0.7, -0.1, 0.2, 0.9}) {
    const auto later = [&](Extended x) {
      return x < 0 ? turn(Vector(0, 1, 0), x) : turn(Vector(1, 0, 0), x);
    };
    const Propagator run = propagate(flows::scene(omega, -0.3, t));
    CAPTURE(t, text(run.error_estimate));
    CHECK(run.error_estimate < 1e-14);
    CHECK(closed_form::rotation_error(run(t), later(t) * later(-0.3).conjugate()) <=
          run.error_estimate);
  }
  // About one direction: the angle, before and after.
  const Propagator turned = propagate(flows::scene(periodic(period, Vector(0, 0, 1)), -0.3, 0.2));
  const Extended angle = turned.fixed_axis()->angle(0.2);
  CHECK(static_cast<double>(std::abs(angle - (0.2 - Extended{-0.3}))) < 1e-18);
}

TEST_CASE("a period about a fixed direction stays a turn about it") {
  ScalarFunction rate;
  rate.value = [](double t) { return 1 + std::cos(2 * std::numbers::pi * t); };
  rate.name = "rate";
  const AngularVelocity one{std::make_shared<const AlongSpin>(Vector(0, 0, 2), rate)};
  // What it has more than t: fmod is exact.
  const auto more = [](double t) {
    const Extended x = 2 * std::numbers::pi_v<Extended> * std::fmod(t, 1.0);
    return std::sin(x) / (2 * std::numbers::pi_v<Extended>);
  };
  for (const auto& [t0, t1] : {std::pair{0.0, 1e6}, {0.25, -1e5}, {-0.3, 77.0}, {1e8, 1e8 + 9}}) {
    for (const Frame frame : {Frame::kSpace, Frame::kBody}) {
      const Propagator run = propagate(flows::scene(periodic(1, one, frame), t0, t1, 1e-9));
      REQUIRE(run.fixed_axis() != nullptr);
      CHECK(run.method == "exact");
      const double sign = frame == Frame::kSpace ? 1 : -1;
      for (const double t : flows::times(t0, t1)) {
        const Extended error =
            run.fixed_axis()->angle(t) - sign * ((Extended{t} - t0) + (more(t) - more(t0)));
        CAPTURE(t0, t1, t, run.error_estimate);
        CHECK(static_cast<double>(std::abs(error)) <= run.error_estimate);
        CHECK(run.fixed_axis()->rate(t) == Approx(sign * rate.value(t)).epsilon(0).margin(1e-6));
      }
      CHECK(run.error_estimate <= 2e-9);
    }
  }
}

TEST_CASE("the generator and the mesh of a periodic omega fit its motion") {
  for (const Frame frame : {Frame::kSpace, Frame::kBody}) {
    const AngularVelocity omega = periodic(2.5, wave(2.5), frame);
    for (const auto& [t0, t1] : {std::pair{0.7, 21.3}, {-3.1, -14.0}, {0.4, 0.9}}) {
      const Propagator run = propagate(flows::scene(omega, t0, t1));
      flows::check_mesh(*run.flow, t0, t1);
      for (const double t : flows::times(t0 + (t1 - t0) / 100, t1 - (t1 - t0) / 100)) {
        flows::check_generator(*run.flow, t, 16);
      }
    }
  }
  const Propagator far = propagate(flows::scene(periodic(2.5, wave(2.5)), 0, 1e9));
  CHECK_THROWS_AS(far.flow->mesh(), std::length_error);
}

TEST_CASE("what a periodic omega can reach is told, and nothing that it does reach is denied") {
  std::mt19937 random(40417);
  std::normal_distribution<double> normal;
  int denied = 0;
  for (const auto& [t0, t1] : {std::pair{0.7, 400.0}, {0.7, -90.0}, {0.2, 1.9}}) {
    for (const AngularVelocity& one : {wave(2.5), square(2.5)}) {
      const Propagator run = propagate(flows::scene(periodic(2.5, one), t0, t1));
      for (int i = 0; i < 30; ++i) {
        CAPTURE(t0, t1, i);
        const Quaternion there = run.flow->at(t0 + (t1 - t0) * i / 30);
        CHECK(!run.flow->approaches(there, 1e-14).empty());
        CHECK(!run.flow->approaches(Quaternion(-there.coeffs()), 1e-14).empty());
        const Quaternion aim =
            Quaternion(normal(random), normal(random), normal(random), normal(random)).normalized();
        if (run.flow->approaches(aim, 1e-12).empty()) ++denied;
      }
    }
  }
  // A surface in a space of three dimensions: a place at random is not on it.
  CHECK(denied == 180);
}

TEST_CASE("a periodic omega that fails ends where it does, and the part done holds") {
  // At the phase 2 of every period of 2.5.
  const AngularVelocity one([](double t) -> Vector {
    if (t > 2) throw std::runtime_error("no omega");
    return Vector(1, 0, std::cos(t));
  });
  const auto fine = [](double t0, double t1) {
    Scene scene = flows::scene(
        AngularVelocity([](double t) { return Vector(1, 0, std::cos(std::fmod(t, 2.5))); }), t0,
        t1);
    scene.method = Method::kDop853;
    scene.breaks = {1e9 + 2.5, 2.5, 5.0, 7.5};
    return propagate(scene);
  };
  struct Way {
    double t0, t1, low, high;
  };
  for (const Way& way :
       {Way{0, 100, 0, 2}, {1, 100, 1, 2}, {2.6, 100, 2.6, 4.5}, {1e9, 2e9, 1e9, 1e9 + 2}}) {
    const Propagator run = propagate(flows::scene(periodic(2.5, one), way.t0, way.t1));
    CAPTURE(way.t0, run.t1);
    REQUIRE(run.stop);
    CHECK(run.stop->reason == "omega failed");
    CHECK(run.stop->t == run.t1);
    CHECK(run.t1 >= way.low);
    CHECK(run.t1 <= way.high);
    CHECK(run.t1 > way.low);
    if (way.t0 > 1e8) continue;
    const Propagator other = fine(way.t0, run.t1);
    CHECK(flows::angle_between(run.flow->at(run.t1), other.flow->at(run.t1)) <= 1e-9);
  }
  const auto start = propagate(flows::scene(periodic(2.5, one), 2.2, 10));
  REQUIRE(start.stop);
  CHECK(start.t1 == 2.2);
  CHECK(start.flow->at(2.2).coeffs() == Eigen::Vector4d(0, 0, 0, 1));
  CHECK(start.flow->mesh() == std::vector<double>{2.2});

  // From 2.3 back past 2 at once; from 1 back to zero, and then at 2.5.
  const auto back = propagate(flows::scene(periodic(2.5, one), 1, -10));
  REQUIRE(back.stop);
  CHECK(back.t1 <= 0);
  CHECK(back.t1 >= -0.5);

  int calls = 0;
  const Propagator stopped = propagate(flows::scene(periodic(2.5, square(2.5)), 1, 100),
                                       [&](double) { return ++calls <= 2; });
  REQUIRE(stopped.stop);
  CHECK(stopped.stop->reason == "interrupted");
  CHECK(stopped.t1 > 1);
  CHECK(stopped.t1 < 3.5);
  CHECK(stopped.flow->mesh().back() == stopped.t1);
}

TEST_CASE("breaks of the scene count in every period, and periods are counted or refused") {
  const AngularVelocity jumps(
      [](double t) { return t < 1.125 ? Vector(1, 0, 0) : Vector(0, 2, 0.5); });
  Scene scene = flows::scene(periodic(2.5, jumps), 0.3, 60, 1e-10);
  scene.breaks = {1.125 + 4 * 2.5};
  const Propagator run = propagate(scene);
  // Constant pieces are followed exactly: only rounding is left, 25 times that of a period.
  CHECK(run.error_estimate < 1e-12);
  CHECK(run.cost.rejected == 0);
  flows::check_against_dop853(flows::scene(periodic(2.5, jumps), 0.3, 3.2, 1e-10), 1e-9);
  refused([] { propagate(flows::scene(periodic(5e-324, wave(1)), 0, 1)); }, {"too many periods"});
}
