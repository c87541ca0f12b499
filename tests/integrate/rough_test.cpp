// omega that is not smooth, or of extreme size or time: the accuracy is kept all the same, or the
// run says where it stopped.
#include <cmath>
#include <limits>
#include <random>

#include "catch.hpp"
#include "closed_forms.hpp"
#include "integrate/loop.hpp"

namespace {

using namespace rotor;
using closed_form::by_dop853, closed_form::greatest_error, closed_form::Piecewise,
    closed_form::scene, closed_form::to_accuracy, closed_form::Turning;

template <class Truth>
void check_promise(const Propagator& run, const Truth& truth) {
  const double error = greatest_error(run, truth);
  INFO("asked " << run.accuracy << "  error " << error << "  estimate " << run.error_estimate);
  REQUIRE(!run.stop);
  CHECK(error <= std::max(run.accuracy, run.error_estimate));
  CHECK(run.error_estimate >= 0.8 * error);
}

Vector random_vector(std::mt19937& generator) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  return {uniform(generator), uniform(generator), uniform(generator)};
}

}  // namespace

TEST_CASE("across a jump of omega the accuracy is kept and the estimate is honest") {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int trial = 0; trial < 100; ++trial) {
    CAPTURE(trial);
    const Piecewise motion{{1.5 + 0.5 * uniform(generator)},
                           {random_vector(generator), random_vector(generator)}};
    for (const double accuracy : {1e-4, 1e-7, 1e-10}) {
      check_promise(propagate(to_accuracy(accuracy, scene(motion.omega(), 0, 3))), motion);
    }
  }
}

TEST_CASE("a square wave of fifty jumps") {
  Piecewise motion;
  for (int i = 1; i <= 51; ++i) {
    if (i <= 50) motion.t.push_back(0.37 * i);
    motion.value.push_back(i % 2 == 0 ? Vector(0, 1, 0.5) : Vector(1, 0, 0));
  }
  for (const double accuracy : {1e-4, 1e-6, 1e-8, 1e-10}) {
    check_promise(propagate(to_accuracy(accuracy, scene(motion.omega(), 0, 19))), motion);
  }
}

TEST_CASE("omega that rests for a while") {
  const Piecewise motion{{1, 2}, {Vector(0, 1, 0), Vector::Zero(), Vector(1, 0, 0)}};
  for (const double accuracy : {1e-4, 1e-8, 1e-11}) {
    check_promise(propagate(to_accuracy(accuracy, scene(motion.omega(), 0, 3))), motion);
  }
}

TEST_CASE("a jump at t = 0, where t resolves everything, and at t = 1e9, where it does not") {
  const Piecewise after{{1}, {Vector(0, 0, 1), Vector(1.5, 0, 0)}};
  const auto shifted = [&](double shift) {
    return AngularVelocity([&after, shift](double t) { return after.omega()(t - shift); });
  };
  for (const double accuracy : {1e-4, 1e-8}) {
    check_promise(propagate(to_accuracy(accuracy, scene(shifted(-1), -1, 1))),
                  [&](double t) { return after(t + 1); });
  }
  check_promise(propagate(to_accuracy(1e-4, scene(shifted(1e9), 1e9, 1e9 + 3))),
                [&](double t) { return after(t - 1e9); });
  // ulp(1e9) is 1.2e-7: 1e-10 cannot be kept. One method says what was reached, the other stops.
  const Propagator reached = propagate(to_accuracy(1e-10, scene(shifted(1e9), 1e9, 1e9 + 3)));
  check_promise(reached, [&](double t) { return after(t - 1e9); });
  CHECK(reached.error_estimate > 1e-10);
  // The jump, by |(-1.5, 0, 1)| rad per unit of t, lies in a step of at most twice the shortest:
  // wherever in it, that is their product at most.
  CHECK(reached.error_estimate < std::hypot(1.5, 1.0) * 2 * shortest_step(1e9));
  const Propagator stopped =
      propagate(closed_form::by_dop853(1e-10, scene(shifted(1e9), 1e9, 1e9 + 3)));
  REQUIRE(stopped.stop);
  CHECK(stopped.stop->reason == "step underflow");
  CHECK(stopped.stop->t == Approx(1e9 + 1).epsilon(0).margin(1e-4));
}

TEST_CASE("omega that is nearly constant, constant or zero is cheap as a function too") {
  const auto along_x = [](double size) {
    return [size](double t) { return closed_form::turn({Extended{size} * t, 0, 0}); };
  };
  const Propagator resting =
      propagate(scene(AngularVelocity([](double) { return Vector(0, 0, 0); }), 0, 1e9));
  CHECK(resting.cost.steps < 40);  // a step is a 32nd of the way at most
  CHECK(greatest_error(resting, along_x(0)) == 0);
  check_promise(propagate(scene(AngularVelocity([](double) { return Vector(1, 0, 0); }), 0, 100)),
                along_x(1));
  // 1e-12 sin t across i: at most 2e-12 of turning aside in all.
  const Propagator run = propagate(
      scene(AngularVelocity([](double t) { return Vector(1, 1e-12 * std::sin(t), 0); }), 0, 100));
  CHECK(greatest_error(run, along_x(1)) <= 1e-10 + 2e-12 * 100);
}

TEST_CASE("after a jump the next ones are no noise") {
  std::mt19937 generator(4);
  for (int trial = 0; trial < 20; ++trial) {
    Piecewise motion{{}, {random_vector(generator)}};
    for (int i = 1; i <= 12; ++i) {
      motion.t.push_back(0.7 * i);
      motion.value.push_back(random_vector(generator));
    }
    for (const double accuracy : {1e-9, 1e-11, 1e-12}) {
      CAPTURE(trial, accuracy);
      const Propagator run = propagate(by_dop853(accuracy, scene(motion.omega(), 0, 9)));
      REQUIRE(!run.stop);
      // The estimate is good to a fifth.
      CHECK(greatest_error(run, motion) <= std::max(accuracy, run.error_estimate / 0.8));
    }
  }
}

TEST_CASE("the same motion fast or slow: |omega| from 1e-300 to 1e300") {
  // The error estimate need not differ by more than the rounding of s t.
  const double a = 2 * std::numbers::pi / 40;
  for (const double s : {1.0, 1e8, 1e-8, 1e-150, 1e-300, 1e150, 1e160, 1e300}) {
    INFO("s " << s);
    const Turning motion{a, s};
    check_promise(propagate(to_accuracy(1e-9, scene(motion.omega(), 0, 400 / s))), motion);
    const Propagator fixed =
        propagate(closed_form::by_rk4(0.2 / s, scene(motion.omega(), 0, 100 / s)));
    CHECK(fixed.error_estimate == Approx(greatest_error(fixed, motion)).epsilon(0.1));
  }
}

TEST_CASE("of a slow motion only the rounding of the quaternion is stated") {
  for (const double size : {1e-8, 1e-300}) {
    const AngularVelocity omega(
        [size](double t) { return Vector(size * std::cos(t), size * std::sin(2 * t), 0); });
    for (const Scene& s : {closed_form::to_accuracy(1e-10, scene(omega, 0, 10)),
                           by_dop853(1e-10, scene(omega, 0, 10))}) {
      const Propagator run = propagate(s);
      CAPTURE(size, run.method);
      // Four components of half an ulp, and what its steps add to so little.
      CHECK(run.error_estimate < 4 * std::numeric_limits<double>::epsilon());
      // The integrals of omega: the body has not turned yet.
      const double t = 7.3;
      const Vector turned(size * std::sin(t), size * std::pow(std::sin(t), 2), 0);
      CHECK((2 * run(t).vec() - turned).norm() <= std::min(run.error_estimate, 1e-6 * size));
    }
  }
}

TEST_CASE("where waves cancel, their rounding does not, and steps are not shortened for it") {
  // At t = 15.7487 sin 3t + 0.3 cos 17t stands still.
  const AngularVelocity omega([](double t) {
    return Vector(std::sin(3 * t) + 0.3 * std::cos(17 * t),
                  std::exp(-t / 50) * std::cos(t * t / 40), 0.5 * std::log(1 + t));
  });
  const Propagator run = propagate(by_dop853(1e-12, scene(omega, 0, 20)));
  REQUIRE(!run.stop);
  CHECK(run.cost.steps < 3000);
}

TEST_CASE("a run may start late, be short, and turn fast") {
  // From t0 = 1e9, where ulp(t) is 1.2e-7; times are multiples of that ulp, so t - t0 is exact.
  for (const double length : {1.0, 0.0625, 0.0009765625}) {
    for (const double size : {1.0, 3000.0}) {
      CAPTURE(length, size);
      const auto truth = [&](double t) {
        return closed_form::turn({0, Extended{size} * (Extended{t} - 1e9L), 0});
      };
      const AngularVelocity omega([=](double) { return Vector(0, size, 0); });
      const Propagator run = propagate(to_accuracy(1e-3, scene(omega, 1e9, 1e9 + length)));
      check_promise(run, truth);
    }
  }
}

TEST_CASE("a run of the shortest length there is") {
  const Propagator run =
      propagate(scene(AngularVelocity([](double) { return Vector(1, 0, 0); }), 0, 5e-324));
  CHECK(!run.stop);
  // sin(5e-324 / 2) lies halfway between 0 and the smallest double.
  CHECK((run(5e-324).coeffs() - Eigen::Vector4d(0, 0, 0, 1)).norm() <= 5e-324);
}

TEST_CASE("a jump to any finite omega is resolved or refused, never lost in overflow") {
  for (const double size : {1e8, 1e30, 1e100, 1e300}) {
    double worst_t = 0;
    const AngularVelocity omega([&](double t) {
      if (!(t >= worst_t)) worst_t = t;  // NaN is caught; t goes no way but forward on the whole
      return t < 0.5 ? Vector(0, 0, 1) : Vector(0, size, 0);
    });
    Scene s = to_accuracy(1e-6, scene(omega, 0, 1));
    s.max_steps = 2000;
    const Propagator run = propagate(s);
    INFO("size " << size);
    REQUIRE(run.stop);  // 1e7 turns and more to come
    CHECK(run.t1 == Approx(0.5).epsilon(0).margin(1e-3));
    CHECK(std::isfinite(run.error_estimate));
    CHECK(!std::isnan(worst_t));
  }
}

TEST_CASE("a fixed step that is far too long for omega is never taken for a result") {
  // Past |omega| h of 2.8 the method is unstable: the estimate says so, or the run stops.
  for (const double size : {3.0, 10.0, 1e3, 1e10, 1e100, 1e300}) {
    const Propagator run = propagate(closed_form::by_rk4(
        1, scene(AngularVelocity([size](double) { return Vector(0, 0, size); }), 0, 10)));
    INFO("size " << size << "  estimate " << run.error_estimate);
    CHECK((run.stop || !(run.error_estimate < 0.1)));
    CHECK(run(run.t1).coeffs().allFinite());
  }
}

TEST_CASE("max_step finds what the samples would miss") {
  // A spike of width 0.1 within 100: without max_step no sample need fall on it.
  const AngularVelocity omega(
      [](double t) { return Vector(0, 0, std::exp(-100 * (t - 50) * (t - 50))); });
  Scene s = to_accuracy(1e-8, scene(omega, 0, 100));
  s.max_step = 0.5;
  const Propagator run = propagate(s);
  const double whole = std::sqrt(std::numbers::pi / 100);  // the integral; the tails are e^-250000
  CHECK(closed_form::rotation_error(run(100), closed_form::turn({0, 0, whole})) <= 1e-8);
  const std::vector<double> mesh = run.flow->mesh();
  for (std::size_t i = 1; i < mesh.size(); ++i) REQUIRE(mesh[i] - mesh[i - 1] <= 0.5 * (1 + 1e-12));
}

TEST_CASE("a fixed step across a jump of omega says how far off it may be") {
  std::mt19937 generator(4);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int trial = 0; trial < 100; ++trial) {
    CAPTURE(trial);
    const Piecewise motion{{1.5 + uniform(generator)},
                           {random_vector(generator), random_vector(generator)}};
    const Propagator run = propagate(closed_form::by_rk4(0.05, scene(motion.omega(), 0, 3)));
    const double error = closed_form::rotation_error(run(3), motion(3));
    CHECK(run.error_estimate >= 0.8 * error);
  }
}
