// The fast integrator on two levels.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "integrate/fgl_method.hpp"
#include "integrate/panel.hpp"

namespace rotor {

/// omega is sampled on panels, and steps are taken on what is known of it there.
class FglPanels : public FglMethod {
 public:
  FglPanels(const Scene& scene, Sampler omega, std::shared_ptr<FglFlow> flow)
      : FglMethod(scene, std::move(omega), std::move(flow), 10),
        panel_budget_(0.45 * scene.accuracy, std::abs(t1_ - t0_)),
        step_budget_(0.45 * scene.accuracy, std::abs(t1_ - t0_)),
        lengths_(longest_) {}

  double next(double t) {
    if (length_ == 0) {
      const double rate = norm(omega_.at_node(t0_, t1_));
      lengths_.limit(20 / rate);
      length_ = 6 / rate;
    }
    return end_of_step(t, lengths_.length());
  }

  bool step(double t, double t_next) {
    if (const auto accepted = attempt(t, t_next, [&] { return take(t, t_next); })) return *accepted;
    lengths_.limit(std::abs(t_next - t) / 4);
    return false;
  }

 private:
  bool take(double t, double t_next) {
    const Panel panel = Panel::of(
        [&](double s) {
          if (s == t) return omega_.at_node(t, t_next);
          if (s == t_next) return omega_.at_node(t_next, t);
          return omega_(s);
        },
        t, t_next);
    const double h = std::abs(t_next - t);
    const double turn = h * panel.greatest();
    if (!lengths_.accept(panel, allowed(panel_budget_, t, t_next, turn))) return false;
    const double error = h * panel.error();
    // Its size is known from a dozen numbers: to a fifth, and be it three times that.
    const double noise = 1.75 * h * panel.noise() * std::sqrt(kept_noise(panel, turn));
    if (is_turn(panel)) {
      const double unit = panel.is_constant() ? kExtendedUnit : kUnit;
      add_errors(error + turn * unit, noise, turn, 1);
      flow_->append_turn(panel, turn);
    } else if (take_steps(panel, turn)) {
      add_errors(with_rounding(error + spent_ + h * panel.aside(), turn, u_.size()), noise, turn,
                 u_.size());
      flow_->append(panel, u_, turn);
    } else {
      return false;
    }
    panel_budget_.spend(error);
    return true;
  }

  static constexpr double kMostSteps = 256;  // a panel
  static constexpr auto kExtendedUnit =
      static_cast<double>(std::numeric_limits<Extended>::epsilon());

  // The part of the noise (mean square) that does not turn away. Its source are the rounded
  // arguments, so it has the direction in which omega changes. Along omega it adds up; across, it
  // is seen from the turning body: terms of e^(i k z), k half the panel's turn, of degrees below
  // 64, of which there are no more than there are terms of the noise.
  static double kept_noise(const Panel& panel, double turn) {
    const double part = std::min(1.0, 2 * static_cast<double>(Panel::kNodes) / turn);
    return panel.along() + (1 - panel.along()) * (1 - std::sqrt(1 - part * part));
  }

  // Whether what the samples have across their mean is rounding.
  static bool is_turn(const Panel& panel) {
    Vector mean;
    for (std::size_t c = 0; c < 3; ++c)
      mean(static_cast<Eigen::Index>(c)) = panel.coefficients()[c][0];
    const double length = norm(mean);
    if (length == 0) return panel.greatest() == 0;
    mean /= length;
    double squares = 0;
    const double unit = 2 * kUnit * panel.greatest();
    for (std::size_t n = 0; n < Panel::kNodes; ++n) {
      Vector term;
      for (std::size_t c = 0; c < 3; ++c)
        term(static_cast<Eigen::Index>(c)) = panel.coefficients()[c][n];
      squares +=
          ((term - mean * mean.dot(term)) / unit).squaredNorm() / static_cast<double>(2 * n + 1);
    }
    return squares <= 1;
  }

  // Equal steps on the panel, into u_, and their errors into spent_.
  bool take_steps(const Panel& panel, double turn) {
    const double h = std::abs(panel.end() - panel.begin());
    double steps = std::max(1.0, std::ceil(h / length_));
    while (true) {
      if (steps > kMostSteps) {
        lengths_.limit(h * (kMostSteps / steps) * 0.9);
        return false;
      }
      const auto n = static_cast<std::size_t>(steps);
      const double may = allowed(step_budget_, panel.begin(), panel.end(), turn) / steps;
      const double worst = run_steps(panel, n, may);
      length_ = h / steps * factor(worst, 0.5, 16);
      if (worst <= 1) break;
      steps = std::max(steps + 1, std::ceil(h / length_));
    }
    lengths_.limit(kMostSteps / 2 * length_);
    step_budget_.spend(spent_);
    return true;
  }

  // n of them; the worst error, as it is judged.
  double run_steps(const Panel& panel, std::size_t n, double may) {
    const FglKernel& kernel = fgl_kernel();
    const double half = 1 / static_cast<double>(n);
    const Extended scale =
        (Extended{panel.end()} - Extended{panel.begin()}) / (2 * static_cast<Extended>(n));
    if (w_.size() != n) {
      w_.resize(n);
      legendre_.resize((n + 1) / 2);
      for (std::size_t i = 0; i < legendre_.size(); ++i) {
        kernel.legendre(static_cast<double>(2 * i + 1) * half - 1, half, legendre_[i]);
      }
    }
    for (std::size_t i = 0; i < legendre_.size(); ++i) {
      kernel.restrict_to(legendre_[i], panel.coefficients(), scale, w_[i], w_[n - 1 - i]);
    }
    const double noise = 8 * std::abs(static_cast<double>(scale)) * panel.noise();
    u_.resize(n);
    spent_ = 0;
    double worst = 0;
    Quaternion u = flow_->last();
    for (std::size_t i = 0; i < n; ++i) {
      const FglStep step = kernel.step(w_[i], may / 64, noise);
      worst = std::max(worst, judged(step, may));
      if (!(worst <= 1)) return worst;
      spent_ += step.error;
      between_ = std::max(between_, step.between);
      u = after(step.turn, u);
      u_[i] = u;
    }
    return worst;
  }

  ErrorBudget panel_budget_;
  ErrorBudget step_budget_;
  PanelLengths lengths_;
  double length_ = 0;  // of a step
  std::vector<NodeVectors> w_;
  std::vector<LegendreLanes> legendre_;  // for w_.size() steps
  std::vector<Quaternion> u_;
  double spent_ = 0;
};

}  // namespace rotor
