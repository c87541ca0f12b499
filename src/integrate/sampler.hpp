// omega as the integrators see it: every call counted, the last node of a step shared with the
// next.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "integrate/loop.hpp"
#include "spin/angular_velocity.hpp"

namespace rotor {

class Sampler {
 public:
  Sampler(const AngularVelocity& omega, Cost& cost) : omega_(omega), cost_(cost) {}

  Vector operator()(double t) {
    ++cost_.omega_calls;
    return omega_(t);
  }

  /// The value at the start of a step: kept from the end of the one before, or from a rejected try.
  Vector at_node(double t) {
    if (!has_node_ || node_ != t) set_node(t, (*this)(t));
    return value_;
  }
  void set_node(double t, const Vector& value) {
    node_ = t;
    value_ = value;
    has_node_ = true;
  }

 private:
  const AngularVelocity& omega_;
  Cost& cost_;
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
