#include "integrate/runge_kutta.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "integrate/chart_flow.hpp"
#include "integrate/charts.hpp"
#include "integrate/dop853.hpp"
#include "integrate/equation.hpp"
#include "integrate/generalized.hpp"
#include "integrate/rk4.hpp"
#include "rotation/text.hpp"

namespace rotor {
namespace {

void require(bool holds, const std::string& message) {
  if (!holds) throw std::invalid_argument(message);
}

// Calls follow(equation) with that of the scene.
template <class Follow>
void with_equation(const Scene& scene, const Follow& follow) {
  switch (scene.equation) {
    case Equation::kQuaternion:
    case Equation::kModifiedGibbs:  // with the cosine that it needs, they are the same
      return follow(QuaternionEquation());
    case Equation::kEuler:
      return follow(EulerEquation(scene.restart, scene.ignore_singularity));
    case Equation::kGibbs:
      return follow(GibbsEquation());
    case Equation::kAxisAngle:
      return follow(AxisAngleEquation());
    case Equation::kBodyPoints:
      return follow(BodyPointsEquation());
    case Equation::kGeneralized:
      return follow(GeneralizedEquation(scene.f, scene.restart));
  }
}

// The motion that the generator drives: that of the body, or its inverse.
Rotation start_of(const Scene& scene, const Rotation& from) {
  return scene.omega.frame() == Frame::kSpace ? from : from.inverse();
}

template <class Equation, class Integrator>
void run(const Equation& equation, const typename Equation::Value& start, Integrator integrator,
         const Scene& scene, const Observer& observer, Propagator& result) {
  result.stop = integrate(integrator, scene.t0, scene.t1, scene.max_steps, observer, result.cost);
  if (result.stop && integrator.at_singularity() &&
      (result.stop->reason == "step underflow" || result.stop->reason == "step limit")) {
    result.stop->reason = "singularity";
    result.stop->message = "singularity: " + equation.singularity(integrator.value());
  }
  result.t1 = result.stop ? result.stop->t : scene.t1;
  result.error_estimate = integrator.error_estimate();
  result.flow = std::make_shared<const ChartFlow<Equation>>(equation, start, integrator.dense());
}

// The ends of the parts between breaks, in the order of travel.
std::vector<double> ends_of(const Scene& scene, std::vector<double> breaks) {
  std::erase_if(breaks, [&](double t) { return t == scene.t0 || t == scene.t1; });
  if (scene.t1 < scene.t0) std::reverse(breaks.begin(), breaks.end());
  breaks.push_back(scene.t1);
  return breaks;
}

}  // namespace

void follow_by_rk4(const Scene& scene, const std::vector<double>& breaks, const Rotation& from,
                   const Observer& observer, Propagator& result) {
  const std::vector<double> ends = ends_of(scene, breaks);
  const double step = scene.step.value();
  double count = 0;
  double begin = scene.t0;
  for (const double end : ends) {
    count += rk4_steps(std::abs(end - begin), step);
    begin = end;
  }
  require(count <= static_cast<double>(scene.max_steps),
          "step = " + text(step) +
              " makes more than max_steps = " + std::to_string(scene.max_steps) + " steps");
  with_equation(scene, [&](const auto& equation) {
    const auto start = equation.start(start_of(scene, from));
    run(equation, start,
        Rk4(Sampler(scene.omega, result.cost, breaks), equation, start, scene.t0, ends, step),
        scene, observer, result);
  });
}

void follow_by_dop853(const Scene& scene, const std::vector<double>& breaks, const Rotation& from,
                      const Observer& observer, Propagator& result) {
  result.accuracy = scene.accuracy;
  const double longest =
      std::max(std::abs(scene.t1 - scene.t0) / 32, std::numeric_limits<double>::denorm_min());
  with_equation(scene, [&](const auto& equation) {
    const auto start = equation.start(start_of(scene, from));
    run(equation, start,
        Dop853(Sampler(scene.omega, result.cost, breaks), equation, start, scene.t0, scene.t1,
               scene.accuracy, scene.max_step.value_or(longest)),
        scene, observer, result);
  });
}

}  // namespace rotor
