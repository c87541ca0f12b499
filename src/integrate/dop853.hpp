// The adaptive method of order 8 of Dormand and Prince, with the whole run's error shared out.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "integrate/control.hpp"
#include "integrate/dense.hpp"
#include "integrate/dop853_tableau.hpp"
#include "integrate/node_quadrature.hpp"
#include "integrate/sampler.hpp"
#include "integrate/step.hpp"

namespace rotor {

/// DOP853 from t0 to t1 with the error of the whole run kept within `accuracy`, or at the level of
/// rounding where that is more. 14 calls of omega an accepted step: stages that share a node share
/// its sample.
///
/// The error of a step is what its dense output itself says, at no further call of omega: the
/// angular velocity w~ that it really has against the samples w. By [theory 4.9] the error of the
/// step is the integral of R~^T (w~ - w), seen from the body. The defect is a polynomial of degree
/// 7 in its leading order h^7, 8 in the next, 9 in the third; the true local error is of order h^9,
/// so a quadrature of degree 9 has it with an error O(h^2). What the defect has beyond degree 9
/// shows where omega is not smooth enough for that: what a jump that leaves so much could have
/// hidden is added to the error that steps are judged by.
///
/// Where that is lost in rounding, the classical estimate by embedded methods of order 5 and 3
/// decides: for short steps it is 20 to 500 times too large, and so stands further above rounding.
/// There the method's weights, of square sum 57, have amplified the rounding of the samples, and
/// those of the quadrature have not: such a step is corrected by the error found.
///
/// A step that would pass a singularity of the equation, or a break, is not taken: steps shrink
/// towards the former until the time does not resolve them, and end at the latter.
template <class Equation>
class Dop853 {
 public:
  using Value = typename Equation::Value;

  Dop853(Sampler omega, Equation equation, const Value& start, double t0, double t1,
         double accuracy, double max_step)
      : omega_(std::move(omega)),
        equation_(std::move(equation)),
        sum_(start),
        dense_(t0, 7),
        budget_(0.75 * accuracy, std::abs(t1 - t0)),
        between_nodes_(0.25 * accuracy),
        longest_stretch_(std::max(1e3, accuracy / (16 * std::numeric_limits<double>::epsilon()))),
        t0_(t0),
        t1_(t1),
        max_step_(std::min(max_step, std::abs(t1 - t0))) {}

  double next(double t) {
    if (exhausted_) return t;
    if (h_ == 0) h_ = first_step();
    return step_towards(omega_.clip(t, t1_), t, h_);
  }

  bool must_end(double t) const { return omega_.is_break(t); }

  bool step(double t, double t_next) {
    const double h = t_next - t;
    const auto omega = samples(t, t_next);
    const Value y0 = sum_.value();
    std::array<Vector, 12> stage_omega;
    std::copy_n(omega.begin(), 12, stage_omega.begin());
    const auto k = stages(equation_, kDop853Tableau, stage_omega, y0, h);
    CompensatedSum<Value> sum = sum_;
    sum.add(h * weighted_sum(kDop853Tableau.b, k));
    sum.add(equation_.restoring(sum.value()));
    const auto piece = dense_piece(y0, sum.value(), omega, k, h);
    turn_ = std::abs(h) * greatest_component(omega);
    const double of_state = state_rounding(equation_, y0, turn_);
    const double rounding = RoundingError::of_step(t_next, h, omega[0], omega[11]) + of_state;
    // Where a sum of waves stands still, the rounding of their arguments does not.
    const double scatter = std::max(rounding, kUnit * std::abs(t_next) * steepest_ * std::abs(h));
    const StepError error = error_of(y0, piece, omega, h, scatter);

    double judged = error.at_end().norm() + error.doubt;
    if (error.lost_in_rounding) judged = std::min(judged, embedded_error(y0, k, h, scatter));
    double allowed = allowed_error(t, t_next, rounding, std::max(norm(omega[0]), norm(omega[11])));
    // Next to a singularity the rounding of y is all that an estimate shows, however short the
    // step.
    if (equation_.distance(y0) < 0.1) allowed = std::max(allowed, 16 * of_state);
    const double between = error.greatest_between();
    // Between nodes rounding is larger: the weights of F4 and F5 reach 480 and 690 (roots of their
    // square sums), their factors x^3 x'^2 and x^3 x'^3 at most 1/29 and 1/64: 20 roundings, six
    // times that at the worst.
    const double between_allowed = std::max({between_nodes_, allowed, 128 * rounding});
    double factor = std::min(step_factor(judged, allowed, kDop853Tableau.order),
                             step_factor(between, between_allowed, kDop853Tableau.order));
    reach_ = equation_.reach(y0, h * weighted_sum(kDop853Tableau.b, stage_omega), sum.value());
    factor = std::max(0.2, std::min({factor, 0.9 * kLongestTurn / turn_, 0.9 / reach_}));
    const bool accepted =
        judged <= allowed && between <= between_allowed && turn_ <= kLongestTurn && reach_ <= 1;
    propose(t, h, factor, accepted);
    if (!accepted) {
      omega_.set_node(t, omega[0]);
      return false;
    }

    // Short steps look for a jump, whose chord says nothing.
    longest_ = std::max(longest_, std::abs(h));
    if (error.doubt == 0 && std::abs(h) > longest_ / 16) {
      steepest_ = std::max(steepest_, norm(omega[11] - omega[0]) / std::abs(h));
    }
    budget_.spend(judged);
    record(error, rounding);
    if (error.lost_in_rounding) sum.add(equation_.turning(sum.value(), -error.at_end()));
    sum_ = sum;
    dense_.append(t_next, y0, piece);
    const double stretch = equation_.stretch(sum.value());
    stretch_ = std::max(stretch_, stretch);
    const double distance = equation_.distance(sum.value());
    exhausted_ = (distance < 0.1 && stretch > longest_stretch_) || distance <= kTooNear * stretch ||
                 (distance < 1e-6 && turn_ < 1e-3 * distance && error.doubt == 0);
    if (equation_.is_due(sum.value())) restart();
    return true;
  }

  const DenseOutput<Value>& dense() const { return dense_; }
  const Value& value() const { return sum_.value(); }
  /// Whether a singularity of the equation is so near, in units of the last step that was tried or
  /// of the rounding of y, that it alone makes steps short, or y tells the rotation too coarsely.
  bool at_singularity() const {
    return exhausted_ || reach_ > 0.1 ||
           equation_.distance(sum_.value()) <= std::max(1e3 * turn_, kTooNear * stretch_);
  }

  /// The greatest error at the nodes and between with its own uncertainty, and rounding.
  double error_estimate() const {
    return greatest_ + doubt_ + rounding_.estimate() +
           std::numeric_limits<double>::epsilon() * stretch_;
  }

 private:
  // About each axis, so that none is longer than 2 pi (of a flow, between the nodes of its mesh).
  static constexpr double kLongestTurn = 3.5;
  static constexpr double kUnit = std::numeric_limits<double>::epsilon() / 2;
  // A singularity as near as that, times the stretch, is lost in the rounding of y.
  static constexpr double kTooNear = 64 * std::numeric_limits<double>::epsilon();

  struct StepError {
    // Rotation vectors in the body frame: at 1, 1/8, 2/8, ... 7/8 of the step.
    Eigen::Matrix<double, 8, 3> integrals;
    double doubt;  // what a jump of omega could have hidden
    bool lost_in_rounding;

    Vector at_end() const { return integrals.row(0).transpose(); }
    double greatest_between() const {
      return integrals.bottomRows<7>().rowwise().norm().maxCoeff();
    }
  };

  // A hundredth of a radian of turning, or of the way to a singularity; without a hint a thousandth
  // of the way. Growth by 5 a step soon finds the right size, rejection the other way.
  double first_step() {
    const double rate = norm(omega_.at_node(t0_, t1_));
    const double turn = 0.01 * std::min(1.0, equation_.distance(sum_.value()));
    const double step = std::min({max_step_, 1e-3 * std::abs(t1_ - t0_), turn / rate});
    return std::max({step, 4 * shortest_step(t0_), std::numeric_limits<double>::denorm_min()});
  }

  void propose(double t, double h, double factor, bool accepted) {
    h_ = std::min(std::abs(h) * (after_rejection_ ? std::min(factor, 1.0) : factor), max_step_);
    // The shortest step is tried before the run is given up.
    if (accepted || std::abs(h) > 2 * shortest_step(t)) h_ = std::max(h_, 1.5 * shortest_step(t));
    after_rejection_ = !accepted;
  }

  // The run goes on from another y of the same operator.
  void restart() {
    sum_ = CompensatedSum<Value>(equation_.restarted(sum_.value()));
    rounding_.add(std::numeric_limits<double>::epsilon() * equation_.stretch(sum_.value()), 1);
  }

  static double greatest_component(const std::array<Vector, 15>& omega) {
    double greatest = 0;
    for (const Vector& sample : omega) {
      greatest = std::max(greatest, sample.lpNorm<Eigen::Infinity>());
    }
    return greatest;
  }

  // omega at the twelve nodes of the step and the three of its dense output. The nodes are rounded
  // to doubles; the chord of omega over the step corrects that to first order.
  std::array<Vector, 15> samples(double t, double t_next) {
    const double h = t_next - t;
    std::array<Vector, 15> omega;
    omega[0] = omega_.at_node(t, t_next);
    omega[11] = omega_.at_node(t_next, t);
    const Vector change = omega[11] - omega[0];
    for (std::size_t i = 1; i < 15; ++i) {
      if (i == 11) continue;
      const double c = step_node(i);
      const double node = t + c * h;
      omega[i] = omega_(node) + change * (std::fma(c, h, t - node) / h);
    }
    return omega;
  }

  std::array<Value, 7> dense_piece(const Value& y0, const Value& y1,
                                   const std::array<Vector, 15>& omega,
                                   const std::array<Value, 12>& k12, double h) const {
    std::array<Value, 16> k;
    std::copy(k12.begin(), k12.end(), k.begin());
    k[12] = equation_.rate(omega[11], y1);
    for (std::size_t i = 0; i < 3; ++i) {
      k[13 + i] = equation_.rate(omega[12 + i], y0 + h * weighted_sum(kDop853DenseA[i], k, 13 + i));
    }
    const Value f0 = h * weighted_sum(kDop853Tableau.b, k);
    std::array<Value, 7> f{f0, h * k[0] - f0, 2 * f0 - h * (k[0] + k[12])};
    for (std::size_t m = 0; m < 4; ++m) f[3 + m] = h * weighted_sum(kDop853DenseD[m], k);
    return f;
  }

  void record(const StepError& error, double rounding) {
    for (Eigen::Index i = error.lost_in_rounding ? 1 : 0; i < 8; ++i) {
      greatest_ = std::max(greatest_, (error_ + error.integrals.row(i).transpose()).norm());
    }
    if (error.lost_in_rounding) {
      rounding_.add(rounding, node_quadrature().weights.row(0).squaredNorm());
    } else {
      error_ += error.at_end();
      doubt_ += error.doubt;
      rounding_.add(rounding, sum_of_squares(kDop853Tableau.b));
    }
  }

  double allowed_error(double t, double t_next, double rounding, double rate) const {
    const double h = std::abs(t_next - t);
    if (h <= 2 * shortest_step(t) && !at_singularity()) {
      // A jump of omega falls within some shortest step, and t resolves it no better: a small turn
      // is then an error to be stated, a larger one may take all that is left.
      return h * rate < 1e-8 ? std::numeric_limits<double>::infinity() : budget_.left();
    }
    // Far below the rounding of a step nothing is gained: rounding adds at random, error in one
    // direction.
    return std::max(budget_.allowed(h, std::abs(t_next - t0_)), rounding / 64);
  }

  // Hairer's combination, O(h^8); what of e5 is rounding (its weights have the square sum 5) is no
  // error.
  double embedded_error(const Value& y, const std::array<Value, 12>& k, double h,
                        double rounding) const {
    const double e5 =
        equation_.body_error(y, h * weighted_sum(kDop853Error5, k)).norm() - 4 * rounding;
    const double e3 = equation_.body_error(y, h * weighted_sum(kDop853Error3, k)).norm();
    return e5 <= 0 ? 0 : e5 * (e5 / std::hypot(e5, 0.1 * e3));
  }

  StepError error_of(const Value& y0, const std::array<Value, 7>& piece,
                     const std::array<Vector, 15>& omega, double h, double rounding) const {
    Eigen::Matrix<double, 15, 3> defect;
    for (std::size_t i = 0; i < 15; ++i) {
      const double x = step_node(i);
      const auto y = evaluate_piece(y0, piece.data(), piece.size(), x);
      defect.row(static_cast<Eigen::Index>(i)) =
          equation_.body_error(y.value, y.slope - h * equation_.rate(omega[i], y.value));
    }
    const NodeQuadrature& quadrature = node_quadrature();
    StepError error;
    error.integrals = quadrature.weights * defect;
    // A defect of rounding is a few roundings of h omega, its residual sqrt(5) times that. And no
    // jump is larger than the range of the samples.
    const double residual = (quadrature.residual * defect).norm();
    Vector least = omega[0];
    Vector most = omega[0];
    for (const Vector& sample : omega) {
      least = least.cwiseMin(sample);
      most = most.cwiseMax(sample);
    }
    error.doubt = std::min(quadrature.jump_by_residual * std::max(0.0, residual - 8 * rounding),
                           quadrature.jump_by_size * std::abs(h) * norm(most - least));
    error.lost_in_rounding = error.at_end().norm() + residual < 16 * rounding;
    return error;
  }

  Sampler omega_;
  Equation equation_;
  CompensatedSum<Value> sum_;
  DenseOutput<Value> dense_;
  ErrorBudget budget_;
  double between_nodes_;  // what the error may exceed that at the nodes by
  double longest_stretch_;
  RoundingError rounding_;
  double t0_;
  double t1_;
  double max_step_;
  double h_ = 0;
  double reach_ = 0;
  double steepest_ = 0;  // |omega'|, by the chords of long steps without a jump
  double longest_ = 0;   // step accepted
  double turn_ = 0;      // the most that the last step tried can have turned about any axis
  bool after_rejection_ = false;
  bool exhausted_ = false;
  Vector error_ = Vector::Zero();
  double greatest_ = 0;
  double doubt_ = 0;
  double stretch_ = 0;
};

}  // namespace rotor
