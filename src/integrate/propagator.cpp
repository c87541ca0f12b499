#include "integrate/propagator.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "integrate/exact.hpp"
#include "integrate/fgl.hpp"
#include "integrate/runge_kutta.hpp"
#include "rotation/text.hpp"
#include "spin/models.hpp"

namespace rotor {
namespace {

struct Plan {
  Method method;
  std::string why;
};

void require(bool holds, const std::string& message) {
  if (!holds) throw std::invalid_argument(message);
}

void check(const Scene& scene) {
  require(std::isfinite(scene.t0) && std::isfinite(scene.t1),
          "t must be finite, got " + text(scene.t0) + " .. " + text(scene.t1));
  require(std::isfinite(scene.t1 - scene.t0),
          "t is too long: " + text(scene.t1) + " less " + text(scene.t0) + " is no double");
  require(scene.accuracy > 0 && std::isfinite(scene.accuracy),
          "accuracy must be positive, got " + text(scene.accuracy));
  require(!scene.max_step || *scene.max_step > 0,
          "max_step must be positive, got " + text(scene.max_step.value_or(0)));
  require(scene.max_steps > 0, "max_steps must be positive, got 0");
  require(!scene.step || (*scene.step > 0 && std::isfinite(*scene.step)),
          "step must be positive, got " + text(scene.step.value_or(0)));
  for (const double t : scene.breaks) {
    require(std::isfinite(t), "breaks must be finite, got " + text(t));
  }
  const bool generalized = scene.equation == Equation::kGeneralized;
  require(!generalized || scene.f, R"(equation = "generalized" needs f)");
  require(generalized || !scene.f, R"(f is for equation = "generalized")");
  require(!scene.restart || generalized || scene.equation == Equation::kEuler,
          R"(restart is for equation = "euler" or "generalized")");
  require(!scene.ignore_singularity || scene.equation == Equation::kEuler,
          R"(singularity = "ignore" is for equation = "euler")");
}

// Whether there is a cheaper model than integrating, and what it is called; "" if not.
std::string exact_model(const AngularVelocity& omega) {
  if (omega.as<ConstantSpin>() != nullptr) return "constant omega, Theorem 4.1";
  if (omega.as<TurningSpin>() != nullptr) return "omega constant in a uniformly turning frame";
  if (omega.as<AlongSpin>() != nullptr) return "omega of fixed direction: one integral, Lemma 4.2";
  if (omega.as<PeriodicSpin>() != nullptr) return "periodic omega: one period, then Floquet";
  if (omega.as<PiecewiseSpin>() != nullptr) return "omega in pieces, each by its cheapest method";
  return "";
}

Plan plan(const Scene& scene) {
  const bool linear = scene.equation == Equation::kQuaternion;
  const std::string model = linear ? exact_model(scene.omega) : "";
  switch (scene.method) {
    case Method::kAuto:
      require(!scene.step, "step is for method = \"rk4\"; the other methods take accuracy");
      if (!linear) return {Method::kDop853, "the adaptive method for this equation"};
      if (!model.empty()) return {Method::kExact, model};
      return {Method::kFgl, scene.omega.dear() ? "omega is dear to call: two levels"
                                               : "omega is cheap to call: one level"};
    case Method::kExact:
      require(linear, "method \"exact\" follows the quaternion only");
      require(!model.empty(),
              "method \"exact\" needs an omega whose model is known: constant, turning, along, "
              "periodic or piecewise, not " +
                  scene.omega.description());
      return {Method::kExact, model};
    case Method::kFgl:
      require(linear, "method \"fgl\" follows the quaternion only");
      require(!scene.step, "method \"fgl\" takes accuracy, not step");
      return {Method::kFgl, "asked for"};
    case Method::kRk4:
      require(scene.step.has_value(), "method \"rk4\" needs step");
      return {Method::kRk4, "asked for"};
    case Method::kDop853:
      require(!scene.step, "method \"dop853\" takes accuracy, not step");
      return {Method::kDop853, "asked for"};
  }
  return {};
}

// Those of omega and those of the scene within the interval, its ends among them, rising, each
// once.
std::vector<double> breaks_of(const Scene& scene) {
  const auto [low, high] = std::minmax({scene.t0, scene.t1});
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<double> breaks =
      scene.omega.breaks(std::nextafter(low, -kInfinity), std::nextafter(high, kInfinity));
  for (const double t : scene.breaks) {
    if (low <= t && t <= high) breaks.push_back(t);
  }
  std::sort(breaks.begin(), breaks.end());
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
  return breaks;
}

void follow_constant(const Scene& scene, const Vector& omega, Propagator& result) {
  const double sign = scene.omega.frame() == Frame::kSpace ? 1 : -1;
  const auto turn = std::make_shared<const UniformTurn>(sign * omega, scene.t0, scene.t1);
  const auto angle = static_cast<double>(std::abs(turn->angle(scene.t1)));
  // The angle is good to 4 roundings of its extended value, direction and quaternion to double's.
  result.error_estimate =
      4 * static_cast<double>(std::numeric_limits<Extended>::epsilon()) * angle +
      4 * std::numeric_limits<double>::epsilon();
  result.t1 = scene.t1;
  result.flow = turn;
}

void follow_exactly(const Scene& scene, const Observer& observer, Propagator& result) {
  if (const auto* constant = scene.omega.as<ConstantSpin>()) {
    follow_constant(scene, constant->value(scene.t0), result);
  } else if (const auto* turning = scene.omega.as<TurningSpin>()) {
    follow_turning(scene, *turning, result);
  } else if (const auto* along = scene.omega.as<AlongSpin>()) {
    follow_along(scene, *along, breaks_of(scene), observer, result);
  } else if (const auto* periodic = scene.omega.as<PeriodicSpin>()) {
    follow_periodic(scene, *periodic, scene.breaks, observer, result);
  } else {
    follow_piecewise(scene, *scene.omega.as<PiecewiseSpin>(), scene.breaks, observer, result);
  }
}

}  // namespace

Quaternion Propagator::operator()(double t, const Quaternion& q0) const {
  if (t == t0) return q0;  // to the bit
  const Quaternion u = flow->at(t);
  return frame == Frame::kSpace ? u * q0 : q0 * u.conjugate();
}

Propagator propagate(const Scene& scene, const Observer& observer, const Rotation& from) {
  check(scene);
  const Plan chosen = plan(scene);
  // An exact model may need its longest step for a part of the way only.
  require(
      chosen.method == Method::kExact || !scene.max_step ||
          std::abs(scene.t1 - scene.t0) / *scene.max_step <= static_cast<double>(scene.max_steps),
      "max_step = " + text(scene.max_step.value_or(0)) +
          " makes more than max_steps = " + std::to_string(scene.max_steps) + " steps");
  const auto begin = std::chrono::steady_clock::now();
  Propagator result;
  result.t0 = scene.t0;
  result.frame = scene.omega.frame();
  result.why = chosen.why;
  switch (chosen.method) {
    case Method::kRk4:
      result.method = "rk4";
      follow_by_rk4(scene, breaks_of(scene), from, observer, result);
      break;
    case Method::kDop853:
      result.method = "dop853";
      follow_by_dop853(scene, breaks_of(scene), from, observer, result);
      break;
    case Method::kFgl:
      result.method = "fgl";
      follow_by_fgl(scene, breaks_of(scene), observer, result);
      break;
    default:
      result.method = "exact";
      follow_exactly(scene, observer, result);
  }
  result.cost.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

}  // namespace rotor
