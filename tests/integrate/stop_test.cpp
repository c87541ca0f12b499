// Runs that stop early, and requests that cannot be.
#include <limits>
#include <stdexcept>

#include "catch.hpp"
#include "closed_forms.hpp"

namespace {

using namespace rotor;
using Catch::Matchers::Contains;
using closed_form::scene, closed_form::to_accuracy;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

const closed_form::Turning kMotion = closed_form::turning(40);

// The part done is a run in its own right: to where it says, and as good as it says.
void check_part(const Propagator& run) {
  REQUIRE(run.stop);
  CHECK(run.t1 == run.stop->t);
  CHECK(!run.stop->message.empty());
  CHECK(run.flow->mesh().back() == run.t1);
  const double error = closed_form::greatest_error(run, kMotion, 50);
  INFO("error " << error << "  estimate " << run.error_estimate);
  CHECK(error <= std::max(run.accuracy, 1.25 * run.error_estimate));
  CHECK(run.error_estimate >= 0.8 * error);
}

struct ScriptError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// kMotion, but at its call number `last` it throws or gives what it likes.
template <class Last>
AngularVelocity failing_at(std::size_t last, Last give) {
  return AngularVelocity([omega = kMotion.omega(), last, give, call = std::size_t{0}](
                             double t) mutable { return ++call == last ? give(t) : omega(t); },
                         "spin");
}

}  // namespace

namespace {

// Those of the times that are in the run's mesh, which may be finer than its steps.
std::vector<double> nodes_of(const Propagator& run, std::vector<double> times) {
  const std::vector<double> mesh = run.flow->mesh();
  std::erase_if(times,
                [&](double t) { return std::find(mesh.begin(), mesh.end(), t) == mesh.end(); });
  return times;
}

}  // namespace

TEST_CASE("an observer stops a run, and sees every node before that") {
  for (const double end : {100.0, -100.0}) {
    for (const bool fixed : {false, true}) {
      Scene s = to_accuracy(1e-8, scene(kMotion.omega(), 0, end));
      if (fixed) s = closed_form::by_rk4(0.1, s);
      std::vector<double> seen;
      const Propagator run = propagate(s, [&](double t) {
        seen.push_back(t);
        return std::abs(t) < 30;
      });
      check_part(run);
      CHECK(run.stop->reason == "interrupted");
      CHECK(run.stop->cause == nullptr);
      CHECK(std::abs(run.t1) >= 30);
      seen.erase(std::unique(seen.begin(), seen.end()), seen.end());  // rejected steps
      CHECK(nodes_of(run, seen) == seen);
    }
  }
  const Propagator none = propagate(scene(kMotion.omega(), 3, 4), [](double) { return false; });
  CHECK(none.t1 == 3);
  CHECK(none(3).coeffs() == Eigen::Vector4d(0, 0, 0, 1));
  CHECK(none.cost.omega_calls == 0);
}

TEST_CASE("max_steps ends a run") {
  Scene s = to_accuracy(1e-8, scene(kMotion.omega(), 0, 1000));
  s.max_steps = 50;
  const Propagator run = propagate(s);
  check_part(run);
  CHECK(run.stop->reason == "step limit");
  CHECK_THAT(run.stop->message, Contains("max_steps = 50"));
  CHECK(run.cost.steps + run.cost.rejected == 50);
}

TEST_CASE("omega may throw at any call: the cause and the part done are kept") {
  for (const bool fixed : {false, true}) {
    for (std::size_t call = 1; call <= 100; ++call) {
      CAPTURE(fixed, call);
      Scene s = to_accuracy(
          1e-8,
          scene(failing_at(call, [](double) -> Vector { throw ScriptError("line 7"); }), 0, 60));
      if (fixed) s = closed_form::by_rk4(0.5, s);
      const Propagator run = propagate(s);
      check_part(run);
      CHECK(run.stop->reason == "omega failed");
      CHECK(run.stop->message == "line 7");
      CHECK(run.cost.omega_calls == call);
      REQUIRE(run.stop->cause != nullptr);
      CHECK_THROWS_AS(std::rethrow_exception(run.stop->cause), ScriptError);
    }
  }
}

TEST_CASE("what omega throws that is no std::exception is not caught") {
  CHECK_THROWS_AS(propagate(scene(AngularVelocity([](double) -> Vector { throw 42; }), 0, 1)), int);
}

TEST_CASE("omega that gives NaN or infinity stops a run, and the message shows it") {
  for (const double bad : {kNaN, kInfinity, -kInfinity}) {
    for (const std::size_t call : {1u, 2u, 20u, 50u}) {
      double where = kNaN;
      const Propagator run = propagate(scene(failing_at(call,
                                                        [&where, bad](double t) {
                                                          where = t;
                                                          return Vector(0, bad, 0);
                                                        }),
                                             0, 60));
      check_part(run);
      CHECK(run.stop->reason == "omega failed");
      CHECK_THROWS_AS(std::rethrow_exception(run.stop->cause), NonFiniteOmega);
      CHECK_THAT(run.stop->message, Contains("spin gave") && Contains("t = " + text(where)) &&
                                        Contains(text(Vector(0, bad, 0))));
    }
  }
}

TEST_CASE("a singularity of omega is found, and t is there") {
  // 1/|t - 1| turns through a logarithm: from 0 to 1 - d by -ln d, without limit. Either the steps
  // end, or a node falls on t = 1 itself; never is it passed over.
  const AngularVelocity omega([](double t) { return Vector(0, 0, 1 / std::abs(t - 1)); });
  for (const double accuracy : {1e-3, 1e-6, 1e-10}) {
    const Propagator run = propagate(to_accuracy(accuracy, scene(omega, 0, 2)));
    CAPTURE(accuracy);
    REQUIRE(run.stop);
    INFO(run.stop->message);
    CHECK((run.stop->reason == "step underflow" || run.stop->reason == "omega failed" ||
           run.stop->reason == "accuracy lost"));
    CHECK(run.stop->t == Approx(1).epsilon(0).margin(1e-6));
    CHECK_THAT(run.stop->message, !Contains("t = nan"));
    // Up to t the angle is -ln(1 - t); 1 - t is exact, and omega has the rounding of 1 - t.
    const double t = 0.999;
    CHECK(closed_form::rotation_error(
              run(t), closed_form::turn({0, 0, -std::log1p(-Extended{t})})) < accuracy);
  }
}

TEST_CASE("an interval of no length is a run of no steps") {
  for (const Scene& s : {scene(kMotion.omega(), 5, 5), scene(Vector(0, 0, 1), 5, 5),
                         closed_form::by_rk4(0.1, scene(kMotion.omega(), 5, 5))}) {
    const Propagator run = propagate(s);
    CHECK(!run.stop);
    CHECK(run.t1 == 5);
    CHECK(run(5).coeffs() == Eigen::Vector4d(0, 0, 0, 1));
    CHECK(run.cost.steps == 0);
    CHECK(run.cost.omega_calls == 0);
    CHECK(run.error_estimate < 1e-15);
  }
}

TEST_CASE("a run says which method it took and why") {
  CHECK(propagate(scene(Vector(0, 0, 1), 0, 1)).why == "constant omega, Theorem 4.1");
  const Propagator function = propagate(to_accuracy(1e-5, scene(kMotion.omega(), 0, 1)));
  CHECK(function.method == "fgl");
  CHECK(function.why == "omega is cheap to call: one level");
  CHECK(function.accuracy == 1e-5);
  const Propagator asked = propagate(closed_form::by_rk4(0.1, scene(kMotion.omega(), 0, 1)));
  CHECK(asked.method == "rk4");
  CHECK(asked.why == "asked for");
}

namespace {

void check_refused(const Scene& s, const std::string& part) {
  CAPTURE(part);
  CHECK_THROWS_AS(propagate(s), std::invalid_argument);
  CHECK_THROWS_WITH(propagate(s), Contains(part));
}

}  // namespace

TEST_CASE("a request that cannot be is refused, and shown") {
  const Scene good = scene(kMotion.omega(), 0, 1);
  const Scene rk4 = closed_form::by_rk4(0.1, good);
  for (const double bad : {0.0, -1.0, kNaN, kInfinity}) {
    check_refused(to_accuracy(bad, good), "accuracy must be positive, got " + text(bad));
    check_refused(closed_form::by_rk4(bad, good), "step must be positive, got " + text(bad));
  }
  for (const double bad : {0.0, -1.0, kNaN}) {
    Scene s = good;
    s.max_step = bad;
    check_refused(s, "max_step must be positive, got " + text(bad));
  }
  for (const double bad : {kInfinity, -kInfinity, kNaN}) {
    check_refused(scene(kMotion.omega(), 0, bad), "t must be finite, got 0.0 .. " + text(bad));
    check_refused(scene(kMotion.omega(), bad, 0), "t must be finite, got " + text(bad));
    check_refused(scene(Vector(0, 0, 1), 0, bad), "t must be finite");
  }
  Scene s = good;
  s.max_steps = 0;
  check_refused(s, "max_steps must be positive, got 0");
  check_refused(scene(kMotion.omega(), -1e308, 1e308), "t is too long: 1e+308 less -1e+308");
}

TEST_CASE("a method is refused what it does not take, by name") {
  Scene s = scene(kMotion.omega(), 0, 1);
  s.step = 0.1;
  check_refused(s, "step is for method = \"rk4\"");
  s.method = Method::kDop853;
  check_refused(s, "\"dop853\" takes accuracy, not step");
  s = scene(kMotion.omega(), 0, 1);
  s.method = Method::kRk4;
  check_refused(s, "\"rk4\" needs step");
  s.method = Method::kExact;
  check_refused(s, "\"exact\" needs an omega whose model is known");
  s = closed_form::by_rk4(1e-9, scene(kMotion.omega(), 0, 1));
  check_refused(s, "step = 1e-09 makes more than max_steps = 1000000 steps");
  s = scene(kMotion.omega(), 0, 1);
  s.max_step = 1e-300;
  check_refused(s, "max_step = 1e-300 makes more than max_steps = 1000000 steps");
  s.method = Method::kDop853;
  check_refused(s, "max_step = 1e-300 makes more than max_steps = 1000000 steps");
  check_refused(scene(Vector(1e300, 0, 0), 0, 1e300), "too large to be an angle");
}
