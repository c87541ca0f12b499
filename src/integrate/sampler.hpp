// omega as the integrators see it: every call counted, the last node of a step shared with the
// next.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

#include "integrate/loop.hpp"
#include "spin/angular_velocity.hpp"

namespace rotor {

/// The generator of the motion: omega in the space frame, -omega in the body frame (Flow). Knows
/// where omega jumps: a step must not reach over a break, and its ends there are taken as the
/// limits from inside the step.
class Sampler {
 public:
  /// `breaks` rise.
  Sampler(const AngularVelocity& omega, Cost& cost, std::vector<double> breaks = {})
      : omega_(omega),
        cost_(cost),
        breaks_(std::move(breaks)),
        sign_(omega.frame() == Frame::kSpace ? 1 : -1) {}

  Vector operator()(double t) {
    ++cost_.omega_calls;
    last_ = t;
    return sign_ * omega_(t);
  }
  /// The time of the last call.
  double last() const { return last_; }
  bool dear() const { return omega_.dear(); }

  /// The first break on the way from t to t_next, which a step must not pass, else t_next.
  double clip(double t, double t_next) const {
    if (breaks_.empty() || t == t_next) return t_next;
    if (t_next > t) {
      const auto next = std::upper_bound(breaks_.begin(), breaks_.end(), t);
      return next == breaks_.end() ? t_next : std::min(*next, t_next);
    }
    const auto after = std::lower_bound(breaks_.begin(), breaks_.end(), t);
    return after == breaks_.begin() ? t_next : std::max(*std::prev(after), t_next);
  }

  /// The value at one end of a step whose other end is `other`: kept from the step before, or from
  /// a rejected try, unless t is a break.
  Vector at_node(double t, double other) {
    if (is_break(t)) return (*this)(std::nextafter(t, other));
    if (!has_node_ || node_ != t) set_node(t, (*this)(t));
    return value_;
  }
  /// At the end of an accepted step: the value there, for the next one.
  void set_node(double t, const Vector& value) {
    node_ = t;
    value_ = value;
    has_node_ = true;
  }

  bool is_break(double t) const { return std::binary_search(breaks_.begin(), breaks_.end(), t); }

 private:
  const AngularVelocity& omega_;
  Cost& cost_;
  std::vector<double> breaks_;
  double sign_;
  double last_ = 0;
  bool has_node_ = false;
  double node_ = 0;
  Vector value_ = Vector::Zero();
};

/// What rounding adds to a run, in rad: independent errors of the steps, added in squares.
///
/// A sample of omega is rounded to half an ulp, and so is its argument, as a rule some multiple of
/// t: that changes it by u |t| times its rate. A uniform error of half-width d has the variance
/// d^2/3; a step h sum b_i omega_i makes h^2 sum b_i^2 times that of it.
class RoundingError {
 public:
  /// The half-width for one step of length h ending at t, were its weights of square sum 1.
  static double of_step(double t, double h, const Vector& omega0, const Vector& omega1) {
    constexpr double u = std::numeric_limits<double>::epsilon() / 2;
    return u * (std::abs(h) * std::max(norm(omega0), norm(omega1)) +
                std::abs(t) * norm(omega1 - omega0));
  }
  /// A step of that half-width, by a method whose weights have this sum of squares.
  void add(double of_step, double squares_of_weights) {
    variance_ += squares_of_weights * of_step * of_step / 3;
  }
  /// Three standard deviations, and the rounding of the value that is read: 4 components of half an
  /// ulp.
  double estimate() const {
    return 3 * std::sqrt(variance_) + 2 * std::numeric_limits<double>::epsilon();
  }

 private:
  double variance_ = 0;
};

}  // namespace rotor
