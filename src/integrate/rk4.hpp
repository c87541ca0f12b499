// The classical method with fixed steps, and its error.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "integrate/dense.hpp"
#include "integrate/sampler.hpp"
#include "integrate/step.hpp"
#include "rotation/text.hpp"

namespace rotor {

/// The number of equal steps of RK4 over a length: two at least, none longer than `step` (but by
/// rounding). May be infinite.
inline double rk4_steps(double length, double step) {
  return std::max(2.0, std::ceil(length / step * (1 - 1e-12)));
}

/// RK4 with equal steps over each of the parts that end at the times given; dense output by the
/// Hermite cubic.
///
/// Error, at no call of omega: over every two neighbouring steps of a part the method is run again
/// with twice the step on the samples that are there; a fifteenth of the difference is the error
/// e_i of the two (Richardson). Seen from the body such errors stay as they are while the motion
/// goes on (the flow is an isometry), so they are added there as rotation vectors, with their
/// signs. Each step lies in two pairs, the first and last of a part in one: sum e_i / 2 + (e_1 +
/// e_last) / 4.
///
/// A step that would pass a singularity of the equation is rejected, and none shorter is proposed.
template <class Equation>
class Rk4 {
 public:
  using Value = typename Equation::Value;

  /// `ends`, in the order of travel, the last one the end of the run.
  Rk4(Sampler omega, Equation equation, const Value& start, double t0, std::vector<double> ends,
      double step)
      : omega_(std::move(omega)),
        equation_(std::move(equation)),
        sum_(start),
        dense_(t0, 3),
        ends_(std::move(ends)),
        step_(step) {
    begin_part(t0);
  }

  double next(double t) const {
    if (at_singularity_) return t;
    if (taken_ + 1 == steps_) return ends_[part_];
    return begin_ + (ends_[part_] - begin_) *
                        (static_cast<double>(taken_ + 1) / static_cast<double>(steps_));
  }

  bool must_end(double t) const { return omega_.is_break(t); }

  bool step(double t, double t_next) {
    const double h = t_next - t;
    const Vector start = omega_.at_node(t, t_next);
    const Vector middle = omega_(t + 0.5 * h);
    const Vector end = omega_.at_node(t_next, t);

    const Value y0 = sum_.value();
    const auto k = stages(equation_, kRk4Tableau, std::array{start, middle, middle, end}, y0, h);
    CompensatedSum<Value> sum = sum_;
    sum.add(h * weighted_sum(kRk4Tableau.b, k));
    sum.add(equation_.restoring(sum.value()));
    const Value y1 = sum.value();
    if (!goes_on(y0, h / 6 * (start + 4 * middle + end), y1)) return false;
    if (!y1.allFinite()) {
      throw StepOverflow("step overflow: step = " + text(h, 3) +
                         " is far too long for |omega| = " + text(norm(start), 3));
    }
    sum_ = sum;
    const Value f0 = y1 - y0;
    const Value slope1 = equation_.rate(end, y1);
    dense_.append(t_next, y0,
                  std::array<Value, 3>{f0, h * k[0] - f0, 2 * f0 - h * (k[0] + slope1)});

    ++taken_;
    stretch_ = std::max(stretch_, equation_.stretch(y1));
    const double turn = std::abs(h) * std::max({norm(start), norm(middle), norm(end)});
    rounding_.add(
        RoundingError::of_step(t_next, h, start, end) + state_rounding(equation_, y0, turn),
        sum_of_squares(kRk4Tableau.b));
    const Value third = 4 / h * (k[0] - k[1] - k[2] + slope1);  // h times the third derivative
    // The first step alone has nothing to be compared with but the midpoint method, of order 2.
    if (taken_ == 1) alone_ = equation_.body_error(y0, f0 - h * k[1]).norm();
    if (taken_ > 1) add_errors(t_next, start, end, third);
    // Nor has a step that is as long as the way left to a singularity: it has no series there.
    if (equation_.distance(y1) < 2 * turn) doubt_ += equation_.body_error(y0, f0 - h * k[1]).norm();
    // Beyond its limit of stability (2.8 for the slope omega/2) the method says nothing.
    if (turn > 5.6) useless_ = true;
    before_ = {t, y0, start, third, false};
    if (equation_.is_due(y1)) restart();
    if (t_next == ends_[part_] && part_ + 1 < ends_.size()) {
      error_ += (first_ + last_) / 4;
      ++part_;
      begin_part(t_next);
    }
    return true;
  }

  const DenseOutput<Value>& dense() const { return dense_; }
  const Value& value() const { return sum_.value(); }
  /// Whether the last step was rejected, for it would have passed a singularity.
  bool at_singularity() const { return at_singularity_; }

  /// The greatest error at a node, of the interpolation between nodes, and of rounding, together.
  double error_estimate() const {
    if (useless_) return std::numbers::pi;
    return greatest_ + doubt_ + interpolation_ + (taken_ == 1 ? alone_ : 0) + rounding_.estimate() +
           std::numeric_limits<double>::epsilon() * stretch_;
  }

 private:
  struct Before {
    double t;
    Value y;
    Vector omega;
    Value third;
    bool restarted;
  };

  void begin_part(double t) {
    begin_ = t;
    steps_ = static_cast<std::size_t>(rk4_steps(std::abs(ends_[part_] - t), step_));
    taken_ = 0;
  }

  bool goes_on(const Value& y0, const Vector& turn, const Value& y1) {
    const bool regular = std::isinf(equation_.distance(y0));
    at_singularity_ = !regular && (!y1.allFinite() || equation_.reach(y0, turn, y1) > 1);
    return !at_singularity_;
  }

  // The step before is then seen from the new y too, so that the next pair may hold it.
  void restart() {
    before_.y = equation_.restarted(before_.y);
    before_.restarted = true;
    sum_ = CompensatedSum<Value>(equation_.restarted(sum_.value()));
    rounding_.add(std::numeric_limits<double>::epsilon() * equation_.stretch(sum_.value()), 1);
  }

  void add_errors(double t_next, const Vector& middle, const Vector& end, const Value& third) {
    const Value& y = sum_.value();
    const Value coarse = before_.y + increment(equation_, kRk4Tableau,
                                               std::array{before_.omega, middle, middle, end},
                                               before_.y, t_next - before_.t);
    last_ = equation_.body_error(y, (y - coarse) / 15);
    if (taken_ == 2) first_ = last_;
    error_ += last_ / 2;
    greatest_ = std::max(greatest_, (error_ + (first_ + last_) / 4).norm());
    // An error that leaps is no longer of order 5 in the step: omega is not smooth there, and the
    // difference itself is the error, as far as can be told. Each step lies in two pairs.
    const double size = last_.norm();
    if (taken_ > 3 && size > 8 * sizes_[0]) doubt_ += 15 * size / 2;
    sizes_ = {sizes_[1], size};
    if (before_.restarted) return;  // its third derivative is that of the y before
    // The Hermite cubic errs by h^4/384 times the fourth derivative at the middle of a step.
    const double h = (t_next - before_.t) / 2;
    const Vector hermite = equation_.body_error(y, h * h / 384 * (third - before_.third));
    interpolation_ = std::max(interpolation_, hermite.norm());
  }

  Sampler omega_;
  Equation equation_;
  CompensatedSum<Value> sum_;
  DenseOutput<Value> dense_;
  RoundingError rounding_;
  std::vector<double> ends_;
  double step_;
  std::size_t part_ = 0;
  double begin_ = 0;       // of the part
  std::size_t steps_ = 0;  // of the part
  std::size_t taken_ = 0;
  bool at_singularity_ = false;
  Before before_{};
  Vector error_ = Vector::Zero();  // sum e_i / 2, and what the parts before add at their ends
  Vector first_ = Vector::Zero();  // e_1 of the part
  Vector last_ = Vector::Zero();
  std::array<double, 2> sizes_{};  // of the errors of the two pairs before the last
  double doubt_ = 0;
  double greatest_ = 0;
  double alone_ = 0;
  bool useless_ = false;
  double interpolation_ = 0;
  double stretch_ = 0;
};

}  // namespace rotor
