#include "dynamics/strobe.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "dynamics/floquet.hpp"
#include "dynamics/fraction.hpp"
#include "motion/times.hpp"
#include "rotation/text.hpp"
#include "spin/models.hpp"

namespace rotor {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr Extended kTwoPi = 2 * std::numbers::pi_v<Extended>;

// What the motion has done since the first of the times: V^k.
std::vector<Quaternion> turns_since_first(const Run& run, std::span<const double> times,
                                          const Observer& observer) {
  const Quaternion back = run.attitude(times.front()).quaternion.conjugate();
  std::vector<Quaternion> turns;
  turns.reserve(times.size());
  visit_times(times, observer, [&](double t) {
    const Quaternion q = run.attitude(t).quaternion;
    turns.push_back(run.propagator().frame == Frame::kSpace ? q * back : back * q);
  });
  return turns;
}

// The angle by which the points go on, rad, from V^k at k = 1, 2, 4, ...: each is known to its
// error / k.
Extended angle_of_advance(std::span<const Quaternion> turns, const Vector& axis) {
  Extended beta = 0;
  for (std::size_t k = 1; k < turns.size(); k *= 2) {
    const Extended seen = std::atan2(Extended{axis.dot(turns[k].vec())}, Extended{turns[k].w()});
    const auto count = static_cast<Extended>(k);
    beta += std::remainder(seen - count * beta, kTwoPi) / count;
  }
  return beta;
}

// The greatest |omega| in the first period.
double speed(const Run& run, std::span<const double> times) {
  return greatest_rate(run, times[0], times.size() > 1 ? times[1] - times[0] : 0);
}

// Whether omega repeats with the period by what it is: a whole number of its own ones, which are
// rounded as the period is.
bool known_to_repeat(const AngularVelocity& omega, double period) {
  if (omega.as<ConstantSpin>() != nullptr) return true;
  const auto own = drive_period(omega);
  if (!own) return false;
  const double count = period / *own;
  return count > 0.5 && std::abs(count - std::nearbyint(count)) <= 4 * kEpsilon * count;
}

}  // namespace

std::vector<double> strobe_times(const Run& run, double period) {
  const double length = std::abs(run.t1() - run.t0());
  if (!(period > 0))
    throw std::invalid_argument("the period must be positive, got " + text(period));
  if (period > length) {
    throw std::invalid_argument("the period " + text(period) + " is longer than the run, " +
                                text(run.t0()) + " .. " + text(run.t1()));
  }
  if (!(length / period < 1e8)) {
    throw std::invalid_argument("the period " + text(period) + " makes " +
                                text(length / period, 3) + " points, more than 1e8");
  }
  return times_every(run.t0(), run.t1(), period);
}

StrobeCircle strobe_circle(const Run& run, std::span<const double> times,
                           const Observer& observer) {
  const std::vector<Quaternion> turns = turns_since_first(run, times, observer);
  // The period and the times are rounded.
  const double of_t =
      kEpsilon * std::max(std::abs(times.front()), std::abs(times.back())) * speed(run, times);
  const double error = run.propagator().error_estimate + of_t + 8 * kEpsilon;
  // The turn that is known best is the one farthest from 1 and -1.
  const auto farthest =
      std::max_element(turns.begin(), turns.end(), [](const Quaternion& a, const Quaternion& b) {
        return a.vec().squaredNorm() < b.vec().squaredNorm();
      });
  StrobeCircle circle{kNoAxis, 0, 0, 0, false};
  const bool turned = norm(farthest->vec()) > 4 * error;
  Vector axis = turned ? unit(farthest->vec()) : Vector(Vector::UnitX());
  if (axis.dot(run.propagator().flow->generator(times.front())) *
          (run.propagator().frame == Frame::kSpace ? 1 : -1) <
      0) {
    axis = -axis;
  }
  if (turned) circle.axis = axis.array() + 0.0;  // no -0
  const Extended beta = angle_of_advance(turns, axis);
  const Extended turn = beta / kTwoPi;
  circle.rotation_number = static_cast<double>(turn - std::floor(turn));
  if (circle.rotation_number >= 1) circle.rotation_number = 0;
  const auto last = static_cast<double>(turns.size() - 1);
  // Of the last power of two, half the points at least.
  circle.error = error / static_cast<double>(kTwoPi) / std::max(1.0, last / 2) +
                 kEpsilon * circle.rotation_number;
  for (std::size_t k = 0; k < turns.size(); ++k) {
    const Extended angle = static_cast<Extended>(k) * beta;
    const Vector sine = axis * static_cast<double>(std::sin(angle));
    circle.off =
        std::max(circle.off, std::hypot(turns[k].w() - static_cast<double>(std::cos(angle)),
                                        norm(Vector(turns[k].vec() - sine))));
  }
  // Both the points and what is foretold of them are off by as much; the axis by what the turn is
  // off over its sine.
  circle.closes = circle.off <= 8 * error;
  return circle;
}

std::optional<Closing> closing(const Run& run, std::span<const double> times, double period,
                               const StrobeCircle& circle) {
  const bool known = known_to_repeat(run.driver(), period);
  if (!circle.closes || (!known && times.size() < 3)) return std::nullopt;
  // The period, and the numbers in omega, are each known to an epsilon: of the angle of a period,
  // and of the turn of a frame, 2 pi, of which the circle goes on by half.
  const double error =
      circle.error + 2 * kEpsilon * (1 + speed(run, times) * period / static_cast<double>(kTwoPi));
  Closing result{known, largest_denominator(error), std::nullopt};
  if (const auto fraction = fraction_within(circle.rotation_number, error)) {
    // The attitudes go on by twice as much.
    const auto n = static_cast<std::size_t>(fraction->denominator);
    result.orbit = ClosedOrbit{n % 2 == 0 ? n / 2 : n, n};
  }
  return result;
}

NearReturn nearest_return(const StrobeCircle& circle, std::size_t most) {
  const auto off = [&](std::size_t n) {
    return std::abs(std::remainder(2 * static_cast<double>(n) * circle.rotation_number, 1.0));
  };
  std::size_t nearest = 1;
  for (std::size_t n = 2; n <= most; ++n) {
    if (off(n) < off(nearest)) nearest = n;
  }
  return {nearest, static_cast<double>(kTwoPi) * off(nearest)};
}

Plane plane_of_m(const Run& run, std::span<const double> times, const Observer& observer) {
  std::vector<Vector> points;
  points.reserve(times.size());
  Matrix sum = Matrix::Zero();
  visit_times(times, observer, [&](double t) {
    const Vector& m = points.emplace_back(run.attitude(t).modified_gibbs());
    sum += m * m.transpose();
  });
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(sum);
  Vector normal = solver.eigenvectors().col(0);  // that of the least eigenvalue
  for (int i = 2; i >= 0; --i) {
    if (std::abs(normal(i)) <= kEpsilon) continue;
    if (normal(i) < 0) normal = -normal;
    break;
  }
  Plane plane{normal, 0};
  for (const Vector& m : points) plane.off = std::max(plane.off, std::abs(normal.dot(m)));
  return plane;
}

}  // namespace rotor
