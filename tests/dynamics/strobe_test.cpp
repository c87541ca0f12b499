#include "dynamics/strobe.hpp"

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <set>
#include <stdexcept>

#include "catch.hpp"
#include "dynamics/recurrence.hpp"
#include "spin/models.hpp"

namespace {

using namespace rotor;
using Catch::Matchers::Contains;

constexpr double kPi = std::numbers::pi;
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

Run turn(double t0, double t1) {
  return evolve({AngularVelocity(Vector(0, 0, 1)), t0, t1}, Rotation(Vector(1, 0, 0), 1));
}

// [P15] with E0 = (1, 1, 1)/sqrt 3.
const Rotation kStart(Vector(1, 1, 1), 1);
Run p15(double period, double t1, bool body = false) {
  const double rate = 2 * kPi / period;
  const AngularVelocity omega(
      [rate](double t) { return Vector(std::cos(rate * t), std::sin(rate * t), 0); });
  return evolve({body ? omega.in_body_frame() : omega, 0, t1}, kStart);
}

// Theory 4.4 at t = 2 pi/alpha: half a turn about k, then Omega T about i - alpha k; half of both,
// in turns, on the side of omega(0) = i.
double rotation_number(double period) {
  const double rate = 2 * kPi / period;
  const double turns = std::sqrt(1 + rate * rate) / (2 * rate) + 0.5;
  return turns - std::floor(turns);
}

}  // namespace

TEST_CASE("a strobe has the start, and a point each period after it") {
  CHECK(strobe_times(turn(0, 4200), 40).size() == 106);
  CHECK(strobe_times(turn(1, -1), 0.5) == std::vector<double>{1, 0.5, 0, -0.5, -1});
  CHECK_THROWS_WITH(strobe_times(turn(0, 1), 0), Contains("positive") && Contains("0.0"));
  CHECK_THROWS_WITH(strobe_times(turn(0, 1), 2), Contains("longer than the run"));
  const double inf = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(strobe_times(turn(0, 1), inf), std::invalid_argument);
  CHECK_THROWS_AS(strobe_times(turn(0, 1), inf - inf), std::invalid_argument);
}

TEST_CASE("the points of a strobe go on along a great circle by the rotation number") {
  CHECK(rotation_number(40) == Approx(0.7221295).epsilon(0).margin(5e-8));  // theory 5
  for (const double period : {40.0, kPi, 1.0, 7.0}) {
    for (const double periods : {1.0, 5.0, 100.0, -100.0}) {
      const Run run = p15(period, periods * period);
      const StrobeCircle circle = strobe_circle(run, strobe_times(run, period));
      CAPTURE(period, periods, circle.rotation_number, circle.error, circle.off);
      CHECK(circle.closes);
      // Backward it goes on by as much the other way.
      const double known = periods > 0 ? rotation_number(period) : 1 - rotation_number(period);
      CHECK(std::abs(circle.rotation_number - known) <= circle.error);
      const double rate = 2 * kPi / period;
      const Vector axis = Vector(1, 0, -rate).normalized();
      CHECK((circle.axis - axis).norm() < 1e-8);
    }
  }
}

TEST_CASE(
    "a period that is no double closes as well as its rounding lets it, however long the run") {
  for (const double periods : {100.0, 1000.0, 20000.0}) {
    const Run run = evolve(
        {AngularVelocity(std::make_shared<const TurningSpin>(Vector(1, 0, 0), Vector(0, 0, 1), 2)),
         0, periods * kPi},
        kStart);
    const StrobeCircle circle = strobe_circle(run, strobe_times(run, kPi));
    CAPTURE(periods, circle.off);
    CHECK(circle.closes);
    CHECK(std::abs(circle.rotation_number - rotation_number(kPi)) <= circle.error);
  }
}

TEST_CASE("in the body frame the circle is that of the inverse motion") {
  // Q' = Q omega/2 has Q = Q0 V^k with V* that of the space frame for -omega: V(t) = U(t)* there.
  const Run run = p15(40, 400, true);
  const StrobeCircle circle = strobe_circle(run, strobe_times(run, 40));
  CHECK(circle.closes);
  const Quaternion v = kStart.quaternion().conjugate() * run.attitude(40).quaternion;
  const double half = 2 * kPi * circle.rotation_number;
  CHECK(std::abs(v.w() - std::cos(half)) < 1e-9);
  CHECK((v.vec() - circle.axis * std::sin(half)).norm() < 1e-9);
}

TEST_CASE("where omega does not repeat with the period the circle does not close") {
  const Run run = p15(40, 4200);
  CHECK(!strobe_circle(run, strobe_times(run, 39)).closes);
  CHECK(strobe_circle(run, strobe_times(run, 80)).closes);
  // alpha = 3/4: everything has the period 8 pi, three points [theory 4.5].
  const double period = 2 * kPi / 0.75;
  const Run commensurate = p15(period, 30 * period);
  const StrobeCircle three = strobe_circle(commensurate, strobe_times(commensurate, period));
  CHECK(three.closes);
  CHECK(std::abs(3 * three.rotation_number - std::nearbyint(3 * three.rotation_number)) <=
        3 * three.error);
  const StrobeCircle one = strobe_circle(commensurate, strobe_times(commensurate, 3 * period));
  CHECK(one.closes);
  CHECK(one.axis.hasNaN());
  CHECK(std::abs(std::remainder(one.rotation_number, 1)) <= one.error);
}

TEST_CASE("the strobe of M lies in the plane through its first two points") {
  const Run run = p15(40, 42000);
  const std::vector<double> times = strobe_times(run, 40);
  const Plane plane = plane_of_m(run, times);
  CHECK((plane.normal - Vector(-0.298706, -0.508736, 0.807442)).norm() < 1e-6);  // theory 5
  CHECK(plane.off < 4 * run.propagator().error_estimate + 8 * kEpsilon);
  const Vector across =
      run.attitude(0).modified_gibbs().cross(run.attitude(40).modified_gibbs()).normalized();
  CHECK(std::abs(std::abs(plane.normal.dot(across)) - 1) < 1e-9);
}

TEST_CASE("the times of return are three at most, the greatest the sum of the others") {
  const Run run = evolve({AngularVelocity(std::make_shared<const TurningSpin>(
                              Vector(1, 0, 0), Vector(0, 0, 1), 2 * kPi / 40)),
                          0, 800000},
                         kStart);
  const std::vector<double> times = strobe_times(run, 40);
  const auto different = [&](double distance, Chart norm) {
    const auto gaps = return_times(recurrence_points(run, times, norm), distance);
    return std::set<std::size_t>(gaps.begin(), gaps.end());
  };
  CHECK(different(0.3, Chart::kEulerVector) == std::set<std::size_t>{18, 115, 133});  // theory 5
  for (const double distance : {0.05, 0.1, 0.2, 0.5, 1.0}) {
    const std::set<std::size_t> gaps = different(distance, Chart::kRotation);
    CAPTURE(distance);
    REQUIRE(gaps.size() <= 3);
    if (gaps.size() == 3) CHECK(*gaps.rbegin() == *gaps.begin() + *std::next(gaps.begin()));
  }
  CHECK_THROWS_WITH(different(0, Chart::kRotation), Contains("positive"));
  CHECK(different(1e-12, Chart::kRotation).empty());
}
