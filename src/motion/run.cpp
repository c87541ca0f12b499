#include "motion/run.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "rotation/kinematics.hpp"
#include "rotation/small_angle.hpp"
#include "rotation/text.hpp"
#include "spin/models.hpp"

namespace rotor {
namespace {

constexpr Extended kTwoPi = 2 * std::numbers::pi_v<Extended>;
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kNearZero = 0.25;  // |M| below which a series about a zero of it may know more

}  // namespace

Run::Run(AngularVelocity omega, Propagator propagator, const Rotation& from,
         std::vector<Vector> points, std::optional<double> crossing_tolerance)
    : omega_(std::move(omega)),
      propagator_(std::move(propagator)),
      from_(from),
      points_(std::move(points)),
      turn_(turn_of_start(from)),
      start_(turn_.quaternion(from)),
      axis_(from.axis()),
      crossings_(omega_, propagator_, from, turn_, crossing_tolerance) {
  const FixedAxisFlow* flow = propagator_.fixed_axis();
  if (flow == nullptr) return;
  const Vector direction = sense() * flow->direction();
  if (const auto* constant = omega_.as<ConstantSpin>(); constant && constant->value(0).isZero(0)) {
    fixed_axis_ = turn_.on_zero ? 0 : 1;
  } else if (from_.angle() == 0) {
    // From the identity the body turns about omega, whatever axis it was given.
    fixed_axis_ = forward() * flow->rate(t0()) < 0 ? -1 : 1;
    axis_ = (fixed_axis_ * direction).array() + 0.0;  // no -0
  } else if (axis_.cross(direction).norm() <= 2 * kEpsilon) {
    fixed_axis_ = axis_.dot(direction) > 0 ? 1 : -1;
  }
}

Extended Run::fixed_axis_angle(double t) const {
  return from_.angle() + fixed_axis_ * propagator_.fixed_axis()->angle(t);
}

Quaternion Run::quaternion(double t) const {
  const auto [low, high] = std::minmax({t0(), t1()});
  if (!(t >= low && t <= high)) {
    throw std::out_of_range("t = " + text(t) + " is outside the run, " + text(t0()) + " .. " +
                            text(t1()));
  }
  return propagator_(t, start_);
}

State Run::attitude(double t) const {
  State state;
  state.t = t;
  state.quaternion = quaternion(t);
  return state;
}

Vector Run::omega(double t) const {
  const Vector omega = omega_(t);
  return omega_.frame() == Frame::kSpace ? omega : quaternion(t) * omega;
}

Vector Run::body_omega(double t) const {
  const Vector omega = omega_(t);
  return omega_.frame() == Frame::kBody ? omega : quaternion(t).conjugate() * omega;
}

std::vector<Vector> Run::points(double t) const {
  const Quaternion turn = quaternion(t) * start_.conjugate();
  std::vector<Vector> places;
  places.reserve(points_.size());
  for (const Vector& point : points_) places.push_back(turn * point);
  return places;
}

State Run::operator()(double t, const Observer& observer) const {
  State state = attitude(t);
  if (fixed_axis_ != 0) {
    state.axis = axis_;
    state.angle = static_cast<double>(fixed_axis_angle(t));
    return state;
  }
  if (t == t0() && from_.angle() != 0) {
    state.axis = from_.axis();
    state.angle = from_.angle();
    return state;
  }
  crossings_.look_until(t, observer);
  const double turn = crossings_.turn_at(t);
  state.axis = axis_at(t, state.quaternion, turn);
  state.angle = static_cast<double>(
      turn_.double_turns * 2 * kTwoPi +
      angle_in_turn(turn, state.quaternion.w(), Extended{norm(state.quaternion.vec())}));
  return state;
}

// The series about the zero of M nearest to t, where what it says of an axis or a rate is better
// known than by M, by its `error`; null where it is not. They must agree on the axis: omega may
// have jumped in between.
const Zero* Run::better_known(double t, const Vector& axis, double axis_error, double error,
                              double AxisSeries::Error::*of) const {
  const Zero* const zero = crossings_.zero_near(t);
  if (zero == nullptr || !zero->series || t < zero->low || t > zero->high) return nullptr;
  const AxisSeries::Error known = zero->series->error(t - zero->t);
  if (!(known.*of < error)) return nullptr;
  const bool agree = norm(Vector(zero->axis(t).axis - axis)) <= 8 * (axis_error + known.axis);
  return agree ? zero : nullptr;
}

// n = +-M/|M|: its error is that of M over |M|.
Vector Run::axis_at(double t, const Quaternion& q, double turn) const {
  const double size = norm(q.vec());
  const Vector axis = size == 0 ? axis_  // the body has not moved
                                : Vector(unit(q.vec()) * sign_of_turn(turn));
  if (size < kNearZero) {
    const double error = propagator_.error_estimate / 2 / size;
    if (const Zero* zero = better_known(t, axis, error, error, &AxisSeries::Error::axis)) {
      return zero->axis(t).axis;
    }
    if (const Zero* zero = crossings_.zero_at(t)) return zero->limit;
  }
  return axis.array() + 0.0;  // no -0
}

Vector State::mrp() const {
  const double w = quaternion.w();
  const Vector m = quaternion.vec();
  return w > -0.5 ? Vector(m / (1 + w)) : Vector(m * ((1 - w) / m.squaredNorm()));
}

// [P5]: an error of M is divided by |M|, and multiplied by cot(theta/2). Where M is no more than a
// few errors, omega beside a zero of higher order may be zero where M is not.
Vector Run::axis_rate_at(const State& state, const Vector& omega) const {
  const double sine = state.quaternion.vec().dot(state.axis);
  const double size = std::abs(sine);
  if (size < kNearZero) {
    const double error_of_m = propagator_.error_estimate / 2;
    const double error = size < 32 * error_of_m ? std::numeric_limits<double>::infinity()
                                                : norm(omega) * error_of_m / (2 * size * size);
    if (const Zero* zero =
            better_known(state.t, state.axis, error_of_m / size, error, &AxisSeries::Error::rate)) {
      return zero->axis(state.t).rate;
    }
    crossings_.look_until(state.t, {});  // the state of the start is known without
    const Zero* const zero = crossings_.zero_at(state.t);
    if (zero != nullptr && !zero->series) return zero->rate;
  }
  return sine == 0 ? kNoAxis : axis_rate(state.axis, Extended{state.quaternion.w()} / sine, omega);
}

Rates Run::rates(const State& state, const Vector& omega) const {
  const Vector& n = state.axis;
  const double along = omega.dot(n);
  Rates rates{omega.isZero(0) ? 0 : along, Vector::Zero(), Vector::Zero()};
  if (fixed_axis_ == 0) rates.axis_rate = axis_rate_at(state, omega);
  const Vector e = state.euler_vector();
  if (std::abs(state.angle) < 3) {
    // [P7] with its first two terms gathered: omega g + E (omega . E)(1 - g)/theta^2 + omega x E/2.
    const auto g = static_cast<double>(half_cot(state.angle));
    const auto second = static_cast<double>(one_minus_half_cot(state.angle));
    rates.euler_rate = omega * g + e * (omega.dot(e) * second) + omega.cross(e) / 2;
  } else {
    rates.euler_rate = n * along + rates.axis_rate * state.angle;
  }
  return rates;
}

std::vector<Crossing> Run::crossings(const Observer& observer) const {
  const auto* fixed = dynamic_cast<const UniformTurn*>(propagator_.fixed_axis());
  if (fixed_axis_ != 0 && fixed != nullptr) return uniform_crossings(*fixed);
  crossings_.look_until(t1(), observer);
  std::vector<Crossing> result = crossings_.list();
  const auto turns = static_cast<double>(2 * turn_.double_turns);
  for (Crossing& crossing : result) {
    crossing.turn_before += turns;
    crossing.turn_after += turns;
    crossing.multiple += turns;
    if (fixed_axis_ == 0) continue;
    crossing.axis = axis_;
    crossing.axis_rate = Vector::Zero();
  }
  return result;
}

// theta passes through every multiple of 2 pi between its ends: not through one that it starts or
// ends at, as far as its rounding tells.
std::vector<Crossing> Run::uniform_crossings(const UniformTurn& flow) const {
  std::vector<Crossing> result;
  if (flow.rate() == 0) return result;
  Extended begin = fixed_axis_angle(t0()) / kTwoPi;
  Extended end = fixed_axis_angle(t1()) / kTwoPi;
  if (turn_.on_zero) begin = std::round(begin);
  const double of_t =
      kEpsilon * (std::abs(t0()) + std::abs(t1())) * std::abs(static_cast<double>(flow.rate()));
  const double rounding = kEpsilon * static_cast<double>(std::abs(end * kTwoPi)) + of_t;
  if (std::abs(end - std::round(end)) * kTwoPi <= crossing_tolerance() + rounding) {
    end = std::round(end);
  }
  if (std::abs(end - begin) > 1e6L) {
    throw std::length_error("crossings: about " +
                            text(static_cast<double>(std::abs(end - begin)), 3) +
                            " of them, more than a million: too many to list");
  }
  const double up = end > begin ? 1 : -1;
  const Extended rate = fixed_axis_ * flow.rate();
  for (Extended k = up > 0 ? std::floor(begin) + 1 : std::ceil(begin) - 1; (end - k) * up > 0;
       k += up) {
    const auto turn = static_cast<double>(k);
    Crossing crossing;
    crossing.t = static_cast<double>(t0() + (kTwoPi * k - from_.angle()) / rate);
    crossing.t_error = propagator_.error_estimate / std::abs(static_cast<double>(rate)) +
                       kEpsilon * (std::abs(t0()) + std::abs(crossing.t));
    crossing.kind = Passage::kThrough;
    crossing.multiple = turn;
    crossing.turn_before = up > 0 ? turn - 1 : turn;
    crossing.turn_after = up > 0 ? turn : turn - 1;
    crossing.order = 0;
    crossing.derivative = omega_(crossing.t);
    crossing.by_jets = true;
    crossing.axis = axis_;
    crossing.axis_rate = Vector::Zero();
    result.push_back(crossing);
  }
  return result;
}

std::vector<std::string> Run::notes(const Observer& observer) const {
  std::vector<std::string> result;
  const std::vector<Crossing> list = crossings(observer);
  if (fixed_axis_ == 0 && !crossings_.note_of_start().empty()) {
    result.push_back(crossings_.note_of_start());
  }
  for (const Crossing& crossing : list) {
    if (!crossing.note.empty())
      result.push_back("at t = " + text(crossing.t) + ": " + crossing.note);
  }
  if (fixed_axis_ == 0 && !crossings_.note_of_end().empty()) {
    result.push_back("at the end: " + crossings_.note_of_end());
  }
  return result;
}

void visit_times(std::span<const double> times, const Observer& observer,
                 const std::function<void(double)>& visit) {
  for (const double t : times) {
    if (observer && !observer(t)) throw Interrupted();
    visit(t);
  }
}

Run evolve(const Scene& scene, const Rotation& from, const Observer& observer,
           std::vector<Vector> points, std::optional<double> crossing_tolerance) {
  return {scene.omega, propagate(scene, observer, from), from, std::move(points),
          crossing_tolerance};
}

}  // namespace rotor
