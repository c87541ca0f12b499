// The domain of f, its inverse, and what is refused.
#include "integrate/generalized.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "catch.hpp"
#include "charts.hpp"
#include "refusal.hpp"
#include "rotation/text.hpp"

namespace {

using namespace rotor;

constexpr double kPi = std::numbers::pi;
constexpr double kU = 0x1p-53;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double end_of(GeneralizedAngle::Function f) { return angle_function(std::move(f))->end(); }

// Where the truth is the double given or between it and a neighbour.
void check_end(double end, double truth) {
  CAPTURE(text(end), text(truth));
  CHECK(std::abs(end - truth) <= 4 * kU * truth);
}

}  // namespace

TEST_CASE("the domain of f ends where f' first changes its sign") {
  check_end(half_sine_angle()->end(), kPi);
  check_end(end_of([](const Jet& x) { return sin(x); }), kPi / 2);
  // f' = 1 - x^2/4, and cos(x/1000).
  check_end(end_of([](const Jet& x) { return x - x * x * x * (1.0 / 12); }), 2);
  check_end(end_of([](const Jet& x) { return sin(x * 0.001) * 1000; }), 500 * kPi);
}

TEST_CASE("the domain of f ends at a pole, or where f is infinite") {
  check_end(half_tangent_angle()->end(), kPi);
  check_end(end_of([](const Jet& x) { return tan(x * 0.25); }), 2 * kPi);
  // A pole that hides in a steep line, and one without change of sign of f.
  check_end(end_of([](const Jet& x) { return tan(x * 0.5) + x * 1e4; }), kPi);
  const double end = end_of([](const Jet& x) { return exp(x) - exp(-x); });
  CHECK(end == Approx(std::log(std::numeric_limits<double>::max())).epsilon(1e-4));
}

TEST_CASE("the domain of f ends where f is not smooth") {
  // A kink in the slope that goes on rising; and a function that says itself where it ends.
  check_end(end_of([](const Jet& x) {
              return std::abs(x.c[0]) < 1 ? x : x * 2 - Jet::constant(std::copysign(1.0, x.c[0]));
            }),
            1);
  check_end(end_of([](const Jet& x) {
              if (std::abs(x.c[0]) > 2.5) throw NotDifferentiable("not beyond 2.5");
              return x;
            }),
            2.5);
}

TEST_CASE("the domain of f ends where f' touches zero, and goes on where it only comes near") {
  const auto touching = [](double a) {
    return end_of([a](const Jet& x) { return x + sin(x) * a; });
  };
  check_end(touching(1), kPi);
  CHECK(touching(0.999999) == kInfinity);
  // Rounding of f', some u, over f'' = sin of that.
  const double end = std::acos(-1 / 1.000001);
  CHECK(std::abs(touching(1.000001) - end) <= 4 * kU / std::sin(end));
}

TEST_CASE("a dip of f' within one step of the exploration is seen") {
  // f' = 1 - 2/(1 + z^2) - 2/(1 + w^2), z = 8 (x - 40), w = 8 (x + 40), is below 0 within an eighth
  // of 40, a third of a step.
  const auto dip = [](const Jet& x) {
    const Jet z = (x - Jet::constant(40)) * 8;
    const Jet w = (x + Jet::constant(40)) * 8;
    return x - (atan(z) + atan(w)) * 0.25;
  };
  // z^2 = 1 but for what w adds, 2/640^2.
  CHECK(end_of(dip) == Approx(40 - 0.125).epsilon(1e-6));
}

TEST_CASE("f = theta and f = theta + theta^3/10 have no end, and 500 turns are explored") {
  CHECK(identity_angle()->end() == kInfinity);
  CHECK(cubic_angle()->end() == kInfinity);
}

TEST_CASE("the inverse is right to the last digit that f tells") {
  const auto check = [](const std::shared_ptr<const GeneralizedAngle>& f, double theta) {
    const GeneralizedAngle::Value at = (*f)(theta);
    const double inverse = f->inverse(at.f);
    CAPTURE(theta, text(inverse));
    // An ulp of the last step, half an ulp of f and two more of its own evaluation; theta/2 may
    // underflow.
    CHECK(std::abs(inverse - theta) <= 2 * kU * theta + 4 * kU * at.f / at.slope + 5e-324);
  };
  for (const double theta :
       {0.0, 5e-324, 1e-300, 1e-8, 0.1, 1.0, 2.5, 3.1, 3.14159, 6.0, 100.0, 3000.0, 1e5, 1e12}) {
    check(identity_angle(), theta);
    check(cubic_angle(), theta);
    if (theta < kPi) check(half_sine_angle(), theta);
    if (theta < kPi) check(half_tangent_angle(), theta);
  }
  CHECK(identity_angle()->inverse(1e300) == 1e300);
}

TEST_CASE("what is no value of f on its domain has no angle") {
  const auto f = half_sine_angle();
  for (const double value : {2.0001, 1e300, kInfinity, -0.1, std::nan("")}) {
    CAPTURE(value);
    CHECK(std::isnan(f->inverse(value)));
  }
  CHECK(std::isnan(cubic_angle()->inverse(kInfinity)));
}

TEST_CASE("an f that cannot stand for the angle is refused, with what it gave") {
  const auto refuse = [](GeneralizedAngle::Function f, const std::vector<std::string>& words) {
    refused([&] { GeneralizedAngle(std::move(f), "my_f"); }, words);
  };
  refuse([](const Jet& x) { return cos(x); }, {"my_f", "odd", "my_f(0) = 0", "1.0"});
  refuse([](const Jet& x) { return -x; }, {"rises at 0", "-1.0"});
  refuse([](const Jet& x) { return x * x * x; }, {"rises at 0", "0.0"});
  refuse([](const Jet& x) { return x + x * x; }, {"odd", "got"});
  refuse([](const Jet&) { return Jet::constant(std::nan("")); }, {"my_f(0) = 0", "nan"});
  refuse([](const Jet& x) { return x / Jet::constant(0); }, {"no derivatives"});
  CHECK_THROWS_AS(GeneralizedAngle([](const Jet&) -> Jet { throw NotDifferentiable("no"); }),
                  NotDifferentiable);
  CHECK_THROWS_AS(GeneralizedAngle([](const Jet& x) -> Jet {
                    if (x.c[0] > 1) throw std::runtime_error("script");
                    return x;
                  }),
                  std::runtime_error);
}
