// From a scene to a motion: the plan, and the propagator that it makes.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "integrate/flow.hpp"
#include "integrate/loop.hpp"
#include "rotation/rotation.hpp"
#include "spin/angular_velocity.hpp"

namespace rotor {

enum class Method { kAuto, kExact, kFgl, kRk4, kDop853 };

/// What is integrated: the linear equation of the quaternion, of which the others are charts.
enum class Equation {
  kQuaternion,     // [P9]
  kEuler,          // [P7]
  kModifiedGibbs,  // [P8], with M0
  kGibbs,          // [P10]
  kAxisAngle,      // [P5]
  kBodyPoints,     // [P1]
  kGeneralized     // [P4]
};

class GeneralizedAngle;

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
  /// The longest step; a part of the interval unless it is given, a 32nd for "dop853", a 16th
  /// for "fgl", a tenth where omega is dear to call. What omega does between its samples, some
  /// fifteen to 64 a step, is not seen.
  std::optional<double> max_step = std::nullopt;
  std::size_t max_steps = 1'000'000;
  /// Times at which omega or a derivative of it jumps, in any order: steps end there. Those that
  /// omega itself tells need not be repeated.
  std::vector<double> breaks = {};

  Equation equation = Equation::kQuaternion;
  /// f of the generalized Euler vector n f(theta).
  std::shared_ptr<const GeneralizedAngle> f = nullptr;
  /// Go on from E (1 - 2 pi/|E|), the same operator, where |E| reaches 3 pi/2 (Equation::kEuler).
  bool restart = false;
  /// Go straight on where |E| comes to 2 pi k and [P7] is singular, which is wrong, and by how much
  /// is luck: to show that it is (Equation::kEuler).
  bool ignore_singularity = false;
};

/// The motion of a scene, and what it took.
struct Propagator {
  double t0 = 0;
  double t1 = 0;  // the time reached
  Frame frame = Frame::kSpace;
  std::string method;         // "exact", "fgl", "rk4", "dop853"
  std::string why;            // why this method
  double accuracy = 0;        // what was asked; 0 for a fixed step
  double error_estimate = 0;  // of the rotation, rad, anywhere in the run
  Cost cost;
  std::optional<Stop> stop;  // why it ended before the end asked for, if it did
  std::shared_ptr<const Flow> flow;

  /// The unit quaternion of the motion from q0, continuous in t. t must lie in [t0, t1].
  Quaternion operator()(double t, const Quaternion& q0 = Quaternion::Identity()) const;
  /// As the turn about a fixed direction that it is, else null.
  const FixedAxisFlow* fixed_axis() const { return dynamic_cast<const FixedAxisFlow*>(flow.get()); }
};

/// Runs the scene by the cheapest faithful method (or the one named) and says which and why.
/// Errors of the request are std::invalid_argument; a run that could not go on has `stop` set and
/// holds what was done. `from` is asked for by the equations that are not linear only.
Propagator propagate(const Scene& scene, const Observer& observer = {},
                     const Rotation& from = Rotation());

}  // namespace rotor
