#include "dynamics/strobe.hpp"

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <random>
#include <set>
#include <stdexcept>
#include <vector>

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

namespace {

// Theory 4.5: alpha = q/sqrt(p^2 - q^2), p > q coprime.
struct Commensurate {
  int p, q;
  double alpha() const { return q / std::sqrt(static_cast<double>((p - q) * (p + q))); }
  std::size_t attitude() const { return static_cast<std::size_t>(q); }
  std::size_t quaternion() const { return attitude() * ((p + q) % 2 == 0 ? 1 : 2); }
};
constexpr Commensurate kCommensurate[] = {{5, 3}, {2, 1}, {3, 1},   {3, 2},  {4, 1},
                                          {7, 5}, {8, 3}, {13, 12}, {20, 19}};

AngularVelocity turning(double alpha) {
  return {std::make_shared<const TurningSpin>(Vector(1, 0, 0), Vector(0, 0, 1), alpha)};
}
AngularVelocity function(double alpha) {
  return AngularVelocity(
      [alpha](double t) { return Vector(std::cos(alpha * t), std::sin(alpha * t), 0); });
}

std::optional<Closing> closing_of(const AngularVelocity& omega, double period, double t1,
                                  const Rotation& from = kStart) {
  const Run run = evolve({omega, 0, t1}, from);
  const std::vector<double> times = strobe_times(run, period);
  return closing(run, times, period, strobe_circle(run, times));
}

}  // namespace

TEST_CASE("a commensurate alpha closes after q periods, the quaternion after q or 2 q") {
  constexpr unsigned kSeed = 45;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const Commensurate& one : kCommensurate) {
    const double alpha = one.alpha();
    const double period = 2 * kPi / alpha;
    for (const AngularVelocity& omega : {turning(alpha), function(alpha)}) {
      const bool known = omega.as<TurningSpin>() != nullptr;
      for (const AngularVelocity& drive : {omega, omega.in_body_frame()}) {
        for (const double periods : {2.0, 7.0, 100.0, -7.0}) {
          const Rotation from(Vector(uniform(random), uniform(random), uniform(random)),
                              3 * uniform(random));
          const auto found = closing_of(drive, period, periods * period * (1 + kEpsilon), from);
          CAPTURE(kSeed, one.p, one.q, known, periods);
          REQUIRE(found);
          CHECK(found->omega_known == known);
          REQUIRE(found->orbit);
          CHECK(found->orbit->attitude == one.attitude());
          CHECK(found->orbit->quaternion == one.quaternion());
          // What it says is so: by the quaternions of the motion itself, which are known to the
          // estimate each, and to what t is rounded by, |omega| = 1.
          const double end = static_cast<double>(one.quaternion()) * period;
          const Run whole = evolve({drive, 0, 1.01 * end}, from);
          const double margin =
              2.5 * whole.propagator().error_estimate + 4 * kEpsilon * (end + 2 * kPi);
          CHECK((whole.attitude(end).quaternion.coeffs() - whole.attitude(0).quaternion.coeffs())
                    .norm() <= margin);
        }
      }
    }
  }
}

TEST_CASE("the paper's T = 40 and T = pi are closed by no number of periods up to 1000") {
  for (const double period : {40.0, kPi}) {
    for (const double periods : {2.0, 10.0, 100.0}) {
      const auto found = closing_of(function(2 * kPi / period), period, periods * period * 1.001);
      CAPTURE(period, periods);
      REQUIRE(found);
      CHECK(found->most == 1000);
      CHECK(!found->orbit);
    }
  }
  // Whose attitude is nearest after 9 T: twice 9 rotation numbers, 6.4991653 each, from whole.
  const Run run = p15(40, 4200);
  const StrobeCircle circle = strobe_circle(run, strobe_times(run, 40));
  const NearReturn nearest = nearest_return(circle, 100);
  CHECK(nearest.periods == 9);
  CHECK(run.attitude(0).quaternion.angularDistance(run.attitude(360).quaternion) ==
        Approx(nearest.angle).epsilon(0).margin(1e-9));
}

TEST_CASE("what is nearly commensurate is not taken to be so, unless the error hides it") {
  for (const Commensurate& one : kCommensurate) {
    for (const double off : {1e-6, 1e-9, 1e-12, -1e-12}) {
      const double alpha = one.alpha() + off;
      const double period = 2 * kPi / alpha;
      // By so much the rotation number (1 + Omega/alpha)/2 is off; 1.7e-14 at least.
      const double changed = std::abs(off) / (2 * alpha * alpha * std::sqrt(1 + alpha * alpha));
      for (const AngularVelocity& omega : {turning(alpha), function(alpha)}) {
        const Run run = evolve({omega, 0, 10.001 * period}, kStart);
        const std::vector<double> times = strobe_times(run, period);
        const StrobeCircle circle = strobe_circle(run, times);
        const auto found = closing(run, times, period, circle);
        // Beside its error 2 epsilon (1 + T/2 pi), |omega| = 1.
        const double known = circle.error + 2 * kEpsilon * (1 + 1 / alpha);
        CAPTURE(one.p, one.q, alpha, changed, known);
        REQUIRE(found);
        if (omega.as<TurningSpin>() != nullptr) CHECK(changed > 2 * known);
        if (changed > 2 * known) CHECK(!found->orbit);
        if (changed < known / 2) CHECK(found->orbit);
      }
    }
  }
}

TEST_CASE("a run too inexact, or too short, or of another period, claims nothing") {
  const double period = 2 * kPi / 0.75;
  CHECK(!closing_of(function(0.75), period, 1.01 * period));
  CHECK(closing_of(turning(0.75), period, 1.01 * period)->orbit->quaternion == 3);
  CHECK(!closing_of(function(0.75), 0.9 * period, 30 * period));
  Scene scene{function(0.75), 0, 30 * period};
  scene.accuracy = 1e-4;
  const Run run = evolve(scene, kStart);
  const std::vector<double> times = strobe_times(run, period);
  StrobeCircle circle = strobe_circle(run, times);
  circle.error = 1e-3;
  CHECK(closing(run, times, period, circle)->most == 0);
  CHECK(!closing(run, times, period, circle)->orbit);
}

TEST_CASE("a constant omega closes where its turns in a period are a fraction; omega = 0 at once") {
  const auto periods = [](const Vector& omega, double period) {
    const auto found = closing_of(AngularVelocity(omega), period, 3.5 * period);
    REQUIRE(found);
    CHECK(found->omega_known);
    return found->orbit ? found->orbit->quaternion : 0;
  };
  CHECK(periods(Vector(0, 0, 0), 1) == 1);
  CHECK(periods(Vector(0, 0, 1), kPi) == 4);          // half a turn
  CHECK(periods(Vector(0, 3, 4), 2 * kPi / 5) == 2);  // a turn
  CHECK(periods(Vector(0, 3, 4), 4 * kPi / 5) == 1);  // two
  CHECK(periods(Vector(1, 0, 0), 4 * kPi / 999) == 999);
  CHECK(periods(Vector(1, 0, 0), 1) == 0);  // 1/4 pi turns of the quaternion
}
