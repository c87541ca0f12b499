// omega of a fixed direction: one scalar integral.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "integrate/control.hpp"
#include "integrate/exact.hpp"
#include "integrate/legendre_rule.hpp"
#include "integrate/sampler.hpp"
#include "rotation/text.hpp"

namespace rotor {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

// The rate on a panel, in x from -1 at `begin` to 1 at `end`.
struct Panel {
  double begin;
  double end;
  Extended angle;  // at begin
  LegendreRule::Values rate;

  Extended half() const { return (Extended{end} - begin) / 2; }
  Extended place(double t) const {
    return begin == end ? Extended{-1} : (Extended{t} - begin) / half() - 1;
  }
  // A bound on the integral of |the rate|: half the length, 2, and the root of the mean square.
  double turning() const {
    Extended squares = 0;
    for (int k = 0; k < LegendreRule::kNodes; ++k) squares += rate[k] * rate[k] / (2 * k + 1);
    return static_cast<double>(2 * std::abs(half()) * std::sqrt(squares));
  }
  Extended angle_at(double t) const { return angle + half() * legendre_integral(rate, place(t)); }
};

class AlongFlow final : public FixedAxisFlow {
 public:
  /// Panels that follow one another, none for an empty interval.
  AlongFlow(const Vector& direction, double t0, std::vector<Panel> panels)
      : FixedAxisFlow(direction), t0_(t0), panels_(std::move(panels)) {}

  Extended angle(double t) const override { return panels_.empty() ? 0 : panel_at(t).angle_at(t); }
  double rate(double t) const override {
    if (panels_.empty()) return 0;
    const Panel& panel = panel_at(t);
    return static_cast<double>(legendre_sum(panel.rate, panel.place(t)));
  }

  std::vector<double> mesh() const override {
    std::vector<double> mesh{t0_};
    for (const Panel& panel : panels_) {
      const std::vector<double> part = even_mesh(panel.begin, panel.end, panel.turning());
      mesh.insert(mesh.end(), part.begin() + 1, part.end());
    }
    return mesh;
  }

 private:
  const Panel& panel_at(double t) const {
    const bool forward = panels_.back().end > t0_;
    const auto after = std::upper_bound(panels_.begin() + 1, panels_.end(), t,
                                        [forward](double time, const Panel& panel) {
                                          return forward ? time < panel.begin : time > panel.begin;
                                        });
    return *std::prev(after);
  }

  double t0_;
  std::vector<Panel> panels_;
};

// Integrates the rate panel by panel, as a method of integrate().
class AlongMethod {
 public:
  AlongMethod(const Scene& scene, const AlongSpin& omega, const std::vector<double>& breaks,
              Cost& cost)
      : rate_(omega.rate()),
        sign_(scene.omega.frame() == Frame::kSpace ? 1 : -1),
        breaks_(scene.omega, cost, breaks),
        cost_(cost),
        budget_(scene.accuracy, std::abs(scene.t1 - scene.t0)),
        t0_(scene.t0),
        t1_(scene.t1),
        max_step_(std::min(scene.max_step.value_or(std::abs(scene.t1 - scene.t0) / 16),
                           std::abs(scene.t1 - scene.t0))),
        h_(max_step_) {}

  double next(double t) const { return step_towards(breaks_.clip(t, t1_), t, h_); }

  bool must_end(double t) const { return breaks_.is_break(t); }

  bool step(double t, double t_next) {
    Panel panel{t, t_next, angle_, {}};
    const double h = std::abs(t_next - t);
    const double rounding = sample(panel);
    const double error = error_of(panel);
    const double allowed = allowed_error(panel, rounding);
    const double factor = growth(panel, allowed);
    const bool accepted = error <= allowed;
    h_ = std::min(h * (accepted ? factor : std::min(factor, 0.5)), max_step_);
    // The shortest step is tried before the run is given up.
    if (h > 2 * shortest_step(t)) h_ = std::max(h_, 1.5 * shortest_step(t));
    if (!accepted) return false;

    angle_ = panel.angle_at(t_next);
    if (!std::isfinite(static_cast<double>(angle_))) {
      throw StepOverflow("the angle overflows between t = " + text(t) + " and " + text(t_next));
    }
    budget_.spend(error);
    if (error > rounding) error_ += error;
    rounding_.add(rounding, 1.0 / LegendreRule::kNodes);
    extended_rounding_ += kExtendedEpsilon * static_cast<double>(std::abs(angle_));
    panels_.push_back(panel);
    return true;
  }

  std::vector<Panel> panels() && { return std::move(panels_); }
  double error_estimate() const { return error_ + rounding_.estimate() + extended_rounding_; }

 private:
  double value(double t) {
    ++cost_.omega_calls;
    const double s = rate_.value(t);
    if (!std::isfinite(s)) {
      throw NonFiniteOmega(rate_.name + " gave " + text(s) + " at t = " + text(t) +
                           ", expected a finite number");
    }
    return sign_ * s;
  }

  // Fills in the rate of the panel; returns the half-width of the rounding of its integral, were
  // the errors of all samples the same.
  double sample(Panel& panel) {
    const LegendreRule& rule = legendre_rule();
    const Extended half = panel.half();
    LegendreRule::Values rates;
    LegendreRule::Values late;  // where a node lies after the time that it is rounded to
    for (int i = 0; i < LegendreRule::kNodes; ++i) {
      const Extended node = panel.begin + half * (1 + rule.nodes[i]);
      const auto t = static_cast<double>(node);
      rates[i] = value(t);
      late[i] = (node - t) / half;
    }
    const LegendreRule::Values slopes = rule.slopes * rates;
    // First order, as long as the nodes are well apart.
    if (late.cwiseAbs().maxCoeff() < 1e-4L) rates += late.cwiseProduct(slopes);
    panel.rate = rule.coefficients * rates;
    const double t = std::max(std::abs(panel.begin), std::abs(panel.end));
    return static_cast<double>(kEpsilon * (std::abs(half) * rates.cwiseAbs().maxCoeff() +
                                           t * slopes.cwiseAbs().maxCoeff()));
  }

  // What is left out shows in the last terms of the series, and at a place between the nodes; a
  // jump before the first node or after the last, at the ends.
  double error_of(const Panel& panel) {
    const auto defect = [&](double t) {
      return std::abs(legendre_sum(panel.rate, panel.place(t)) - value(t));
    };
    const Extended tail = panel.rate.tail<4>().cwiseAbs().sum();
    const Extended stray = defect(static_cast<double>(panel.begin + kStrayPlace * panel.half()));
    const Extended ends = defect(std::nextafter(panel.begin, panel.end)) +
                          defect(std::nextafter(panel.end, panel.begin));
    const Extended gap = 1 + legendre_rule().nodes[0];
    return static_cast<double>(std::abs(panel.half()) * ((tail + stray) / 4 + gap * ends));
  }

  double allowed_error(const Panel& panel, double rounding) const {
    const double h = std::abs(panel.end - panel.begin);
    if (h <= 2 * shortest_step(panel.begin)) {
      // A jump of omega falls within some shortest step, and t resolves it no better: a small turn
      // is then an error to be stated, a larger one may take all that is left.
      return panel.turning() < 1e-8 ? std::numeric_limits<double>::infinity() : budget_.left();
    }
    return std::max(budget_.allowed(h, std::abs(panel.end - t0_)), 4 * rounding);
  }

  // The length of the next panel: as many terms as reach what is allowed should be some thirty.
  double growth(const Panel& panel, double allowed) const {
    int needed = LegendreRule::kNodes;
    while (needed > 0 && std::abs(panel.half() * panel.rate[needed - 1]) <= allowed / 4) --needed;
    return std::clamp(30.0 / (needed + 2), 0.1, 4.0);
  }

  static constexpr double kStrayPlace = 1.73;  // of a half
  static constexpr auto kExtendedEpsilon =
      static_cast<double>(std::numeric_limits<Extended>::epsilon());

  const ScalarFunction& rate_;
  double sign_;
  Sampler breaks_;
  Cost& cost_;
  ErrorBudget budget_;
  double t0_;
  double t1_;
  double max_step_;
  double h_;
  Extended angle_ = 0;
  std::vector<Panel> panels_;
  RoundingError rounding_;
  double error_ = 0;
  double extended_rounding_ = 0;
};

}  // namespace

void follow_along(const Scene& scene, const AlongSpin& omega, const std::vector<double>& breaks,
                  const Observer& observer, Propagator& result) {
  AlongMethod method(scene, omega, breaks, result.cost);
  result.stop = integrate(method, scene.t0, scene.t1, scene.max_steps, observer, result.cost);
  result.t1 = result.stop ? result.stop->t : scene.t1;
  result.accuracy = scene.accuracy;
  result.error_estimate = method.error_estimate();
  result.flow =
      std::make_shared<const AlongFlow>(omega.direction(), scene.t0, std::move(method).panels());
}

}  // namespace rotor
