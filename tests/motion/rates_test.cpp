// The rates of axis, angle and Euler vector against differences of states.
#include <cmath>
#include <numbers>

#include "catch.hpp"
#include "motions.hpp"

namespace {

using namespace rotor;
using namespace rotor::motions;

constexpr double kPi = std::numbers::pi;

// The derivative at t by the central difference of fourth order: d^4/30 of the fifth derivative,
// and 1.5 times the error of the values over d.
template <class Face>
auto derivative(const Run& run, double t, double d, Face face) {
  const auto difference = [&](double by) { return (face(run(t + by)) - face(run(t - by))).eval(); };
  return ((8 * difference(d) - difference(2 * d)) / (12 * d)).eval();
}

void check_rates(const Run& run, double t, double d, double tolerance) {
  const Rates rates = run.rates(run(t), run.omega(t));
  using One = Eigen::Matrix<double, 1, 1>;
  CAPTURE(t, run(t).angle, run(t).axis.transpose());
  const auto angle = derivative(run, t, d, [](const State& s) { return One(s.angle); });
  const Vector axis = derivative(run, t, d, [](const State& s) { return s.axis; });
  const Vector euler = derivative(run, t, d, [](const State& s) { return s.euler_vector(); });
  CHECK(std::abs(rates.angle_rate - angle[0]) < tolerance);
  CHECK((rates.axis_rate - axis).norm() < tolerance);
  CHECK((rates.euler_rate - euler).norm() < tolerance * std::max(1.0, std::abs(run(t).angle)));
}

}  // namespace

TEST_CASE("the rates are the derivatives of the states, on an exact motion") {
  // Derivatives grow with 1/sin(theta/2), at least 0.19 here: the fifth is below 1e4, d^4/30 of
  // that 3e-10 at d = 1e-3; values are good to 1e-15 / 0.19, times 1.5/d: 1e-11. Angles of 1e3
  // have an ulp of 1e-13: 2e-10.
  for (const double theta0 : {0.4, 2.9, 3.1, 4.5, 5.8, -0.4, -2.0, -3.5, -5.5, 8.0, -15.0, 1e3}) {
    for (const Vector& n0 : {Vector(1, 0, 0), Vector(1, 2, -1)}) {
      const Run run = evolve(scene(Vector(0.2, 0.1, 1), 0, 14), Rotation(n0, theta0));
      CAPTURE(theta0);
      for (const double t : times(0.1, 13, 40)) check_rates(run, t, 1e-3, 1e-9);
    }
  }
}

TEST_CASE("the rates are the derivatives of the states, on P15") {
  // States are good to 1e-12; d = 0.01: 2e-10, and d^4/30 of the fifth derivative of some 1e2.
  const double a = 2 * kPi / 40;
  const AngularVelocity omega(
      [a](double t) { return Vector(std::cos(a * t), std::sin(a * t), 0); });
  const Run run =
      evolve(scene(omega, 0, 100, 1e-12), from_euler_vector(Vector(1, 1, 1) / std::sqrt(3)));
  for (const double t : times(0.5, 99, 200)) check_rates(run, t, 0.01, 1e-7);
}

TEST_CASE("the rates of section 2: theta' = omega . n and E' from both") {
  const Vector omega(0.3, -0.7, 1.1);
  for (const double theta : {1e-9, 0.5, 2.999999, 3.000001, 6.0, -2.999999, -3.000001, 20.0}) {
    const Rotation r(Vector(2, -1, 2), theta);
    const Run run = evolve(scene(as_function(omega), 0, 1), r);
    const Rates rates = run.rates(run(0), omega);
    CAPTURE(theta);
    CHECK(rates.angle_rate == Approx(omega.dot(r.axis())));
    // Its own inverse [N15]: omega = theta' n + (1 - cos theta) n x n' + sin theta n'.
    const Vector back = rates.angle_rate * r.axis() +
                        2 * std::pow(std::sin(theta / 2), 2) * r.axis().cross(rates.axis_rate) +
                        std::sin(theta) * rates.axis_rate;
    CHECK((back - omega).norm() < 1e-14);
    CHECK(std::abs(rates.axis_rate.dot(r.axis())) < 1e-14 * (1 + rates.axis_rate.norm()));
    const Vector sum = rates.angle_rate * r.axis() + theta * rates.axis_rate;
    CHECK((rates.euler_rate - sum).norm() < 1e-13 * (1 + sum.norm()));
  }
}

TEST_CASE("at the identity E' is omega, and the axis rate that of Lemma 5.3") {
  const Vector omega(0.3, -0.7, 1.1);
  const Run run = evolve(scene(as_function(omega), 0, 1), Rotation());
  const Rates rates = run.rates(run(0), omega);
  CHECK(rates.euler_rate == omega);
  CHECK(rates.angle_rate == Approx(omega.norm()));
  // omega' is zero; differences over the run's length 1, four ulp of omega times 100 (the matrix).
  CHECK(norm(rates.axis_rate) < 400 * kEpsilon);
}

TEST_CASE("about a fixed axis the axis rate is zero everywhere, at 2 pi k too") {
  for (const double theta0 : {0.0, 1.0, -7.0}) {
    const Run run = evolve(scene(Vector(0, 0, 2), 0, 10), Rotation(Vector(0, 0, 1), theta0));
    for (const double t : {0.0, 1.0, 2 * kPi, kPi - theta0 / 2}) {
      if (t > 10) continue;
      const Rates rates = run.rates(run(t), run.omega(t));
      CAPTURE(theta0, t);
      CHECK(rates.angle_rate == 2);
      CHECK(rates.axis_rate == Vector(0, 0, 0));
      CHECK((rates.euler_rate - Vector(0, 0, 2)).norm() < 1e-15);
    }
  }
}
