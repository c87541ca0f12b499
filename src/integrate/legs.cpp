#include "integrate/legs.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "rotation/turn.hpp"

namespace rotor {
namespace {

// The end of a leg with all the digits it has: an angle may have more than a quaternion of doubles.
ExtendedQuaternion end_of(const Flow& flow, double t) {
  if (const auto* fixed = dynamic_cast<const FixedAxisFlow*>(&flow)) {
    return turn(fixed->direction().cast<Extended>().normalized(), fixed->angle(t));
  }
  return flow.at(t).cast<Extended>().normalized();
}

Scene scene_of(const Leg& leg, const Scene& whole, double accuracy, const Cost& done) {
  Scene scene{leg.omega};
  scene.t0 = leg.begin;
  scene.t1 = leg.end;
  scene.accuracy = std::max(accuracy, kFinestAccuracy);
  scene.max_step = whole.max_step;
  scene.max_steps = whole.max_steps - std::min(done.steps + done.rejected, whole.max_steps - 1);
  scene.breaks = leg.breaks;
  return scene;
}

void add_name(std::string& names, const std::string& name) {
  if ((", " + names + ", ").find(", " + name + ", ") != std::string::npos) return;
  names += (names.empty() ? "" : ", ") + name;
}

}  // namespace

FollowedLegs follow_legs(const Scene& scene, const std::vector<Leg>& legs, double accuracy,
                         const Observer& observer) {
  FollowedLegs result;
  result.legs.reserve(legs.size());
  result.at_end = ExtendedQuaternion::Identity();
  double length = 0;
  for (const Leg& leg : legs) length += std::abs(leg.end - leg.begin);
  for (const Leg& leg : legs) {
    const auto time_of_run = [&leg](double t) { return leg.start + (t - leg.begin); };
    Observer leg_observer;
    if (observer) leg_observer = [&](double t) { return observer(time_of_run(t)); };
    const bool go_on = !leg_observer || leg_observer(leg.begin);
    const double share = length == 0 ? 1 : std::abs(leg.end - leg.begin) / length;
    Scene part_scene = scene_of(leg, scene, accuracy * share, result.cost);
    if (!go_on) part_scene.t1 = part_scene.t0;
    Propagator part = propagate(part_scene, leg_observer);

    result.legs.push_back({leg.begin, part.t1, part.flow, result.at_end});
    result.at_end = (end_of(*part.flow, part.t1) * result.at_end).normalized();
    result.error_estimate += part.error_estimate;
    result.cost.omega_calls += part.cost.omega_calls;
    result.cost.steps += part.cost.steps;
    result.cost.rejected += part.cost.rejected;
    result.exact = result.exact && part.accuracy == 0;
    add_name(result.method, part.method);
    result.stop = std::move(part.stop);
    if (!go_on) result.stop = Stop{"interrupted", part.t1, "interrupted", nullptr};
    if (result.stop) {
      result.stop->t = time_of_run(result.stop->t);
      if (result.stop->reason == "step limit") {
        result.stop->message =
            "step limit: max_steps = " + std::to_string(scene.max_steps) + " are used up";
      }
      break;
    }
  }
  return result;
}

}  // namespace rotor
