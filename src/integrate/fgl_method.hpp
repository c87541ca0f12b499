// What the two levels of the fast integrator share.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>

#include "integrate/control.hpp"
#include "integrate/fgl_flow.hpp"
#include "integrate/fgl_kernel.hpp"
#include "integrate/propagator.hpp"
#include "integrate/sampler.hpp"

namespace rotor {

/// The motion so far, and what its errors may be and are.
class FglMethod {
 public:
  /// Unless the scene says how long a step may be, there are `fewest` of them at least.
  FglMethod(const Scene& scene, Sampler omega, std::shared_ptr<FglFlow> flow, double fewest)
      : omega_(std::move(omega)),
        flow_(std::move(flow)),
        between_allowed_(0.1 * scene.accuracy),
        t0_(scene.t0),
        t1_(scene.t1),
        longest_(scene.max_step.value_or(
            std::max({std::abs(scene.t1 - scene.t0) / fewest * (1 + kUneven),
                      shortest_step(scene.t0), std::numeric_limits<double>::denorm_min()}))) {}

  double error_estimate() const { return error_ + between_ + rounding_.estimate(); }
  bool must_end(double t) const { return omega_.is_break(t); }

 protected:
  // The end of a step of about the length h from t. Steps of one length may repeat the rounding of
  // omega's argument, which then adds up where it should average out: no two are of one length.
  double end_of_step(double t, double h) {
    uneven_ += std::numbers::phi;
    uneven_ -= std::floor(uneven_);
    return step_towards(omega_.clip(t, t1_), t, h * (1 - kUneven * uneven_));
  }
  // A jump of omega falls within some shortest step, and t resolves it no better. Far below the
  // rounding of a step nothing is gained.
  double allowed(const ErrorBudget& budget, double t, double t_next, double turn) const {
    const double h = std::abs(t_next - t);
    if (h <= 2 * shortest_step(t)) {
      return turn < 1 ? std::numeric_limits<double>::infinity() : budget.left();
    }
    return std::max(budget.allowed(h, std::abs(t_next - t0_)), kUnit / 16 * turn);
  }
  // The error of a step in units of what it may be; what is negligible, which does not fall with
  // the length as the rest does, aside.
  double judged(const FglStep& step, double may) const {
    return std::max(
        {(step.error - step.rest) / may, step.between / std::max(between_allowed_, may), 0.0});
  }
  // The factor to the next step's length from that.
  static double factor(double judged, double least, double most) {
    if (judged == 0) return most;
    if (!std::isfinite(judged)) return least;
    return std::clamp(0.9 * std::pow(judged, -1.0 / 32), least, most);
  }
  // U after one more step.
  static Quaternion after(const std::array<double, 4>& turn, const Quaternion& u) {
    Quaternion next = Quaternion(turn[0], turn[1], turn[2], turn[3]) * u;
    next.coeffs() *= 1.5 - 0.5 * next.squaredNorm();
    return next;
  }
  // Of n steps that turn by `turn` together: no more than where they lead at all, and what their
  // exponentials, much the same every time where omega is constant, round in one direction: some
  // eight half ulps for the longest, of 14 rad, less in squares for shorter ones.
  static double with_rounding(double error, double turn, std::size_t n) {
    return std::min(error, 2 * turn) + kUnit / 24 * turn * turn / static_cast<double>(n);
  }
  // The errors of n steps, before they are appended: `error`; `noise`, of that standard deviation
  // in each component; and, at random, an ulp or so each for their factors and the product, of what
  // the body has turned so far.
  void add_errors(double error, double noise, double turn, std::size_t n) {
    RoundingError rounding = rounding_;
    rounding.add(4 * kUnit * std::min(1.0, turned_ + turn), 3 * static_cast<double>(n));
    rounding.add(noise, 3);
    const double sum = error_ + error;
    // A step that is noise is none, or a pole is in it.
    if (!(sum + rounding.estimate() < std::numbers::pi) || !(noise < 0.01)) {
      throw AccuracyLost(
          "accuracy lost: omega is too large or changes too fast for t, and for its own rounding, "
          "to tell where the body is");
    }
    error_ = sum;
    rounding_ = rounding;
    turned_ += turn;
  }

  // The step, or nothing where it has to be shorter: omega is not finite somewhere in it, and
  // shorter ones go on towards the place, never past it; the last one, very near, raises what omega
  // did.
  template <class Take>
  std::optional<bool> attempt(double t, double t_next, Take take) {
    const auto [low, high] = std::minmax(t, t_next);
    if (!failure_ || failed_at_ < low || failed_at_ > high) {
      try {
        return take();
      } catch (const NonFiniteOmega&) {
        failure_ = std::current_exception();
        failed_at_ = omega_.last();
      }
    }
    if (high - low <= 1e-8 * std::abs(t1_ - t0_)) std::rethrow_exception(failure_);
    return std::nullopt;
  }

  static constexpr double kUneven = 0.02;
  /// Half an ulp of 1.
  static constexpr double kUnit = std::numeric_limits<double>::epsilon() / 2;

  Sampler omega_;
  std::shared_ptr<FglFlow> flow_;
  double between_allowed_;
  double t0_;
  double t1_;
  double longest_;
  double error_ = 0;
  double between_ = 0;  // the greatest
  RoundingError rounding_;

 private:
  std::exception_ptr failure_;
  double failed_at_ = 0;
  double uneven_ = 0;
  double turned_ = 0;  // rad, along the way
};

}  // namespace rotor
