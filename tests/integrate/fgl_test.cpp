// The fast integrator: the accuracy asked for is kept, the estimate is honest, and little is spent.
#include "integrate/fgl.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "catch.hpp"
#include "closed_forms.hpp"
#include "integrate/propagator.hpp"

namespace {

using namespace rotor;
using closed_form::ExtendedQuaternion, closed_form::ExtendedVector, closed_form::rotation_error;

constexpr double kPi = std::numbers::pi;

using Function = std::function<Vector(double)>;
using Truth = std::function<ExtendedQuaternion(double)>;

// A function that says whether it is dear: that chooses one level or two.
class Given : public SpinModel {
 public:
  Given(Function function, bool dear) : function_(std::move(function)), dear_(dear) {}
  Vector value(double t) const override { return function_(t); }
  std::string description() const override { return "given"; }
  bool dear() const override { return dear_; }

 private:
  Function function_;
  bool dear_;
};

Scene scene(const Function& function, bool dear, double t0, double t1, double accuracy) {
  Scene s =
      closed_form::scene(AngularVelocity(std::make_shared<const Given>(function, dear)), t0, t1);
  s.accuracy = accuracy;
  return s;
}

Propagator follow(const Scene& s, const std::vector<double>& breaks = {},
                  const Observer& observer = {}) {
  Propagator run;
  run.t0 = s.t0;
  follow_by_fgl(s, breaks, observer, run);
  return run;
}

// At times evenly from the start to the end, and at the end.
double greatest_error(const Propagator& run, const Truth& truth, int times = 200) {
  double greatest = rotation_error(run.flow->at(run.t1), truth(run.t1));
  for (int i = 0; i < times; ++i) {
    const double t = run.t0 + (run.t1 - run.t0) * ((i + 0.382) / times);
    const double error = rotation_error(run.flow->at(t), truth(t));
    if (!(error <= greatest)) greatest = error;  // NaN stays
  }
  return greatest;
}

// U from t0 for omega = s (cos a(t - origin), sin a(t - origin), 0) [theory 4.4].
struct Turning {
  double a;
  double s = 1;
  double t0 = 0;
  double origin = 0;

  Vector operator()(double t) const {
    const double phase = a * (t - origin);
    return {s * std::cos(phase), s * std::sin(phase), 0};
  }
  ExtendedQuaternion from_origin(double t) const {
    const Extended x = Extended{t} - Extended{origin};
    return closed_form::turn({0, 0, a * x}) * closed_form::turn({s * x, 0, -a * x});
  }
  ExtendedQuaternion truth(double t) const { return from_origin(t) * from_origin(t0).conjugate(); }
};

Vector mixed(double t) {
  return {std::sin(3 * t) + 0.3 * std::cos(17 * t), std::exp(-t / 50) * std::cos(t * t / 40),
          0.5 * std::log(1 + t)};
}

void check_promise(const Propagator& run, double asked, double error) {
  INFO("asked " << asked << "  error " << error << "  estimate " << run.error_estimate);
  REQUIRE(!run.stop);
  CHECK(error <= std::max(asked, run.error_estimate));
  CHECK(error <= run.error_estimate);
}

}  // namespace

TEST_CASE("fgl keeps the accuracy asked for, on one level and on two") {
  struct Problem {
    Turning motion;
    double t1;
  };
  const std::vector<Problem> problems = {{{2 * kPi / 40}, 4200},
                                         {{2 * kPi / 40}, -420},
                                         {{2}, 420},
                                         {{100}, 10},
                                         {{1e-3, 1e4}, 0.1},
                                         {{1e-8, 1e-8}, 1e9},
                                         {{1e-9, 1}, 100},
                                         {{0.5, 1, 1e9, 1e9}, 1e9 + 100},
                                         // a t is not exact, and with steps of one length would
                                         // round alike in all of them.
                                         {{0.15, 1, 1e7}, 1e7 + 100},
                                         {{0.15, 1, 1e9}, 1e9 + 100},
                                         {{0.3, 1, 1e7}, 1e7 + 100},
                                         {{0.1, 1, 1e5}, 1e5 + 1000},
                                         {{0.5, 1, -1e6, -1e6}, -1e6 - 100}};
  for (const Problem& problem : problems) {
    const Turning& motion = problem.motion;
    const double t1 = problem.t1;
    for (const bool dear : {false, true}) {
      for (const double accuracy : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-16}) {
        CAPTURE(motion.a, motion.s, motion.t0, t1, dear);
        const Propagator run = follow(scene(motion, dear, motion.t0, t1, accuracy));
        check_promise(run, accuracy,
                      greatest_error(run, [&](double t) { return motion.truth(t); }));
        CHECK(run.t1 == t1);
        CHECK(run.accuracy == accuracy);
      }
    }
  }
}

TEST_CASE("what fgl reports where rounding forbids more is within ten times of the truth") {
  for (const auto& [a, t1] :
       {std::pair{2 * kPi / 40, 4200.0}, std::pair{2.0, 4200.0}, std::pair{100.0, 100.0}}) {
    const Turning motion{a};
    for (const bool dear : {false, true}) {
      // One draw of the rounding may be small: the greatest of four.
      double greatest = 0;
      double reported = 0;
      for (const double accuracy : {1e-16, 1e-15, 1e-14, 1e-13}) {
        const Propagator run = follow(scene(motion, dear, 0, t1, accuracy));
        const double error = greatest_error(run, [&](double t) { return motion.truth(t); });
        CHECK(error <= run.error_estimate);
        greatest = std::max(greatest, error);
        reported = std::max(reported, run.error_estimate);
      }
      CAPTURE(a, dear, 1e13 * greatest, 1e13 * reported);
      CHECK(reported <= 10 * greatest);
      CHECK(greatest <= 2e-12);
    }
  }
}

TEST_CASE("asked for less than the rounding of omega allows, one level averages more samples") {
  const Turning motion{2 * kPi / 40};
  const Truth truth = [&](double t) { return motion.truth(t); };
  const Propagator loose = follow(scene(motion, false, 0, 4200, 1e-11));
  const Propagator least = follow(scene(motion, false, 0, 4200, 1e-16));
  CHECK(least.cost.omega_calls > 3 * loose.cost.omega_calls);
  CHECK(least.cost.omega_calls < 6 * loose.cost.omega_calls);
  // Half an ulp of a t, evenly distributed, across the axis at each of N samples spread over the
  // run: at random T u (a T) / 3 sqrt(2/N) a component, some three times that at most.
  const double samples = static_cast<double>(least.cost.omega_calls);
  const double spread = 4200 * (0x1p-53 * motion.a * 4200) / 3 * std::sqrt(2 / samples);
  CHECK(greatest_error(least, truth, 20) < 3 * spread);
}

TEST_CASE("two levels call omega as seldom as the samples can tell it") {
  // Two samples a wave are Nyquist's; 64 nodes a panel take 2.2 to 1e-13.
  const auto calls = [](const Function& function, double t1) {
    return follow(scene(function, true, 0, t1, 1e-9)).cost.omega_calls;
  };
  CHECK(calls(Turning{2 * kPi / 40}, 4200) <= 1300);
  CHECK(calls(Turning{2}, 4200) <= 11'000);
  CHECK(calls(Turning{100}, 100) <= 11'000);
  CHECK(calls(mixed, 50) <= 1100);
}

TEST_CASE("fgl and DOP853 agree about a motion that has no closed form") {
  for (const bool dear : {false, true}) {
    Scene s = scene(mixed, dear, 0, 50, 1e-10);
    const Propagator run = follow(s);
    s.method = Method::kDop853;
    const Propagator other = propagate(s);
    for (int i = 0; i <= 100; ++i) {
      const double t = 0.5 * i;
      const double apart = rotation_error(run.flow->at(t), other.flow->at(t).cast<Extended>());
      CHECK(apart <= run.error_estimate + 1.25 * other.error_estimate);
    }
  }
}

TEST_CASE(
    "between the ends of steps a fast swing about a nearly fixed axis is as right as at them") {
  // A step of such a motion is right at its end, as Gauss's formula is there, long before 18 values
  // on its half resolve it.
  for (const bool dear : {false, true}) {
    for (const auto& [size, rate] : {std::pair{3.0, 3.0}, std::pair{6.0, 9.5}, {20.0, 6.0}}) {
      const Function swing = [size = size, rate = rate](double t) {
        return Vector(1e-6, 0, size * std::cos(rate * t));
      };
      Scene finest = scene(swing, dear, 0, 15, 1e-13);
      finest.method = Method::kDop853;
      const Propagator other = propagate(finest);
      for (const double accuracy : {1e-4, 1e-8, 1e-10, 1e-12}) {
        CAPTURE(dear, size, rate, accuracy);
        const Propagator run = follow(scene(swing, dear, 0, 15, accuracy));
        check_promise(run, accuracy, [&] {
          double greatest = 0;
          for (int i = 0; i <= 400; ++i) {
            const double t = 15 * i / 400.0;
            greatest = std::max(
                greatest, rotation_error(run.flow->at(t), other.flow->at(t).cast<Extended>()));
          }
          return std::max(0.0, greatest - 1.25 * other.error_estimate);
        }());
      }
    }
  }
}

TEST_CASE("a fixed direction costs one turn a panel, however fast") {
  for (const double size : {1.0, 1e8}) {
    const Function function = [size](double t) {
      return Vector(0, 0, size * (1 + 0.5 * std::cos(t)));
    };
    const Propagator run = follow(scene(function, true, 0, 10, 1e-9));
    CHECK(run.cost.steps < 40);
    check_promise(run, 1e-9, greatest_error(run, [size](double t) {
                    const Extended x = t;
                    return closed_form::turn({0, 0, size * (x + std::sin(x) / 2)});
                  }));
  }
  // A constant is as good as its double, and the time: angles of 1e9 to 64 binary digits.
  const Function constant = [](double) { return Vector(1e8, 0, 0); };
  const Propagator run = follow(scene(constant, true, 0, 10, 1e-9));
  const Truth truth = [](double t) { return closed_form::turn({1e8L * t, 0, 0}); };
  check_promise(run, 1e-9, greatest_error(run, truth));
  CHECK_THROWS_AS(run.flow->mesh(), std::length_error);
}

TEST_CASE("nothing, next to nothing, and the least that there is") {
  for (const bool dear : {false, true}) {
    CAPTURE(dear);
    for (const double size : {0.0, 5e-324, 1e-300}) {
      const Propagator run = follow(scene(
          [size](double t) { return Vector(size * std::cos(t), size, 0); }, dear, 0, 100, 1e-9));
      check_promise(run, 1e-9,
                    greatest_error(run, [](double) { return ExtendedQuaternion::Identity(); }));
      CHECK(run.flow->at(50).w() == 1);
    }
    for (const auto& [t0, t1] : {std::pair{1.0, std::nextafter(1.0, 2)}, std::pair{0.0, 5e-324},
                                 std::pair{0.0, -1e-310}, std::pair{3.0, 3.0}}) {
      CAPTURE(t0, t1);
      const Propagator run =
          follow(scene([](double t) { return Vector(1, t, 0); }, dear, t0, t1, 1e-9));
      CHECK(!run.stop);
      CHECK(run.t1 == t1);
      CHECK(run.flow->at(t1).w() == 1);
      CHECK(run.flow->mesh().front() == t0);
      CHECK(run.flow->mesh().back() == t1);
    }
  }
}

TEST_CASE("omega may be zero for a while, bend and jump") {
  // About z, so that the integral is the motion.
  const auto along = [](const std::function<Extended(Extended)>& angle) -> Truth {
    return [angle](double t) { return closed_form::turn({0, 0, angle(t) - angle(0)}); };
  };
  const auto pulse = [](double t) {
    return Vector(0, 0, t < 2 || t > 6 ? 0 : std::pow((t - 2) * (6 - t), 3));
  };
  const Truth pulse_truth = along([](Extended t) {
    const Extended y = std::min(std::max(t, 2.0L), 6.0L) - 4;
    const Extended square = y * y;
    return y * (64 - square * (16 - square * (2.4L - square / 7)));
  });
  const auto bend = [](double t) { return Vector(0, 0, std::abs(t - 3.3)); };
  const Truth bend_truth = along([](Extended t) {
    const Extended y = t - Extended{3.3};
    return y * std::abs(y) / 2;
  });
  const auto root = [](double t) { return Vector(0, 0, std::sqrt(t)); };
  const Truth root_truth = along([](Extended t) { return t * std::sqrt(t) * 2 / 3; });
  for (const bool dear : {false, true}) {
    for (const double accuracy : {1e-5, 1e-8, 1e-11}) {
      CAPTURE(dear);
      for (const auto& [omega, truth] : {std::pair<Function, Truth>{pulse, pulse_truth},
                                         {bend, bend_truth},
                                         {root, root_truth}}) {
        const Propagator run = follow(scene(omega, dear, 0, 8, accuracy));
        REQUIRE(!run.stop);
        const double error = greatest_error(run, truth);
        CAPTURE(accuracy, error / accuracy, run.error_estimate / accuracy);
        CHECK(error <= accuracy);
      }
    }
  }
}

TEST_CASE("a jump anywhere, of any size, costs calls and not accuracy") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> even(0, 1);
  for (int i = 0; i < 60; ++i) {
    const double at = 10 * even(random);
    const double size = std::pow(10, -6 * even(random));
    const closed_form::Piecewise motion{{at}, {Vector(1, 0, 0), Vector(1, size, 0)}};
    const AngularVelocity omega = motion.omega();
    const Function function = [&omega](double t) { return omega(t); };
    for (const bool dear : {false, true}) {
      CAPTURE(i, at, size, dear);
      const Propagator run = follow(scene(function, dear, 0, 10, 1e-9));
      REQUIRE(!run.stop);
      CHECK(greatest_error(run, motion) <= 1e-9);
      CHECK(run.cost.omega_calls < 20'000);
      // Told where, it costs nothing.
      const Propagator told = follow(scene(function, dear, 0, 10, 1e-9), {at});
      CHECK(greatest_error(told, motion) <= 1e-13);
      CHECK(told.cost.rejected == 0);
    }
  }
}

TEST_CASE("in the body frame the flow is that of -omega") {
  // Q' = Q omega / 2 from 1 is U*, and omega constant in a turning frame has a closed form too.
  const Turning motion{0.7, -1};
  for (const bool dear : {false, true}) {
    Scene s = scene(Turning{0.7}, dear, 0, 50, 1e-10);
    s.omega = s.omega.in_body_frame();
    const Propagator run = follow(s);
    check_promise(run, 1e-10, greatest_error(run, [&](double t) { return motion.truth(t); }));
    CHECK((run.flow->generator(20) + s.omega(20)).norm() < 1e-8);
  }
}

TEST_CASE(
    "between the ends of its steps the flow is smooth, unit, and moves as its generator says") {
  const Turning motion{2 * kPi / 40};
  for (const bool dear : {false, true}) {
    for (const double t1 : {420.0, -420.0}) {
      const Propagator run = follow(scene(motion, dear, 0, t1, 1e-9));
      const Flow& flow = *run.flow;
      CHECK(flow.at(0).coeffs() == Eigen::Vector4d(0, 0, 0, 1));
      const std::vector<double> mesh = flow.mesh();
      CHECK(mesh.front() == 0);
      CHECK(mesh.back() == t1);
      const double forward = t1 > 0 ? 1 : -1;
      for (std::size_t i = 1; i < mesh.size(); ++i) {
        CHECK(forward * (mesh[i] - mesh[i - 1]) > 0);
        CHECK(std::abs(mesh[i] - mesh[i - 1]) <= 6.0001);  // |omega| = 1
      }
      for (std::size_t i = 0; i + 1 < mesh.size(); ++i) {
        for (const double part : {0.0, 0.2, 0.5, 0.8}) {
          const double t = mesh[i] + (mesh[i + 1] - mesh[i]) * part;
          const double dt = 1e-4 * forward;
          if (std::abs(t + dt) > std::abs(t1)) continue;
          const Quaternion q = flow.at(t);
          CHECK(std::abs(q.norm() - 1) < 4e-16);
          // The chord over dt is the tangent at its middle, to dt^2/24 of the third derivative 1/8;
          // differences of 1e-16 make 1e-12. At once the value is continuous there.
          const Quaternion next = flow.at(t + dt);
          const Vector rate = 2 / dt * (next * q.conjugate()).vec();
          CHECK((rate - flow.generator(t + dt / 2)).norm() < 1e-9);
          // The defect is what the error is made of.
          CHECK((flow.generator(t) - motion(t)).norm() < 1e-8);
        }
      }
    }
  }
}

TEST_CASE("fgl stops with a reason and keeps the part done") {
  const Turning motion{2 * kPi / 40};
  const Truth truth = [&](double t) { return motion.truth(t); };
  const auto check_part = [&](const Propagator& run, const std::string& reason) {
    REQUIRE(run.stop);
    CHECK(run.stop->reason == reason);
    CHECK(run.t1 == run.stop->t);
    CHECK(run.flow->mesh().back() == run.t1);
    if (run.t1 != 0) CHECK(greatest_error(run, truth, 20) <= 1e-9);
  };
  for (const bool dear : {false, true}) {
    CAPTURE(dear);
    Scene limited = scene(motion, dear, 0, 4200, 1e-9);
    limited.max_steps = 7;
    check_part(follow(limited), "step limit");
    check_part(follow(scene(motion, dear, 0, 4200, 1e-9), {}, [](double t) { return t < 600; }),
               "interrupted");
    for (int call = 1; call <= 100; ++call) {
      CAPTURE(call);
      int calls = 0;
      const auto failing = [&](double value) {
        return [&, value](double t) {
          if (++calls == call && std::isinf(value)) throw std::runtime_error("line 7");
          return calls == call ? Vector(value, 0, 0) : motion(t);
        };
      };
      const double infinity = std::numeric_limits<double>::infinity();
      const Propagator thrown = follow(scene(failing(infinity), dear, 0, 60, 1e-9));
      CHECK(thrown.cost.omega_calls == static_cast<std::size_t>(call));
      REQUIRE(thrown.stop);
      CHECK(thrown.stop->message == "line 7");
      CHECK(thrown.stop->cause != nullptr);
      // The part done would call omega again, which counts on.
      calls = call;
      check_part(thrown, "omega failed");
      calls = 0;
      const Propagator nan = follow(scene(failing(std::nan("")), dear, 0, 60, 1e-9));
      calls = call;
      check_part(nan, "omega failed");
    }
    // Too fast for doubles to follow.
    Scene huge = scene(Turning{1, 1e300}, dear, 0, 1, 1e-9);
    huge.max_steps = 2000;
    const Propagator run = follow(huge);
    REQUIRE(run.stop);
    CHECK(run.stop->reason == (dear ? "accuracy lost" : "step limit"));
    CHECK(run.flow->at(run.t1).coeffs().allFinite());
  }
}

TEST_CASE("max_step is kept, and a narrow pulse is then seen") {
  const Function pulse = [](double t) { return Vector(0, 0, std::exp(-1e4 * (t - 5) * (t - 5))); };
  const Truth truth = [](double t) {
    return closed_form::turn({0, 0,
                              (std::erf(100 * (Extended{t} - 5)) + std::erf(500.0L)) *
                                  std::sqrt(std::numbers::pi_v<Extended>) / 200});
  };
  for (const bool dear : {false, true}) {
    Scene s = scene(pulse, dear, 0, 10, 1e-9);
    s.max_step = dear ? 0.5 : 0.1;
    const Propagator run = follow(s);
    check_promise(run, 1e-9, greatest_error(run, truth));
    const std::vector<double> mesh = run.flow->mesh();
    for (std::size_t i = 1; i < mesh.size(); ++i)
      CHECK(mesh[i] - mesh[i - 1] <= 1.0001 * *s.max_step);
  }
}
