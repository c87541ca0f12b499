// The classical method with fixed steps, and its error.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "integrate/dense.hpp"
#include "integrate/sampler.hpp"
#include "integrate/step.hpp"

namespace rotor {

/// RK4 with n >= 2 equal steps; dense output by the Hermite cubic.
///
/// Error, at no call of omega: over every two neighbouring steps the method is run again with twice
/// the step on the samples that are there; a fifteenth of the difference is the error e_i of the
/// two (Richardson). Seen from the body such errors stay as they are while the motion goes on (the
/// flow is an isometry), so they are added there as rotation vectors, with their signs. Each step
/// lies in two pairs, the first and last in one: sum e_i / 2 + (e_1 + e_last) / 4.
template <class Equation>
class Rk4 {
 public:
  using Value = typename Equation::Value;

  Rk4(Sampler omega, const Value& start, double t0, double t1, std::size_t n)
      : omega_(std::move(omega)), sum_(start), dense_(t0, 3), t0_(t0), t1_(t1), n_(n) {}

  double next(double) const {
    const std::size_t i = dense_.pieces() + 1;
    return i == n_ ? t1_ : t0_ + (t1_ - t0_) * (static_cast<double>(i) / static_cast<double>(n_));
  }

  bool step(double t, double t_next) {
    const double h = t_next - t;
    const Vector start = omega_.at_node(t);
    const Vector middle = omega_(t + 0.5 * h);
    const Vector end = omega_(t_next);
    omega_.set_node(t_next, end);

    const Value y0 = sum_.value();
    const auto k = stages<Equation>(kRk4Tableau, std::array{start, middle, middle, end}, y0, h);
    sum_.add(h * weighted_sum(kRk4Tableau.b, k));
    sum_.add(Equation::restoring(sum_.value()));
    const Value& y1 = sum_.value();
    if (!y1.allFinite()) {
      throw StepOverflow("step overflow: step = " + text(h, 3) +
                         " is far too long for |omega| = " + text(norm(start), 3));
    }
    const Value f0 = y1 - y0;
    const Value slope1 = Equation::rate(end, y1);
    dense_.append(t_next, y0,
                  std::array<Value, 3>{f0, h * k[0] - f0, 2 * f0 - h * (k[0] + slope1)});

    rounding_.add(RoundingError::of_step(t_next, h, start, end), sum_of_squares(kRk4Tableau.b));
    const Value third = 4 / h * (k[0] - k[1] - k[2] + slope1);  // h times the third derivative
    // The first step alone has nothing to be compared with but the midpoint method, of order 2.
    if (dense_.pieces() == 1) alone_ = Equation::rotation_error(y0, f0 - h * k[1]);
    if (dense_.pieces() > 1) add_errors(t_next, start, end, third);
    // Beyond its limit of stability (2.8 for the slope omega/2) the method says nothing.
    if (std::abs(h) * std::max({norm(start), norm(middle), norm(end)}) > 5.6) useless_ = true;
    before_ = {t, y0, start, third};
    return true;
  }

  const DenseOutput<Value>& dense() const { return dense_; }

  /// The greatest error at a node, of the interpolation between nodes, and of rounding, together.
  double error_estimate() const {
    if (useless_) return std::numbers::pi;
    return (dense_.pieces() == 1 ? alone_ : greatest_ + doubt_ + interpolation_) +
           rounding_.estimate();
  }

 private:
  struct Before {
    double t;
    Value y;
    Vector omega;
    Value third;
  };

  void add_errors(double t_next, const Vector& middle, const Vector& end, const Value& third) {
    const Value& y = sum_.value();
    const Value coarse =
        before_.y + increment<Equation>(kRk4Tableau, std::array{before_.omega, middle, middle, end},
                                        before_.y, t_next - before_.t);
    last_ = Equation::body_error(y, (y - coarse) / 15);
    if (dense_.pieces() == 2) first_ = last_;
    error_ += last_ / 2;
    greatest_ = std::max(greatest_, (error_ + (first_ + last_) / 4).norm());
    // An error that leaps is no longer of order 5 in the step: omega is not smooth there, and the
    // difference itself is the error, as far as can be told. Each step lies in two pairs.
    const double size = last_.norm();
    if (dense_.pieces() > 3 && size > 8 * sizes_[0]) doubt_ += 15 * size / 2;
    sizes_ = {sizes_[1], size};
    // The Hermite cubic errs by h^4/384 times the fourth derivative at the middle of a step.
    const double h = (t_next - before_.t) / 2;
    interpolation_ = std::max(interpolation_,
                              Equation::rotation_error(y, h * h / 384 * (third - before_.third)));
  }

  Sampler omega_;
  CompensatedSum<Value> sum_;
  DenseOutput<Value> dense_;
  RoundingError rounding_;
  double t0_;
  double t1_;
  std::size_t n_;
  Before before_{};
  Vector error_ = Vector::Zero();  // sum e_i / 2
  Vector first_ = Vector::Zero();  // e_1
  Vector last_ = Vector::Zero();
  std::array<double, 2> sizes_{};  // of the errors of the two pairs before the last
  double doubt_ = 0;
  double greatest_ = 0;
  double alone_ = 0;
  bool useless_ = false;
  double interpolation_ = 0;
};

}  // namespace rotor
