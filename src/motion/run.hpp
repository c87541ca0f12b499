// The run and its states: the motion of one start, with axis and angle that go on continuously.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "integrate/propagator.hpp"
#include "rotation/rotation.hpp"
#include "spin/angular_velocity.hpp"

namespace rotor {

/// Where the body is at t: axis and angle continuous in t, and the quaternion that goes with them.
struct State {
  double t = 0;
  double angle = 0;       // any real: turns are counted
  Vector axis;            // unit
  Quaternion quaternion;  // (cos angle/2, axis sin angle/2), continuous

  /// The angle of a rotation is rounded to a double: after many turns that, not the run, is what
  /// limits it as an operator. The faces below come from the quaternion.
  Rotation rotation() const { return {axis, angle}; }
  /// E = axis * angle.
  Vector euler_vector() const { return axis * angle; }
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

/// A passage of the axis and angle through theta = 2 pi k, where M = n sin(theta/2) is zero.
struct Crossing {
  double t;
  bool through;        // into the neighbouring interval; else theta turned back
  double turn_before;  // the integer l with 2 pi l <= theta <= 2 pi (l + 1)
  double turn_after;
  Vector axis;  // the limit of n there
};

/// A motion: propagator and start.
class Run {
 public:
  /// Looks for the crossings; throws Interrupted where the observer says no meanwhile.
  Run(AngularVelocity omega, Propagator propagator, const Rotation& from,
      const Observer& observer = {});

  double t0() const { return propagator_.t0; }
  double t1() const { return propagator_.t1; }
  const Rotation& from() const { return from_; }
  const Propagator& propagator() const { return propagator_; }
  const AngularVelocity& driver() const { return omega_; }
  bool complete() const { return !propagator_.stop; }
  /// In the order of the motion. About a fixed axis they are made on demand; throws
  /// std::length_error where there are more than a million.
  std::vector<Crossing> crossings() const;

  /// The state at t; throws std::out_of_range outside [t0, t1].
  State operator()(double t) const;
  /// How the state moves, given omega at its t. Where M is exactly zero the axis rate depends on
  /// the derivatives of omega: NaN, except about a fixed axis.
  Rates rates(const State& state, const Vector& omega) const;
  /// omega(t): a call of the script's function where it is one.
  Vector omega(double t) const { return omega_(t); }

 private:
  Quaternion quaternion(double t) const { return propagator_(t) * start_; }
  double forward() const { return t1() >= t0() ? 1 : -1; }
  // The angle about the fixed axis of the start, for a motion that has one; in extended precision.
  Extended fixed_axis_angle(double t) const;
  void find_crossings(const Observer& observer);
  bool is_zero_of_m(const double (&t)[3], const double (&m)[3]) const;
  Vector axis_at(double t, const Quaternion& q, double turn) const;
  Vector limit_of_axis(double t, const Vector& before, const Vector& after,
                       double turn_after) const;
  Vector direction_of_omega(double t) const;

  AngularVelocity omega_;
  Propagator propagator_;
  Rotation from_;
  Quaternion start_;
  // theta = 4 pi double_turns_ + psi, where psi in (-2 pi, 2 pi) at the start and its interval
  // 2 pi l <= psi <= 2 pi (l + 1) has l = first_turn_, changed by crossings_ (whose turns are those
  // of psi).
  Extended double_turns_ = 0;
  double first_turn_ = 0;
  double fixed_axis_ =
      0;         // +1 or -1: a turn about plus or minus the axis of the start; 0: no such thing
  Vector axis_;  // the axis of the start; about a fixed axis, of the whole motion
  std::vector<Crossing> crossings_;
};

/// Calls `visit` with the states at the times; stops by throwing Interrupted where the observer
/// says so.
void visit_states(const Run& run, std::span<const double> times, const Observer& observer,
                  const std::function<void(const State&)>& visit);

/// Runs the scene from `from` to its end, or to where it stopped (propagator().stop).
Run evolve(const Scene& scene, const Rotation& from, const Observer& observer = {});

}  // namespace rotor
