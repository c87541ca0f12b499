#include "integrate/propagator.hpp"

#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "integrate/dop853.hpp"
#include "integrate/equation.hpp"
#include "integrate/rk4.hpp"
#include "rotation/text.hpp"

namespace rotor {
namespace {

const Eigen::Vector4d kIdentity(0, 0, 0, 1);

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
  require(scene.accuracy > 0 && std::isfinite(scene.accuracy),
          "accuracy must be positive, got " + text(scene.accuracy));
  require(!scene.max_step || *scene.max_step > 0,
          "max_step must be positive, got " + text(scene.max_step.value_or(0)));
  require(scene.max_steps > 0, "max_steps must be positive, got 0");
  require(!scene.step || (*scene.step > 0 && std::isfinite(*scene.step)),
          "step must be positive, got " + text(scene.step.value_or(0)));
}

Plan plan(const Scene& scene) {
  const bool constant = scene.omega.constant() != nullptr;
  switch (scene.method) {
    case Method::kAuto:
      require(!scene.step, "step is for method = \"rk4\"; the other methods take accuracy");
      return constant ? Plan{Method::kExact, "constant omega, Theorem 4.1"}
                      : Plan{Method::kDop853, "omega is a function of t"};
    case Method::kExact:
      require(constant, "method \"exact\" needs a constant omega");
      return {Method::kExact, "constant omega, Theorem 4.1"};
    case Method::kRk4:
      require(scene.step.has_value(), "method \"rk4\" needs step");
      return {Method::kRk4, "asked for"};
    case Method::kDop853:
      require(!scene.step, "method \"dop853\" takes accuracy, not step");
      return {Method::kDop853, "asked for"};
  }
  return {};
}

FixedTurn fixed_turn(const Vector& omega, double t0) {
  const auto rate = omega.cast<Extended>().norm();
  return {rate == 0 ? Vector::UnitX() : unit(omega), rate, t0};
}

void exact(const Scene& scene, Propagator& result) {
  const FixedTurn turn = fixed_turn(*scene.omega.constant(), scene.t0);
  const auto angle = static_cast<double>(std::abs(turn.angle(scene.t1)));
  require(std::isfinite(angle), "omega (t1 - t0) is too large to be an angle");
  // The angle is good to 4 roundings of its extended value, direction and quaternion to double's.
  result.error_estimate =
      4 * static_cast<double>(std::numeric_limits<Extended>::epsilon()) * angle +
      4 * std::numeric_limits<double>::epsilon();
  result.t1 = scene.t1;
  result.motion = turn;
}

template <class Integrator>
void run(Integrator integrator, const Scene& scene, const Observer& observer, Propagator& result) {
  result.stop = integrate(integrator, scene.t0, scene.t1, scene.max_steps, observer, result.cost);
  result.t1 = result.stop ? result.stop->t : scene.t1;
  result.error_estimate = integrator.error_estimate();
  result.motion = integrator.dense();
}

void rk4(const Scene& scene, const Observer& observer, Propagator& result) {
  const double count =
      std::max(2.0, std::ceil(std::abs(scene.t1 - scene.t0) / *scene.step * (1 - 1e-12)));
  require(count <= static_cast<double>(scene.max_steps),
          "step = " + text(*scene.step) +
              " makes more than max_steps = " + std::to_string(scene.max_steps) + " steps");
  run(Rk4<QuaternionEquation>(Sampler(scene.omega, result.cost), kIdentity, scene.t0, scene.t1,
                              static_cast<std::size_t>(count)),
      scene, observer, result);
}

void dop853(const Scene& scene, const Observer& observer, Propagator& result) {
  result.accuracy = scene.accuracy;
  const double longest =
      std::max(std::abs(scene.t1 - scene.t0) / 32, std::numeric_limits<double>::denorm_min());
  run(Dop853<QuaternionEquation>(Sampler(scene.omega, result.cost), kIdentity, scene.t0, scene.t1,
                                 scene.accuracy, scene.max_step.value_or(longest)),
      scene, observer, result);
}

}  // namespace

Quaternion Propagator::operator()(double t) const {
  if (const FixedTurn* turn = fixed_turn()) {
    const Extended half = turn->angle(t) / 2;
    Quaternion q;
    q.w() = static_cast<double>(std::cos(half));
    q.vec() = turn->direction * static_cast<double>(std::sin(half));
    return q;
  }
  const auto& dense = std::get<DenseOutput<Eigen::Vector4d>>(motion);
  return Quaternion(dense.pieces() == 0 ? kIdentity : dense.at(t).normalized());
}

std::vector<double> Propagator::mesh() const {
  if (fixed_turn()) return {t0, t1};
  return std::get<DenseOutput<Eigen::Vector4d>>(motion).mesh();
}

Propagator propagate(const Scene& scene, const Observer& observer) {
  check(scene);
  const Plan chosen = plan(scene);
  const auto begin = std::chrono::steady_clock::now();
  Propagator result;
  result.t0 = scene.t0;
  result.why = chosen.why;
  switch (chosen.method) {
    case Method::kRk4:
      result.method = "rk4";
      rk4(scene, observer, result);
      break;
    case Method::kDop853:
      result.method = "dop853";
      dop853(scene, observer, result);
      break;
    default:
      result.method = "exact";
      exact(scene, result);
  }
  result.cost.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

}  // namespace rotor
