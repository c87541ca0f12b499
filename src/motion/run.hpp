// The run and its states: the motion of one start, with axis and angle that go on continuously.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "integrate/propagator.hpp"
#include "motion/crossings.hpp"
#include "motion/turns.hpp"
#include "rotation/rotation.hpp"
#include "spin/angular_velocity.hpp"

namespace rotor {

/// Where the body is at t: axis and angle continuous in t, and the quaternion that goes with them.
struct State {
  double t = 0;
  double angle = std::numeric_limits<double>::quiet_NaN();                   // turns are counted
  Vector axis = Vector::Constant(std::numeric_limits<double>::quiet_NaN());  // unit
  Quaternion quaternion;  // (cos angle/2, axis sin angle/2), continuous

  /// The angle of a rotation is rounded to a double: after many turns that, not the run, is what
  /// limits it as an operator. The faces below come from the quaternion.
  /// Where the axis has no limit the angle is a multiple of 2 pi, and any axis will do.
  Rotation rotation() const { return {axis.hasNaN() ? Vector(Vector::UnitX()) : axis, angle}; }
  /// E = axis * angle; 0 where the angle is, though the axis may have no limit there.
  Vector euler_vector() const { return angle == 0 ? Vector(Vector::Zero()) : axis * angle; }
  Matrix matrix() const { return quaternion.toRotationMatrix(); }
  /// M = n sin(theta/2).
  Vector modified_gibbs() const { return quaternion.vec(); }
  /// G = n tan(theta/2) = M/M0.
  Vector gibbs() const { return quaternion.vec() / quaternion.w(); }
  /// n tan(theta/4) = M/(1 + M0) = M (1 - M0)/|M|^2, whichever does not cancel.
  Vector mrp() const;
};

/// How axis, angle and Euler vector move.
struct Rates {
  double angle_rate;  // [P5] omega . n
  Vector axis_rate;   // [P5] (omega - n (omega . n)) cot(theta/2)/2 + omega x n/2
  Vector euler_rate;  // [P7]
};

/// A motion: propagator and start.
///
/// Axis and angle need the crossings before them: these are looked for when axis or angle are asked
/// for, as far as the time asked. The quaternion needs none of it.
class Run {
 public:
  /// `points` are bodies' points, by their places at the start. `crossing_tolerance`: how near to
  /// 2 pi k, in rad, theta comes where it is a crossing; twice the error estimate unless it is
  /// given. Throws std::invalid_argument unless it is positive and below 1.
  Run(AngularVelocity omega, Propagator propagator, const Rotation& from,
      std::vector<Vector> points = {}, std::optional<double> crossing_tolerance = std::nullopt);

  double t0() const { return propagator_.t0; }
  double t1() const { return propagator_.t1; }
  const Rotation& from() const { return from_; }
  const Propagator& propagator() const { return propagator_; }
  const AngularVelocity& driver() const { return omega_; }
  bool complete() const { return !propagator_.stop; }
  /// In the order of the motion. About a fixed axis at a constant rate they are made on demand;
  /// throws std::length_error where there are more than a million.
  std::vector<Crossing> crossings(const Observer& observer = {}) const;
  double crossing_tolerance() const { return crossings_.tolerance(); }
  /// What is to be said of the crossings and of the axis at the start.
  std::vector<std::string> notes(const Observer& observer = {}) const;

  /// A state whose axis and angle are not looked for, but NaN; throws std::out_of_range outside
  /// [t0, t1].
  State attitude(double t) const;
  /// The state at t; throws std::out_of_range outside [t0, t1], std::length_error where the motion
  /// is too long to be searched for crossings, Interrupted where the observer says no meanwhile.
  State operator()(double t, const Observer& observer = {}) const;
  /// How the state moves, given omega at its t, in the space frame. Where M is zero the axis rate
  /// is that of Lemma 5.3; NaN where the axis has no limit.
  Rates rates(const State& state, const Vector& omega) const;
  /// omega at t in the space frame: a call of the script's function where it is one.
  Vector omega(double t) const;
  /// The same in the body frame.
  Vector body_omega(double t) const;
  /// Where the points are at t [P1].
  std::vector<Vector> points(double t) const;
  /// The same motion from another start: nothing is integrated.
  Run with_start(const Rotation& from) const {
    return {omega_, propagator_, from, points_, crossings_.given_tolerance()};
  }

 private:
  Quaternion quaternion(double t) const;
  double forward() const { return t1() >= t0() ? 1 : -1; }
  // Of the propagator's fixed axis: U* turns the other way.
  double sense() const { return propagator_.frame == Frame::kSpace ? 1 : -1; }
  // The angle about the fixed axis of the start, for a motion that has one; in extended precision.
  Extended fixed_axis_angle(double t) const;
  std::vector<Crossing> uniform_crossings(const UniformTurn& flow) const;
  const Zero* better_known(double t, const Vector& axis, double axis_error, double error,
                           double AxisSeries::Error::*of) const;
  Vector axis_at(double t, const Quaternion& q, double turn) const;
  Vector axis_rate_at(const State& state, const Vector& omega) const;

  AngularVelocity omega_;
  Propagator propagator_;
  Rotation from_;
  std::vector<Vector> points_;
  StartTurn turn_;  // the turns of crossings_ are those of its psi
  Quaternion start_;
  // +1 or -1: a turn about plus or minus the axis of the start; 0: no such thing.
  double fixed_axis_ = 0;
  Vector axis_;  // the axis of the start; about a fixed axis, of the whole motion
  mutable Crossings crossings_;
};

/// Calls `visit` with each of the times; stops by throwing Interrupted where the observer says so.
void visit_times(std::span<const double> times, const Observer& observer,
                 const std::function<void(double)>& visit);

/// Runs the scene from `from` to its end, or to where it stopped (propagator().stop).
Run evolve(const Scene& scene, const Rotation& from, const Observer& observer = {},
           std::vector<Vector> points = {},
           std::optional<double> crossing_tolerance = std::nullopt);

}  // namespace rotor
