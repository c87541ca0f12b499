// The stroboscopic map: a motion at times a period apart.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "motion/run.hpp"

namespace rotor {

/// t0, t0 + T, ... in the order of the motion. Throws std::invalid_argument unless T is positive
/// and no longer than the run, and where there would be more than 1e8.
std::vector<double> strobe_times(const Run& run, double period);

/// If omega has the period T, and V is what the motion does in one, q_k = V^k q0 (in the body frame
/// q0 V^k): the points lie on a great circle of the unit quaternions, and go on along it by half
/// the angle of V each time [theory 4.3].
struct StrobeCircle {
  Vector axis;             // of V, with axis . omega(t0) >= 0; NaN where V = 1 or -1
  double rotation_number;  // half the angle of V about that axis, in turns: in [0, 1)
  double error;            // of the rotation number
  double off;              // the greatest |q_k - V^k q0|, as found
  bool closes;             // whether that is within the error of the run: whether omega repeats
};

/// Measured on the points at `times`, a period apart, two at least.
StrobeCircle strobe_circle(const Run& run, std::span<const double> times,
                           const Observer& observer = {});

/// After how many periods a motion is where it was, from any start.
struct ClosedOrbit {
  std::size_t attitude;
  std::size_t quaternion;  // as many, or twice; E too, but for multiples of 4 pi of its length
};

/// What is known of that: the motion closes where the rotation number is a fraction.
struct Closing {
  bool omega_known;  // to repeat with the period by what it is, not by the points
  std::size_t most;  // up to so many periods of the quaternion it was looked for; 0: too inexact
  std::optional<ClosedOrbit> orbit;  // none: no fraction with a denominator up to `most`
};

/// Of points at `times`, `period` apart. None where omega does not repeat with the period (circle
/// .closes), or where two points alone would have to tell. That a rotation number is a fraction by
/// chance, within its error and the rounding of the period and of omega's own numbers, has a
/// probability of 1e-6 at most.
std::optional<Closing> closing(const Run& run, std::span<const double> times, double period,
                               const StrobeCircle& circle);

/// After how many periods, up to `most` >= 1, the attitude comes nearest to where it was, and how
/// far it is from there.
struct NearReturn {
  std::size_t periods;
  double angle;  // rad
};
NearReturn nearest_return(const StrobeCircle& circle, std::size_t most);

/// The plane through the origin that is nearest to the points of M = n sin(theta/2) (least
/// squares).
struct Plane {
  Vector normal;  // unit, its last component that is not 0 positive
  double off;     // the greatest distance of a point
};
Plane plane_of_m(const Run& run, std::span<const double> times, const Observer& observer = {});

}  // namespace rotor
