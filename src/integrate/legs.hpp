// A way in several legs, each followed by the cheapest method that it has.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "integrate/propagator.hpp"
#include "rotation/extended.hpp"

namespace rotor {

/// From `begin` to `end` in the time of `omega`; `start` is what the run calls the time `begin`.
struct Leg {
  AngularVelocity omega;
  double begin;
  double end;
  double start;
  std::vector<double> breaks;
};

/// A leg as far as it was followed, up to `end`: U(t) = flow(t) before.
struct FollowedLeg {
  double begin;
  double end;
  std::shared_ptr<const Flow> flow;
  ExtendedQuaternion before;
};

struct FollowedLegs {
  std::vector<FollowedLeg> legs;  // one at least
  ExtendedQuaternion at_end;      // U at the end of the last
  double error_estimate = 0;      // the sum of theirs: a bound, for they do not grow
  std::string method;             // "exact", or the names of their methods: "exact, fgl"
  bool exact = true;              // no accuracy was used
  Cost cost;
  std::optional<Stop> stop;  // in the time of the run
};

/// Follows the legs with `accuracy` for all together, shared by length; scene gives max_step and
/// max_steps. Ends with a leg that stops early.
FollowedLegs follow_legs(const Scene& scene, const std::vector<Leg>& legs, double accuracy,
                         const Observer& observer);

/// The least accuracy that is worth asking of a leg, rad: the rounding of a quaternion.
constexpr double kFinestAccuracy = 4 * std::numeric_limits<double>::epsilon();

}  // namespace rotor
