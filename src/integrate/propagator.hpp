// From a scene to a motion: the plan, and the propagator that it makes.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "integrate/dense.hpp"
#include "integrate/loop.hpp"
#include "rotation/rotation.hpp"
#include "spin/angular_velocity.hpp"

namespace rotor {

enum class Method { kAuto, kExact, kRk4, kDop853 };

/// What is asked: omega, the interval (t1 < t0 runs backward) and how well.
struct Scene {
  AngularVelocity omega;
  double t0 = 0;
  double t1 = 0;
  /// Wanted bound on the rotation error over the whole run, rad.
  double accuracy = 1e-10;
  Method method = Method::kAuto;
  /// The step of a fixed-step method; it is shortened so that a whole number of at least two fits.
  std::optional<double> step = std::nullopt;
  /// The longest step; a 32nd of the interval unless it is given. What omega does between its
  /// samples, some fifteen a step, is not seen.
  std::optional<double> max_step = std::nullopt;
  std::size_t max_steps = 1'000'000;
};

/// The turn of a body about one fixed direction: U(t) = exp(direction * rate (t - t0)).
struct FixedTurn {
  Vector direction;  // unit; e1 where rate is 0
  Extended rate;     // rad per unit of t
  double t0;
  Extended angle(double t) const { return rate * (Extended{t} - Extended{t0}); }
};

/// U(t) with U(t0) = 1: the motion of any start is U(t) q0 [theory: Q' = omega Q / 2 is linear].
/// Knows no start.
struct Propagator {
  double t0 = 0;
  double t1 = 0;              // the time reached
  std::string method;         // "exact", "rk4", "dop853"
  std::string why;            // why this method
  double accuracy = 0;        // what was asked; 0 for a fixed step
  double error_estimate = 0;  // of the rotation, rad, anywhere in the run
  Cost cost;
  std::optional<Stop> stop;  // why it ended before the end asked for, if it did
  std::variant<FixedTurn, DenseOutput<Eigen::Vector4d>> motion;

  /// The unit quaternion U(t), continuous in t. t must lie in [t0, t1].
  Quaternion operator()(double t) const;
  /// The fixed direction, where the motion has one, else null.
  const FixedTurn* fixed_turn() const { return std::get_if<FixedTurn>(&motion); }
  /// The times at which steps ended, t0 first; just t0 and t1 for an exact motion.
  std::vector<double> mesh() const;
};

/// Runs the scene by the cheapest faithful method (or the one named) and says which and why.
/// Errors of the request are std::invalid_argument; a run that could not go on has `stop` set and
/// holds what was done.
Propagator propagate(const Scene& scene, const Observer& observer = {});

}  // namespace rotor
