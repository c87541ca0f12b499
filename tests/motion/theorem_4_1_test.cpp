// Theorem 4.1: axis and angle for a constant omega, in closed form and extended precision.
#include <cmath>
#include <numbers>

#include "catch.hpp"
#include "motions.hpp"

namespace {

using namespace rotor;
using namespace rotor::motions;
using ExtendedVector = Eigen::Matrix<Extended, 3, 1>;

constexpr double kPi = std::numbers::pi;

// theta0 in (0, 2 pi), n0 and omega not parallel.
class Theorem {
 public:
  Theorem(const Vector& omega, const Vector& n0, double theta0)
      : rate_(omega.cast<Extended>().norm()) {
    const ExtendedVector n = n0.cast<Extended>().normalized();
    const ExtendedVector w = omega.cast<Extended>() / rate_;
    const Extended sine = std::sin(Extended{theta0} / 2);
    const Extended cosine = std::cos(Extended{theta0} / 2);
    const Extended c = w.dot(n);
    rest_ = n.cross(w).squaredNorm() * sine * sine;  // 1 - a^2
    a_ = std::sqrt(1 - rest_);
    b_ = std::atan2(c * sine, cosine);
    const Extended k = c / a_;
    const ExtendedVector u1 = (w - c * n) / n.cross(w).norm();
    const ExtendedVector u = u1 * cosine + u1.cross(n) * sine;
    // s sqrt(1 - k^2), from a^2 - c^2 = (1 - c^2) cos^2(theta0/2).
    const Extended s = n.cross(w).norm() * cosine / a_;
    e1_ = s * n - k * u;
    e2_ = k * n + s * u;
  }
  double angle(double t) const {
    const Extended sine = std::sin(phase(t));
    return static_cast<double>(
        2 * std::atan2(std::sqrt(rest_ + a_ * a_ * sine * sine), a_ * std::cos(phase(t))));
  }
  Vector axis(double t) const {
    return (e1_ * std::cos(phase(t)) + e2_ * (std::sin(phase(t)) / std::sqrt(rest_)))
        .normalized()
        .cast<double>();
  }

 private:
  Extended phase(double t) const { return rate_ * Extended{t} / 2 + b_; }
  Extended rate_, rest_, a_, b_;
  ExtendedVector e1_, e2_;
};

struct Start {
  Vector omega, n0;
  double theta0;
};
const std::vector<Start> kStarts = {
    {{0, 0, 1}, {1, 0, 0}, kPi / 2},
    {{0, 0, 1}, {1, 0, 1}, 1},
    {{0, 0, 1}, {1, 0, -1}, 1},             // omega . n0 < 0
    {{0, 0, 1}, {1, 2, 2}, 4.5},            // theta0 > pi
    {{0, 0, 1}, {1, 2, -2}, 4.5},           // both
    {{0.3, -2, 0.7}, {-1, 0.1, 0.4}, 6.2},  // near 2 pi, faster
    {{0.3, -2, 0.7}, {1, 0.5, 0.4}, 0.01},  // near 0
    {{0, 1e-3, 0}, {0, 1, 1e-2}, 3},        // nearly parallel, slow
    {{0, 0, 1}, {0.6, 0, 0.8}, kPi},        // a half turn
};

void check_against(const Theorem& theorem, const Run& run, double t, double turns) {
  const State state = run(t);
  const double angle = theorem.angle(t);
  CAPTURE(t, angle, state.angle);
  CHECK(std::abs(state.angle - (angle + turns)) <= rotation_tolerance(run, state.angle));
  CHECK((state.axis - theorem.axis(t)).norm() <= axis_tolerance(run, angle));
}

}  // namespace

TEST_CASE("axis and angle follow Theorem 4.1, by the exact method and by both that step") {
  for (const Start& start : kStarts) {
    INFO("omega " << start.omega.transpose() << "  n0 " << start.n0.transpose() << "  theta0 "
                  << start.theta0);
    const Theorem theorem(start.omega, start.n0, start.theta0);
    const Rotation from(start.n0, start.theta0);
    const double end = 30 / start.omega.norm();
    Scene fixed = scene(as_function(start.omega), 0, end);
    fixed.method = Method::kRk4;
    fixed.step = end / 600;
    for (const Scene& s :
         {scene(start.omega, 0, end), scene(as_function(start.omega), 0, end), fixed,
          scene(start.omega, 0, -end), scene(as_function(start.omega), 0, -end)}) {
      const Run run = evolve(s, from);
      CAPTURE(run.propagator().method);
      CHECK(run.crossings().empty());
      for (const double t : times(0, s.t1, 200)) check_against(theorem, run, t, 0);
    }
  }
}

TEST_CASE(
    "a start with more turns, or negative ones, has the same axis and its angle moved by them") {
  // [P5] has the period 2 pi in theta.
  for (const Start& start : kStarts) {
    for (const int turns : {-3, -2, -1, 1, 2, 1000}) {
      const double theta0 = start.theta0 + 2 * kPi * turns;
      INFO("omega " << start.omega.transpose() << "  n0 " << start.n0.transpose() << "  theta0 "
                    << theta0);
      // The theorem's theta0, from what the sum was rounded to.
      const auto rest =
          static_cast<double>(Extended{theta0} - 2 * std::numbers::pi_v<Extended> * turns);
      const Theorem theorem(start.omega, start.n0, rest);
      for (const Scene& s : {scene(start.omega, 0, 20), scene(as_function(start.omega), 0, 20)}) {
        const Run run = evolve(s, Rotation(start.n0, theta0));
        for (const double t : times(0.01, 20, 50)) check_against(theorem, run, t, 2 * kPi * turns);
      }
    }
  }
}

TEST_CASE("after 2 pi the angle is 2 pi - theta and the axis -n, after 4 pi all is as before") {
  const Run run = evolve(scene(Vector(0, 0, 1), 0, 20), Rotation(Vector(1, 0.3, 0.5), 2));
  for (const double t : times(0, 7, 100)) {
    const State now = run(t);
    const State half = run(t + 2 * kPi);
    const State whole = run(t + 4 * kPi);
    CAPTURE(t);
    // t + 2 pi is rounded by up to an ulp of 32.
    CHECK(half.angle == Approx(2 * kPi - now.angle).epsilon(0).margin(2e-14));
    CHECK((half.axis + now.axis).norm() < 2e-14);
    CHECK(whole.angle == Approx(now.angle).epsilon(0).margin(2e-14));
    CHECK((whole.axis - now.axis).norm() < 2e-14);
  }
}

TEST_CASE("the example of section 4 of the paper") {
  for (const AngularVelocity& omega :
       {AngularVelocity(Vector(0, 0, 1)), as_function(Vector(0, 0, 1))}) {
    const Run run = evolve(scene(omega, 0, 4 * kPi), Rotation(Vector(1, 0, 0), kPi / 2));
    const auto near = [&](double t, const Vector& e) {
      CHECK((run(t).euler_vector() - e).norm() < 10 * rotation_tolerance(run, 5));  // |E| < 5
    };
    near(0, Vector(kPi / 2, 0, 0));
    near(kPi, Vector(0, kPi, kPi) / std::sqrt(2));
    near(2 * kPi, Vector(-1.5 * kPi, 0, 0));
    near(4 * kPi, Vector(kPi / 2, 0, 0));
    for (const double t : times(0, 4 * kPi, 100)) {
      const Vector n = Vector(std::cos(t / 2), std::sin(t / 2), std::sin(t / 2)) /
                       std::sqrt(1 + std::sin(t / 2) * std::sin(t / 2));
      CHECK((run(t).axis - n).norm() <= 2 * axis_tolerance(run, kPi / 2));
    }
  }
}

TEST_CASE("with omega across a half turn the angle stays pi and the axis turns uniformly") {
  // a = 0: cos(theta/2) = 0 for ever. pi is not a double: 6e-17.
  const Run run = evolve(scene(Vector(0, 0, 2), 0, 10), Rotation(Vector(1, 0, 0), kPi));
  for (const double t : times(0, 10, 50)) {
    CHECK(run(t).angle == Approx(kPi).epsilon(0).margin(2e-15));
    CHECK((run(t).axis - Vector(std::cos(t), std::sin(t), 0)).norm() < 4e-15);
  }
}
