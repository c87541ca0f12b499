#include "integrate/generalized.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "integrate/charts.hpp"
#include "rotation/extended.hpp"
#include "rotation/small_angle.hpp"
#include "rotation/text.hpp"

namespace rotor {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kFar = 1000 * kPi;
constexpr double kLongestStep = kPi / 8;

// The value and the slope that a Taylor series gives at a distance s from its centre.
GeneralizedAngle::Value taylor(const Jet& jet, double s) {
  GeneralizedAngle::Value sum{0, 0};
  for (std::size_t k = Jet::kOrder + 1; k-- > 0;) {
    sum.slope = sum.slope * s + sum.f;
    sum.f = sum.f * s + jet.c[k];
  }
  return sum;
}

// Whether f rises from one place to the next, and the series of both say the same in the middle:
// between them f is then smooth and without a pole. A tenth of a percent is a matter of the length
// of the step, for the eighth derivative has its say there; rounding adds to that.
bool goes_on(const Jet& low, const Jet& high, double step, double slope_rounding) {
  const double slope = std::max(low.c[1], high.c[1]);
  const double rounding = 4 * kEpsilon * std::abs(high.c[0]);
  if (!(high.c[1] > 0 && std::isfinite(slope) && high.c[0] - low.c[0] >= -rounding)) return false;
  const GeneralizedAngle::Value from_low = taylor(low, step / 2);
  const GeneralizedAngle::Value from_high = taylor(high, -step / 2);
  return std::abs(from_low.f - from_high.f) <= 1e-3 * slope * step + rounding &&
         std::abs(from_low.slope - from_high.slope) <= 1e-3 * slope + slope_rounding;
}

}  // namespace

GeneralizedAngle::GeneralizedAngle(Function f, std::string name)
    : f_(std::move(f)), name_(std::move(name)) {
  check_at_zero();
  explore();
  check_odd();
}

Jet GeneralizedAngle::jet(double theta) const {
  try {
    return f_(Jet::variable(theta));
  } catch (const NotDifferentiable&) {
    Jet none;
    none.c.fill(kNaN);
    return none;
  }
}

GeneralizedAngle::Value GeneralizedAngle::operator()(double theta) const {
  const Jet f = jet(theta);
  return {f.c[0], f.c[1]};
}

void GeneralizedAngle::check_at_zero() {
  const Jet f = f_(Jet::variable(0));  // here even NotDifferentiable is the caller's to know
  if (f.c[0] != 0) {
    throw std::invalid_argument(name_ + ": expected an odd function, with " + name_ +
                                "(0) = 0, got " + text(f.c[0]));
  }
  if (!(f.c[1] > 0 && std::isfinite(f.c[1]))) {
    throw std::invalid_argument(name_ + ": expected a function that rises at 0, its derivative " +
                                "there is " + text(f.c[1]));
  }
  slope_at_zero_ = f.c[1];
}

void GeneralizedAngle::check_odd() const {
  for (const double part : {0.1, 0.37, 0.9}) {
    const double theta = part * std::min(end_, 2 * kPi);
    const double plus = jet(theta).c[0];
    const double minus = jet(-theta).c[0];
    if (!(std::abs(plus + minus) <= 1e-12 * std::abs(plus))) {
      throw std::invalid_argument(name_ + ": expected an odd function, got " + text(plus) + " at " +
                                  text(theta) + " and " + text(minus) + " at " + text(-theta));
    }
  }
}

// Steps that grow while all goes well, and halve where it does not: they close in on the end.
void GeneralizedAngle::explore() {
  angles_ = {0};
  values_ = {0};
  Jet low = jet(0);
  double step = kPi / 64;
  for (double theta = 0; theta < kFar;) {
    const double next = theta + step;
    if (next <= theta || step <= kEpsilon / 2 * theta) {
      end_ = next > theta ? next : std::nextafter(theta, kInfinity);
      break;
    }
    const Jet high = jet(next);
    const double slope_rounding = 8 * kEpsilon * (slope_at_zero_ + std::abs(high.c[2]) * next);
    bool fine = goes_on(low, high, next - theta, slope_rounding);
    if (fine && low.c[2] < 0 && high.c[2] > 0) {
      const double least = least_slope_at(theta, next);
      const double slope = jet(least).c[1];
      if (std::abs(slope) <= slope_rounding) {
        end_ = least;
        return;
      }
      fine = slope > 0;
    }
    if (!fine) {
      step /= 2;
      continue;
    }
    theta = next;
    low = high;
    step = std::min(2 * step, kLongestStep);
    angles_.push_back(theta);
    values_.push_back(std::max(values_.back(), high.c[0]));  // but for rounding it is that
  }
  if (angles_.back() >= kFar) end_ = kInfinity;
  if (angles_.size() == 1) {
    throw std::invalid_argument(name_ + ": expected a function that is smooth at 0");
  }
}

// Where f'' changes its sign.
double GeneralizedAngle::least_slope_at(double low, double high) const {
  for (;;) {
    const double middle = std::midpoint(low, high);
    if (middle == low || middle == high) return middle;
    (jet(middle).c[2] < 0 ? low : high) = middle;
  }
}

GeneralizedAngle::Bracket GeneralizedAngle::bracket(double value) const {
  const auto next = std::upper_bound(values_.begin(), values_.end(), value);
  if (next != values_.end()) {
    const auto i = static_cast<std::size_t>(next - values_.begin());
    const double part = (value - values_[i - 1]) / (values_[i] - values_[i - 1]);
    return {angles_[i - 1], std::lerp(angles_[i - 1], angles_[i], part), angles_[i]};
  }
  double low = angles_.back();
  if (value == values_.back()) return {low, low, low};
  if (end_ < kInfinity) return {kNaN, kNaN, kNaN};
  double high = low;
  do {
    low = high;
    high *= 2;
  } while (high < kInfinity && (*this)(high).f < value);
  return {low, low, high};
}

double GeneralizedAngle::inverse(double value) const {
  if (!(value >= 0) || std::isinf(value)) return kNaN;
  auto [low, theta, high] = bracket(value);
  if (!std::isfinite(high)) return kNaN;
  // Newton's method, and halving where it does not stay inside the bracket, which so shrinks.
  for (;;) {
    const Value at = (*this)(theta);
    if (at.f == value) return theta;
    (at.f > value ? high : low) = theta;
    double next = theta - (at.f - value) / at.slope;
    if (std::abs(next - theta) <= kEpsilon * theta) return next;
    if (!(next > low && next < high)) next = std::midpoint(low, high);
    if (!(next > low && next < high)) return next;
    theta = next;
  }
}

// --- [P4]

Vector GeneralizedEquation::start(const Rotation& r) const {
  const double theta = std::abs(r.angle());
  if (restart_ && theta >= f_->end() && theta > kPi) return start(r.canonical());
  const double f = (*f_)(theta).f;
  refuse_start(singularity(Vector(std::isfinite(f) ? f : kInfinity, 0, 0)), r,
               std::min(distance_from_full_turns(theta), f_->end() - theta));
  const Value y = r.axis() * std::copysign(f, r.angle());
  if (!is_due(y)) return y;
  const Rotation same = r.canonical();  // what restarting comes to
  return same.axis() * std::copysign((*f_)(std::abs(same.angle())).f, same.angle());
}

Vector GeneralizedEquation::rate(const Vector& omega, const Value& y) const {
  const ExtendedVector wide = y.cast<Extended>();
  const ExtendedVector w = omega.cast<Extended>();
  const double theta = angle(y);
  if (theta == 0) return f_->slope_at_zero() * omega;
  const Extended size = wide.norm();
  const Extended slope = (*f_)(theta).slope;
  // Where f (1 - g)/theta and f' - f/theta are of the order theta^2, nothing is lost: they are
  // parts of a sum with terms of order 1.
  const Extended outward = size / theta * half_cot(theta);
  const ExtendedVector n = wide / size;
  return (outward * w + (slope - outward) * n.dot(w) * n + w.cross(wide) / 2).cast<double>();
}

Vector GeneralizedEquation::body_error(const Value& y, const Value& dy) const {
  const double theta = angle(y);
  if (theta == 0) return dy / f_->slope_at_zero();
  const ExtendedVector n = y.cast<Extended>() / y.cast<Extended>().norm();
  const ExtendedVector d = dy.cast<Extended>();
  const Extended slope = (*f_)(theta).slope;
  const Extended along = n.dot(d);
  // The body's N15 of theta' = n . F'/f' and n' = (F' - n (n . F'))/f.
  const Extended per_length = theta / y.cast<Extended>().norm();
  return (n * (along / slope) +
          per_length * (sinc(theta) * (d - n * along) - theta * one_minus_cos(theta) * n.cross(d)))
      .cast<double>();
}

Quaternion GeneralizedEquation::quaternion(const Value& y) const {
  if (y.isZero(0)) return Quaternion::Identity();
  const double theta = angle(y);  // none where dense output has rounded over the end of the domain
  return Rotation(y, std::isnan(theta) ? f_->end() : theta).quaternion();
}

double GeneralizedEquation::distance(const Value& y) const {
  const double theta = angle(y);
  return std::min(distance_from_full_turns(theta), f_->end() - theta);
}

double GeneralizedEquation::reach(const Value& y0, const Vector& turn, const Value& y1) const {
  const double theta = angle(y0);
  if (!same_turn(theta, angle(y1))) return kInfinity;  // or none at y1
  if (f_->end() < kInfinity) {
    // Nothing shows in F where f' is 0: there the motion is that of a uniform turn.
    Quaternion q = from_euler_vector(turn).quaternion() * quaternion(y0);
    const double turns = std::floor(theta / (2 * kPi));
    if (std::fmod(turns, 2) != 0) q.coeffs() *= -1;
    if (2 * kPi * turns + 2 * std::atan2(q.vec().norm(), q.w()) >= f_->end()) return kInfinity;
  }
  return reach_across(theta, across(turn, y0.stableNormalized()));
}

std::string GeneralizedEquation::singularity(const Value& y) const {
  const double theta = angle(y);
  const bool at_end = !(f_->end() - theta > distance_from_full_turns(theta));
  return "equation = \"generalized\" [P4] is singular at theta = " +
         (at_end ? text(f_->end()) + ", where the domain of " + f_->name() + " ends"
                 : full_turns_text(std::max(theta, 2 * kPi))) +
         "; equation = \"quaternion\" is never singular";
}

double GeneralizedEquation::stretch(const Value& y) const {
  return y.isZero(0) ? 0 : norm(y) / (*f_)(angle(y)).slope;
}

// Halfway from pi to the end of the domain where that is nearer: it restarts from below pi.
bool GeneralizedEquation::is_due(const Value& y) const {
  return restart_ && angle(y) > std::clamp((kPi + f_->end()) / 2, kPi, 1.5 * kPi);
}

Vector GeneralizedEquation::restarted(const Value& y) const {
  if (y.isZero(0)) return y;
  const double theta = angle(y);
  const Extended turns = std::floor(theta / (2 * kPi)) + 1;
  const auto rest = static_cast<double>(turns * 2 * std::numbers::pi_v<Extended> - theta);
  return -unit(y) * (*f_)(rest).f;
}

}  // namespace rotor
