#include "rotation/spline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include "rotation/kinematics.hpp"
#include "rotation/operators.hpp"
#include "rotation/small_angle.hpp"
#include "rotation/text.hpp"
#include "rotation/turn.hpp"

namespace rotor {
namespace {

// exp of a rotation vector, and its inverse for w >= 0.
ExtendedQuaternion exp(const ExtendedVector& phi) {
  const Extended half = phi.norm() / 2;
  const ExtendedVector v = phi * (sinc(half) / 2);
  return {std::cos(half), v.x(), v.y(), v.z()};
}
ExtendedVector log(const ExtendedQuaternion& q) {
  const Extended sine = q.vec().norm();
  return sine == 0 ? q.vec() : ExtendedVector(q.vec() * (2 * std::atan2(sine, q.w()) / sine));
}

// With J = J_r(phi) the angular velocity in the body frame is J phi', its rate J phi'' + J' phi'.
ExtendedMatrix body_jacobian(const ExtendedVector& phi) { return exp_jacobian(-phi); }
ExtendedMatrix body_jacobian_inverse(const ExtendedVector& phi) {
  return exp_jacobian_inverse(-phi);
}

// J' phi' is quadratic in b = phi':
//   J' b = -V'/theta (phi.b) phi x b + T'/theta (phi.b) phi x (phi x b) + T b x (phi x b),
// V = (1 - cos theta)/theta^2, T = (theta - sin theta)/theta^3. This is its derivative with respect
// to b, the matrix D(b) with J' b = D(b) b/2.
ExtendedMatrix turning_derivative(const ExtendedVector& phi, const ExtendedVector& b) {
  const Extended theta = phi.norm();
  if (theta == 0) return ExtendedMatrix::Zero();
  const Extended v = one_minus_cos(theta);
  const Extended t = angle_minus_sin(theta);
  // Both cancel near 0, where what they multiply is of the size of theta^2.
  const Extended v_slope = (sinc(theta) - 2 * v) / theta / theta;
  const Extended t_slope = (v - 3 * t) / theta / theta;
  const ExtendedMatrix k = skew(phi);
  const ExtendedVector c = k * b;
  const Extended along = phi.dot(b);
  return -v_slope * (c * phi.transpose() + along * k) +
         t_slope * (k * c * phi.transpose() + along * k * k) + t * (skew(b) * k - skew(c));
}

// One block row: before x[i-1] + here x[i] + after x[i+1] = value.
struct BlockRow {
  ExtendedMatrix before = ExtendedMatrix::Zero();
  ExtendedMatrix here = ExtendedMatrix::Zero();
  ExtendedMatrix after = ExtendedMatrix::Zero();
  ExtendedVector value = ExtendedVector::Zero();
};

std::vector<ExtendedVector> solve_tridiagonal(std::vector<BlockRow> rows) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    BlockRow& row = rows[i];
    if (i > 0) {
      row.here -= row.before * rows[i - 1].after;
      row.value -= row.before * rows[i - 1].value;
    }
    const ExtendedMatrix inverse = row.here.inverse();
    row.after = inverse * row.after;
    row.value = inverse * row.value;
  }
  std::vector<ExtendedVector> x(rows.size());
  for (std::size_t i = rows.size(); i-- > 0;) {
    x[i] = rows[i].value;
    if (i + 1 < rows.size()) x[i] -= rows[i].after * x[i + 1];
  }
  return x;
}

void require_times(const std::vector<double>& times, std::size_t rotations) {
  if (rotations < 2) {
    throw std::invalid_argument("spline: expected at least two rotations, got " +
                                std::to_string(rotations));
  }
  if (times.size() != rotations) {
    throw std::invalid_argument("spline: expected as many times as rotations, got " +
                                std::to_string(times.size()) + " and " + std::to_string(rotations));
  }
  for (std::size_t i = 0; i < times.size(); ++i) {
    require_finite(times[i], "spline: times");
    if (i > 0 && !(times[i - 1] < times[i])) {
      throw std::invalid_argument("spline: expected times that rise, got " + text(times[i]) +
                                  " after " + text(times[i - 1]));
    }
  }
}

}  // namespace

Spline::Spline(std::vector<double> times, const std::vector<Rotation>& rotations,
               const std::optional<EndRates>& rates, const std::function<void()>& look)
    : times_(std::move(times)) {
  require_times(times_, rotations.size());
  if (rates) {
    require_finite(rates->first, "spline: rates");
    require_finite(rates->last, "spline: rates");
  }
  set_segments(rotations);
  const std::vector<ExtendedVector> omega = node_rates(rates, look);
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    // Hermite's cubic: phi'(0) = omega_i, phi'(1) = J^-1 omega_i+1 in the unit of the segment.
    Segment& s = segments_[i];
    const ExtendedVector end = body_jacobian_inverse(s.turn) * omega[i + 1] * s.duration;
    s.a = omega[i] * s.duration;
    s.b = 3 * s.turn - 2 * s.a - end;
    s.c = s.a + end - 2 * s.turn;
  }
}

void Spline::set_segments(const std::vector<Rotation>& rotations) {
  ExtendedQuaternion from = turn(rotations.front());
  for (std::size_t i = 0; i + 1 < rotations.size(); ++i) {
    ExtendedQuaternion to = turn(rotations[i + 1]);
    if (from.dot(to) < 0) to.coeffs() *= -1;
    Segment& s = segments_.emplace_back();
    s.duration = Extended{times_[i + 1]} - times_[i];
    s.from = from;
    s.turn = log(from.conjugate() * to);
    if (static_cast<double>(s.turn.norm()) >= std::nextafter(std::numbers::pi, 0.0)) {
      throw std::invalid_argument("spline: rotations " + std::to_string(i + 1) + " and " +
                                  std::to_string(i + 2) +
                                  " are half a turn apart: both ways round are as short; "
                                  "put a rotation between them");
    }
    from = to;
  }
}

// One step of Newton's method for the angular velocities w_i at the times, in the body frame. In a
// segment phi'' is 6 turn/h^2 - 4 w_i/h - 2 b/h at its start and -6 turn/h^2 + 2 w_i/h + 4 b/h at
// its end, b = J^-1 w_i+1 the rate there, and J turn = turn; the rows equate the angular
// accelerations on both sides of t_i, of which a natural end has none outside. The part of the
// quadratic terms that counts is 1 in the end; with 0 the equations are linear.
std::vector<ExtendedVector> Spline::next_rates(const std::vector<ExtendedVector>& now,
                                               const std::optional<EndRates>& rates,
                                               Extended part) const {
  std::vector<BlockRow> rows(times_.size());
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const Segment& s = segments_[i];
    const Extended h = s.duration;
    const ExtendedMatrix inverse = body_jacobian_inverse(s.turn);
    const ExtendedVector pull = 6 * s.turn / h / h;
    rows[i].here += 4 / h * ExtendedMatrix::Identity();
    rows[i].after = 2 / h * inverse;
    rows[i].value += pull;
    // The quadratic term D(b) b/2 with its tangent at b0: D(b0) b - D(b0) b0/2.
    const ExtendedVector b0 = inverse * now[i + 1];
    const ExtendedMatrix d = part * turning_derivative(s.turn, b0);
    rows[i + 1].before = 2 / h * body_jacobian(s.turn);
    rows[i + 1].here += 4 / h * ExtendedMatrix::Identity() + d * inverse;
    rows[i + 1].value += pull + d * b0 / 2;
  }
  if (rates) {
    const Segment& last = segments_.back();
    const ExtendedQuaternion end = last.from * exp(last.turn);
    rows.front() = BlockRow{};
    rows.front().here.setIdentity();
    rows.front().value = segments_.front().from.conjugate() * rates->first.cast<Extended>();
    rows.back() = BlockRow{};
    rows.back().here.setIdentity();
    rows.back().value = end.conjugate() * rates->last.cast<Extended>();
  }
  return solve_tridiagonal(std::move(rows));
}

// Newton's method from `now`: the rates, or none where it does not converge.
std::optional<std::vector<ExtendedVector>> Spline::converged_rates(
    std::vector<ExtendedVector> now, const std::optional<EndRates>& rates, Extended part,
    const std::function<void()>& look) const {
  constexpr int kSteps = 20;
  for (int step = 0; step < kSteps; ++step) {
    if (look) look();
    std::vector<ExtendedVector> next = next_rates(now, rates, part);
    Extended change = 0;
    Extended size = 0;
    for (std::size_t i = 0; i < now.size(); ++i) {
      change += (next[i] - now[i]).squaredNorm();
      size += next[i].squaredNorm();
    }
    now = std::move(next);
    if (std::sqrt(change) <= std::numeric_limits<double>::epsilon() * std::sqrt(size)) return now;
  }
  return std::nullopt;
}

// The linear equations, then in one step all of the quadratic terms; in smaller ones where Newton's
// method does not follow.
std::vector<ExtendedVector> Spline::node_rates(const std::optional<EndRates>& rates,
                                               const std::function<void()>& look) const {
  constexpr Extended kLeastStep = 1.0L / 1024;
  std::vector<ExtendedVector> now(times_.size(), ExtendedVector::Zero());
  now = next_rates(now, rates, 0);
  Extended part = 0;
  for (Extended step = 1; part < 1;) {
    const Extended wanted = std::min<Extended>(1, part + step);
    if (auto next = converged_rates(now, rates, wanted, look)) {
      now = std::move(*next);
      part = wanted;
      step *= 2;
    } else if ((step /= 2) < kLeastStep) {
      Extended widest = 0;
      for (const Segment& s : segments_) widest = std::max(widest, s.turn.norm());
      throw std::invalid_argument(
          "spline: no angular velocities found that make the acceleration continuous; more "
          "rotations, or times less uneven, help (the widest turn between two is " +
          text(static_cast<double>(widest), 3) + " rad)");
    }
  }
  return now;
}

Spline::Expansion Spline::expansion(double t) const {
  if (!(t >= times_.front() && t <= times_.back())) {
    throw std::out_of_range("t = " + text(t) + " is outside the spline, " + text(times_.front()) +
                            " .. " + text(times_.back()));
  }
  const auto next = std::upper_bound(times_.begin() + 1, times_.end() - 1, t);
  const auto i = static_cast<std::size_t>(next - times_.begin()) - 1;
  const Segment& s = segments_[i];
  const Extended h = s.duration;
  const Extended x = (Extended{t} - times_[i]) / h;
  return {s.from,
          {((s.c * x + s.b) * x + s.a) * x, ((3 * s.c * x + 2 * s.b) * x + s.a) / h,
           (3 * s.c * x + s.b) / h / h, s.c / h / h / h}};
}

Rotation Spline::operator()(double t) const {
  const auto [from, phi] = expansion(t);
  return rotation_of(ExtendedQuaternion(from * exp(phi[0])));
}

Vector Spline::omega(double t) const {
  const auto [from, phi] = expansion(t);
  return (from * (exp(phi[0]) * (body_jacobian(phi[0]) * phi[1]))).cast<double>();
}

Vector Spline::acceleration(double t) const {
  const auto [from, phi] = expansion(t);
  const ExtendedVector in_body =
      body_jacobian(phi[0]) * (2 * phi[2]) + turning_derivative(phi[0], phi[1]) * phi[1] / 2;
  return (from * (exp(phi[0]) * in_body)).cast<double>();
}

}  // namespace rotor
