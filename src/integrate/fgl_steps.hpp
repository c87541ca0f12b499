// The fast integrator on one level.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "integrate/fgl_method.hpp"
#include "integrate/fgl_samples.hpp"

namespace rotor {

/// Every step samples omega: 16 calls, one more at its end, and eight in 32 steps; up to four times
/// 16 more where rounding is to be averaged.
class FglSteps : public FglMethod {
 public:
  FglSteps(const Scene& scene, Sampler omega, std::shared_ptr<FglFlow> flow)
      : FglMethod(scene, std::move(omega), std::move(flow), 16),
        accuracy_(scene.accuracy),
        budget_(0.9 * scene.accuracy, std::abs(t1_ - t0_)) {}

  double next(double t) {
    if (h_ == 0) {
      const double rate = norm(omega_.at_node(t0_, t1_));
      h_ = std::max({std::min(longest_, 4 / rate), 4 * shortest_step(t0_),
                     std::numeric_limits<double>::denorm_min()});
    }
    return end_of_step(t, h_);
  }

  bool step(double t, double t_next) {
    if (const auto accepted = attempt(t, t_next, [&] { return take(t, t_next); })) return *accepted;
    h_ = std::abs(t_next - t) / 4;
    after_rejection_ = true;
    return false;
  }

 private:
  bool take(double t, double t_next) {
    const Stretch stretch(t, t_next);
    const Vector begin = stretch.half() * omega_.at_node(t, t_next);
    const StepSamples samples = sample_step(omega_, stretch);
    const Vector end = stretch.half() * omega_.at_node(t_next, t);
    const double greatest = longest(samples.w);
    const double late = lateness(t, t_next, longest(samples.slopes.slopes));
    const double turn = 2 * greatest;
    // The standard deviation of the samples where they and their argument, as a rule some multiple
    // of t, are rounded to double, by 1/2 ulp at most.
    const double model = (kUnit * greatest + late) / std::numbers::sqrt3;
    const double noise = noise_share(t, t_next) * model;
    const double may = allowed(budget_, t, t_next, turn);
    // What was too large for the noise that is measured may still be as large as the model's.
    FglStep step = fgl_kernel().step(samples.w, may / 64, after_rejection_ ? model : noise);
    step.error = std::max(step.error, error_at_ends(samples, begin, end, step, model));

    const double h = std::abs(t_next - t);
    const double error = judged(step, may);
    h_ = std::min({h * factor(error, 0.3, after_rejection_ ? 1 : 4), longest_,
                   h * (kLongestHalf / greatest)});
    after_rejection_ = !(error <= 1);
    // As PanelLengths: what a break made shorter does not stop the run.
    const double shortest = shortest_step(t);
    if (!after_rejection_ || h > 2 * shortest) h_ = std::max(h_, 1.5 * shortest);
    if (after_rejection_) return false;
    const std::size_t n = parts(h, turn, 0.55 * noise);
    // Off by up to half an ulp to either side of where they are meant, samples on a curve are off
    // to one side of it, by a third of half the square, after the correction of first order.
    const double aside = turn > 0 ? late * late / (3 * greatest) : 0;
    // 0.55^2: the square sum of the weights; twice, as eight samples tell the noise no better.
    add_errors(with_rounding(step.error + aside, turn, n),
               1.1 * noise / std::sqrt(static_cast<double>(n)), turn, n);
    if (n == 1) {
      append(t_next, step, turn);
    } else {
      take_parts(t, t_next, n, may / 64, noise, turn);
    }

    budget_.spend(step.error);
    between_ = std::max(between_, step.between);
    return true;
  }

  // How many times as many samples as a step of length h needs are worth taking. The rounding of
  // its samples makes an error of the standard deviation `noise` a component, rad; where that, at
  // random, would exceed the accuracy by the end of the run, more of them average it: up to four
  // times as many, and not where what rounds in one direction is more than that.
  std::size_t parts(double h, double turn, double noise) const {
    const double steps = std::abs(t1_ - t0_) / h;
    const double expected = noise * std::sqrt(3 * steps);
    const double enough = std::max(accuracy_, kUnit / 2 * turn * steps);
    return expected <= enough
               ? 1
               : static_cast<std::size_t>(std::ceil(std::min(4.0, std::pow(expected / enough, 2))));
  }

  void append(double end, const FglStep& step, double turn) {
    flow_->append(end, after(step.turn, flow_->last()), turn);
  }

  // The same step on n times as many samples. All of them before any is appended: omega may fail.
  void take_parts(double t, double t_next, std::size_t n, double negligible, double noise,
                  double turn) {
    std::vector<double> times = {t};
    std::vector<FglStep> steps;
    times.reserve(n + 1);
    steps.reserve(n);
    for (std::size_t i = 1; i <= n; ++i) {
      const double part = static_cast<double>(i) / static_cast<double>(n);
      times.push_back(i == n ? t_next : t + (t_next - t) * part);
      const Stretch stretch(times[i - 1], times[i]);
      steps.push_back(fgl_kernel().step(sample_step(omega_, stretch).w, negligible, noise));
    }
    for (std::size_t i = 0; i < n; ++i) {
      append(times[i + 1], steps[i], turn / static_cast<double>(n));
    }
  }

  // What w itself is at the ends of the step shows what its terms hide of a jump or a bend near by:
  // where they fall fast, nothing, unless it lies between an end and the next node, 0.0106 from it
  // (of 2): the integral then misses up to 0.0106 |w off|, 1/54 of its greatest component.
  static double error_at_ends(const StepSamples& samples, const Vector& begin, const Vector& end,
                              const FglStep& step, double model) {
    double off = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto i = static_cast<Eigen::Index>(c);
      off = std::max({off, std::abs(samples.slopes.ends[c][0] - end(i)),
                      std::abs(samples.slopes.ends[c][1] - begin(i))});
    }
    if (off <= 64 * model) return 0;
    return std::max(off * step.fall / 8, off > 64 * step.left_out ? off / 54 : 0);
  }

  // By how much w changes within half an ulp of the time, where its slope by z is `steepest`.
  static double lateness(double t, double t_next, double steepest) {
    if (steepest == 0) return 0;
    const double latest = std::max(std::abs(t), std::abs(t_next));
    return kUnit * latest / std::abs(0.5 * t_next - 0.5 * t) * steepest;
  }

  // The noise that there is, in units of the model's: not all arguments are rounded. Measured every
  // 32 tries on eight samples so near one another that a polynomial of degree 4 through any five of
  // them would give the next; so irregularly placed that their rounding is irregular too.
  double noise_share(double t, double t_next) {
    if (tries_++ % 32 != 0) return noise_share_;
    constexpr std::array<double, 8> kPlaces = {211, 1021, 1999, 3301, 4513, 5639, 7103, 8219};
    const double far = std::abs(t) > std::abs(t_next) ? t : t_next;
    const double near = far == t ? t_next : t;
    const double unit = std::copysign(far - std::nextafter(far, 0.0), near - far);
    if (!(std::abs(near - far) > 64 * kPlaces.back() * std::abs(unit))) return noise_share_;
    std::array<Vector, 8> g;
    double size = std::numeric_limits<double>::min();
    for (std::size_t i = 0; i < 8; ++i) {
      g[i] = omega_(far + kPlaces[i] * unit);
      size = std::max(size, norm(g[i]));
    }
    for (Vector& sample : g) sample /= size;
    double variance = 0;
    for (std::size_t first = 0; first < 3; ++first) {
      Vector difference = Vector::Zero();  // divided, of order 5
      double squares = 0;
      for (std::size_t i = first; i < first + 6; ++i) {
        double weight = 1;
        for (std::size_t k = first; k < first + 6; ++k) {
          if (k != i) weight *= 1000 / (kPlaces[i] - kPlaces[k]);
        }
        difference += weight * g[i];
        squares += weight * weight;
      }
      variance += difference.squaredNorm() / squares / 3;
    }
    const double slope = norm(g[7] - g[0]) / (kPlaces[7] - kPlaces[0]);
    const double model = kUnit / std::numbers::sqrt3 * (norm(g[0]) + std::abs(far / unit) * slope);
    const double share = model > 0 ? 2 * std::sqrt(variance) / model : 0;
    noise_share_ = std::clamp(share, tries_ == 1 ? 0 : noise_share_ / 4, 1.0);
    return noise_share_;
  }

  static constexpr double kLongestHalf = 7;  // rad; the kernel takes some 7.4

  double accuracy_;
  ErrorBudget budget_;
  double h_ = 0;
  bool after_rejection_ = false;
  std::size_t tries_ = 0;
  double noise_share_ = 1;
};

}  // namespace rotor
