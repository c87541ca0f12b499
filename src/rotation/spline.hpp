// Interpolation of rotations with continuous angular velocity and acceleration.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "rotation/extended.hpp"
#include "rotation/rotation.hpp"

namespace rotor {

/// A C2 spline through rotations at rising times: R(t) = R_i exp(phi_i(t)) between t_i and t_i+1,
/// where phi_i, a rotation vector in the body frame, is a cubic from 0 to the short way from R_i to
/// R_i+1. The angular velocities at the times are those that make the angular acceleration
/// continuous. Two rotations without end rates are joined by their geodesic, at constant rate.
class Spline {
 public:
  /// Angular velocities at the first and the last time, in the space frame.
  struct EndRates {
    Vector first;
    Vector last;
  };

  /// Without end rates the spline is natural: the angular acceleration is zero at both ends. The
  /// rotations count as operators: turns between them are not seen. Throws std::invalid_argument
  /// for fewer than two rotations, another number of times, times that do not rise or are not
  /// finite, neighbours half a turn apart (to an ulp), which no short way joins, and if the
  /// equations for the angular velocities have no solution that Newton's method finds; `look` is
  /// called in each of its steps, and what it throws stops it.
  Spline(std::vector<double> times, const std::vector<Rotation>& rotations,
         const std::optional<EndRates>& rates = {}, const std::function<void()>& look = {});

  const std::vector<double>& times() const { return times_; }

  /// The rotation at t; its quaternion is continuous in t and starts as that of the first rotation,
  /// the angle is in [0, 2 pi]. This and the following throw std::out_of_range for t outside the
  /// times.
  Rotation operator()(double t) const;
  /// The angular velocity at t, in the space frame.
  Vector omega(double t) const;
  /// Its derivative, in the space frame.
  Vector acceleration(double t) const;

  /// R(t + s) = from exp(phi[0] + phi[1] s + phi[2] s^2 + phi[3] s^3) as far as the next time.
  struct Expansion {
    ExtendedQuaternion from;
    std::array<ExtendedVector, 4> phi;
  };
  Expansion expansion(double t) const;

 private:
  // phi(x) = a x + b x^2 + c x^3, x = (t - t_i)/duration in [0, 1].
  struct Segment {
    Extended duration;
    ExtendedQuaternion from;
    ExtendedVector turn;  // phi(1)
    ExtendedVector a = ExtendedVector::Zero();
    ExtendedVector b = ExtendedVector::Zero();
    ExtendedVector c = ExtendedVector::Zero();
  };
  void set_segments(const std::vector<Rotation>& rotations);
  std::vector<ExtendedVector> node_rates(const std::optional<EndRates>& rates,
                                         const std::function<void()>& look) const;
  std::vector<ExtendedVector> next_rates(const std::vector<ExtendedVector>& now,
                                         const std::optional<EndRates>& rates, Extended part) const;
  std::optional<std::vector<ExtendedVector>> converged_rates(
      std::vector<ExtendedVector> now, const std::optional<EndRates>& rates, Extended part,
      const std::function<void()>& look) const;

  std::vector<double> times_;
  std::vector<Segment> segments_;
};

}  // namespace rotor
