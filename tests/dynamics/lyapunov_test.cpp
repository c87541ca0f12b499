#include "dynamics/lyapunov.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include "../motion/motions.hpp"
#include "../rotation/elements.hpp"
#include "../table.hpp"
#include "catch.hpp"
#include "spin/models.hpp"

namespace {

using namespace rotor;
using namespace rotor::motions;
using Catch::Matchers::Contains;
using std::numbers::pi;

const std::map<std::string, Chart> kByName = {{"rotation", Chart::kRotation},
                                              {"euler_vector", Chart::kEulerVector},
                                              {"modified_gibbs", Chart::kModifiedGibbs},
                                              {"gibbs", Chart::kGibbs},
                                              {"mrp", Chart::kMrp}};

AngularVelocity turning(double period) {
  return {std::make_shared<TurningSpin>(Vector(1, 0, 0), Vector(0, 0, 1), 2 * pi / period)};
}
Run p15(double period, double t1) {
  return evolve(scene(turning(period), 0, t1), from_euler_vector(Vector(1, 1, 1) / std::sqrt(3)));
}

// Of no period, in either frame.
Run wandering(Frame frame, const Rotation& from, double t1) {
  const auto omega = [](double t) -> Vector {
    return {std::cos(0.7 * t), 0.4, std::sin(t * t / 40)};
  };
  return evolve(scene({std::make_shared<FunctionSpin>(omega, "omega"), frame}, 0, t1, 1e-12), from);
}

}  // namespace

TEST_CASE("the exact finite-time exponents of P15 in four charts") {
  std::map<double, Run> runs;
  for (const double period : {40.0, pi})
    runs.emplace(period, p15(period, period == 40 ? 1e5 : 400));
  for (reference::Row& row : reference::table("dynamics/lyapunov.csv")) {
    const std::string chart = row.word();
    const Run& run = runs.at(row.number());
    const double t = row.number();
    const Vector expected = row.vector();
    CAPTURE(chart, t);
    const Vector measured = finite_time_exponents(run, t, kByName.at(chart));
    // A relative error of s is that of the rotation times |J^-1 dJ/dtheta| and the condition of D.
    // Of E, within 0.7 of 2 pi: 3 and 8. At these times M0 > 0.4: of G and M 2.5 and 6.
    CHECK((measured - expected).norm() * t <= 24 * 2 * rotation_tolerance(run, 6));
  }
}

TEST_CASE("the finite-time values of theory 4.2, to the digits given there") {
  const Run run = p15(40, 1e5);
  const auto largest = [&run](double t) {
    return finite_time_exponents(run, t, Chart::kEulerVector)(0);
  };
  CHECK(std::abs(largest(1e3) - 5.8e-5) < 0.05e-5);
  CHECK(std::abs(largest(2e3) - 7.4e-5) < 0.05e-5);
  CHECK(std::abs(largest(1e4) - 1.43e-4) < 0.005e-4);
  CHECK(std::abs(largest(1e5) - 1.0e-5) < 0.05e-5);
}

TEST_CASE("the error rotation has exponents 0 at all times, whatever omega is") {
  reference::Draw draw(64);
  for (const Frame frame : {Frame::kSpace, Frame::kBody}) {
    const Run run = wandering(frame, draw.rotation(), 20);
    for (const double t : times(1, 20, 19)) {
      CAPTURE(t);
      // Two matrices of three digits' rounding each.
      CHECK(finite_time_exponents(run, t, Chart::kRotation).norm() * t < 16 * kEpsilon);
    }
    const auto spectrum =
        lyapunov_spectrum(run, times(0, 20, 40), Chart::kRotation, LyapunovMethod::kQr);
    CHECK(spectrum.history.back().norm() * 20 < 40 * 1e-12);
  }
}

TEST_CASE("modified Rodrigues parameters are conformal: three equal exponents, in closed form") {
  reference::Draw draw(65);
  for (int i = 0; i < 20; ++i) {
    // With M0 > -1/2 at all times p is below 1.8: a start near the identity, and a short motion.
    const Rotation from(draw.vector(), draw.uniform(0, 1));
    const Run run = wandering(i % 2 == 0 ? Frame::kSpace : Frame::kBody, from, 1.5);
    CAPTURE(i, from.angle());
    const double rise = (1 + run(1.5).mrp().squaredNorm()) / (1 + run(0).mrp().squaredNorm());
    const Vector measured = finite_time_exponents(run, 1.5, Chart::kMrp);
    CHECK((measured.array() * 1.5 - std::log(rise)).abs().maxCoeff() < 32 * kEpsilon);
  }
}

TEST_CASE("the linearised equation with QR has the R of the tangent map itself") {
  reference::Draw draw(66);
  for (const auto& [name, chart] : kByName) {
    for (const Frame frame : {Frame::kSpace, Frame::kBody}) {
      const Rotation from(draw.vector(), 0.5);
      const Run run = wandering(frame, from, 30);
      const auto at = times(0, 30, 60);
      const auto qr = lyapunov_spectrum(run, at, chart, LyapunovMethod::kQr);
      CAPTURE(name, frame == Frame::kSpace, from.axis().transpose(), qr.bridged);
      CHECK(qr.singular.empty());
      REQUIRE(qr.history.size() == 60);
      // A step, of which there are fewer than 20 a unit of t, errs by 1e-10 of d, what is bridged
      // by 1e-16 of |D| |D^-1|: the singular values are those of D but for that and its condition.
      for (std::size_t i = 0; i < qr.times.size(); ++i) {
        Matrix d = tangent_map(run, qr.times[i], chart);
        Vector logs = orthonormalise(d) / qr.times[i];
        std::sort(logs.begin(), logs.end(), std::greater<>());
        CAPTURE(qr.times[i]);
        CHECK((qr.history[i] - logs).norm() < 1e-8);
      }
    }
  }
}

TEST_CASE("finite-time exponents go on through 2 pi, where the linearised equation cannot") {
  // Through 2 pi at 2 pi - 1 about a fixed axis: D = 1 along it, (theta/2)/sin(theta/2) across, so
  // s = 1, s, s with s = (7/2 / sin(7/2)) / (1/2 / sin(1/2)) from theta = 1 to 7.
  const Run run = evolve(scene(Vector(0, 0, 1), 0, 6), Rotation(Vector(0, 0, 1), 1));
  const double s = std::abs(7 * std::sin(0.5) / std::sin(3.5));
  const Vector expected = Vector(std::log(s), std::log(s), 0) / 6;
  CHECK((finite_time_exponents(run, 6, Chart::kEulerVector) - expected).norm() < 1e-15);
  const std::vector<double> at = {0, 3, 6};
  const auto qr = lyapunov_spectrum(run, at, Chart::kEulerVector, LyapunovMethod::kQr);
  CHECK(qr.bridged == 1);
  CHECK((qr.history.back() - expected).norm() < 1e-10);
}

TEST_CASE("where a chart is singular there are no exponents, before and after there are") {
  // theta = pi at t = pi - 1: for all a double can tell.
  const Run run = evolve(scene(Vector(0, 0, 1), 0, 5), Rotation(Vector(0, 0, 1), 1));
  const std::vector<double> at = {1, pi - 1, 3, 4};
  for (const Chart chart : {Chart::kGibbs, Chart::kModifiedGibbs}) {
    for (const LyapunovMethod method : {LyapunovMethod::kExact, LyapunovMethod::kQr}) {
      const auto spectrum = lyapunov_spectrum(run, at, chart, method);
      CHECK(spectrum.singular == std::vector<double>{pi - 1});
      CHECK(spectrum.history[1].hasNaN());
      CHECK_FALSE(spectrum.history[0].hasNaN());
      // G = k tan(theta/2): along k (1 + G^2)/2, across sqrt(1 + G^2)/2. M: M0/2, 1/2, 1/2.
      const double ratio = std::cos(0.5) / std::abs(std::cos(2.0));
      const double t = 3;
      Vector expected = Vector(2 * std::log(ratio), std::log(ratio), std::log(ratio)) / t;
      if (chart == Chart::kModifiedGibbs) expected = Vector(0, 0, -std::log(ratio)) / t;
      CHECK((spectrum.history[2] - expected).norm() < 1e-10);
    }
  }
}

TEST_CASE("weighted averages find 0 to ten digits where finite-time values have one in 1e5") {
  const Run run = p15(40, 1e5);
  const auto spectrum =
      lyapunov_spectrum(run, times(0, 1e5, 100000), Chart::kEulerVector, LyapunovMethod::kExact);
  CHECK(spectrum.history.back()(0) > 1e-5);
  CHECK(std::abs(spectrum.local.weighted) <= 1e-10);
  // The error is that of halves, of half as many samples.
  CHECK(std::abs(spectrum.local.weighted) <= spectrum.local.weighted_error);
  CHECK(spectrum.local.weighted_error <= 1e-8);
  CHECK(std::abs(spectrum.local.plain) > 1e-6);
}

TEST_CASE("backward the exponents are those of the way back") {
  const Run run = p15(40, 100);
  const Run back = evolve(scene(turning(40), 100, 0), run(100).rotation());
  // D of the way back is the inverse.
  const Vector forward = finite_time_exponents(run, 100, Chart::kEulerVector);
  const Vector backward = finite_time_exponents(back, 0, Chart::kEulerVector);
  CHECK((forward + backward.reverse()).norm() * 100 < 48 * rotation_tolerance(back, 6));
  CHECK_NOTHROW(
      lyapunov_spectrum(back, std::vector<double>{100, 50, 0}, Chart::kGibbs, LyapunovMethod::kQr));
}

TEST_CASE("an incomplete run has its exponents up to where it came") {
  Scene stopped = scene(as_function(Vector(0, 0, 1)), 0, 100);
  stopped.method = Method::kDop853;
  stopped.max_steps = 20;
  const Run run = evolve(stopped, Rotation(Vector(1, 0, 0), 1));
  REQUIRE_FALSE(run.complete());
  const auto spectrum =
      lyapunov_spectrum(run, times(0, run.t1(), 10), Chart::kEulerVector, LyapunovMethod::kExact);
  CHECK(spectrum.times.back() == run.t1());
  CHECK(spectrum.history.back().allFinite());
}

TEST_CASE("exponents refuse what they have no answer to") {
  const Run run = p15(40, 10);
  const auto ask = [&run](std::vector<double> at) {
    return lyapunov_spectrum(run, at, Chart::kGibbs, LyapunovMethod::kExact);
  };
  CHECK_THROWS_WITH(ask({}), Contains("a time after the start"));
  CHECK_THROWS_WITH(ask({0}), Contains("a time after the start"));
  CHECK_THROWS_WITH(ask({1, 1}), Contains("got 1.0 after 1.0"));
  CHECK_THROWS_WITH(ask({2, 1}), Contains("got 1.0 after 2.0"));
  CHECK_THROWS_WITH(ask({-1}), Contains("got -1.0 after 0.0"));
  CHECK_THROWS_WITH(ask({std::nan("")}), Contains("nan"));
  CHECK_THROWS_AS(ask({1, 11}), std::out_of_range);
  CHECK(std::isnan(ask({1}).local.weighted));
  CHECK_THROWS_WITH(finite_time_exponents(run, 0, Chart::kGibbs), Contains("start"));
  const Run half_turn = run.with_start(Rotation(Vector(1, 0, 0), pi));
  for (const Chart chart : {Chart::kGibbs, Chart::kModifiedGibbs}) {
    CHECK_THROWS_WITH(finite_time_exponents(half_turn, 1, chart),
                      Contains("singular at the start, angle 3.14"));
  }
  const Run turn = run.with_start(Rotation(Vector(1, 0, 0), 2 * pi));
  CHECK_THROWS_WITH(finite_time_exponents(turn, 1, Chart::kEulerVector), Contains("start"));
  CHECK_THROWS_WITH(finite_time_exponents(turn, 1, Chart::kMrp), Contains("start"));
  CHECK_NOTHROW(finite_time_exponents(run.with_start(Rotation()), 1, Chart::kEulerVector));
  CHECK_THROWS_AS(lyapunov_spectrum(run, times(0, 10, 5), Chart::kGibbs, LyapunovMethod::kExact,
                                    [](double) { return false; }),
                  Interrupted);
}
