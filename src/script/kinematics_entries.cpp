// How axis, angle and Euler vector move: N15 and its inverse, Jacobians; splines.
#include "rotation/kinematics.hpp"

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "rotation/spline.hpp"
#include "script/binding.hpp"
#include "script/interrupt.hpp"
#include "script/options.hpp"
#include "script/show.hpp"

namespace rotor::script {
namespace {

constexpr const char* kAngularVelocity =
    "angular_velocity{axis=, axis_rate=, angle=, angle_rate=} -> vec";
Vector of_rates(const Options& options) {
  const auto axis = options.get<Vector>("axis");
  const auto angle = options.get<double>("angle");
  if (!axis || !angle) {
    throw std::invalid_argument(std::string("expected axis and angle; usage: ") + kAngularVelocity);
  }
  return angular_velocity({*axis, *angle}, options.get<double>("angle_rate").value_or(0),
                          options.get<Vector>("axis_rate").value_or(Vector::Zero()));
}
Results angular_velocity_entry(lua_State* L) {
  Convert<Vector>::push(L, of_rates(Options(L, 1, kAngularVelocity)));
  return {1};
}

double angle_rate(const RotationRates& r) { return r.angle_rate; }
Vector axis(const RotationRates& r) { return r.axis; }
Vector axis_rate_of(const RotationRates& r) { return r.axis_rate; }
bool jump(const RotationRates& r) { return r.jump; }
std::string text_of_rates(const RotationRates& r) {
  return "rates  angle_rate " + shown(r.angle_rate) + "  axis_rate " + shown(r.axis_rate) +
         "\n       " + (r.jump ? "the axis jumps to " : "axis ") + shown(r.axis);
}

constexpr const char* kSpline = "rotation.spline(times, rotations, {rates=}) -> spline";
Results spline_entry(lua_State* L) {
  const auto times = argument<std::vector<double>>(L, 1);
  const auto rotations = argument<std::vector<Rotation>>(L, 2);
  std::optional<Spline::EndRates> ends;
  if (const auto rates = Options(L, 3, kSpline).get<std::vector<Vector>>("rates")) {
    if (rates->size() != 2) {
      throw std::invalid_argument("rates: expected two angular velocities, {first, last}, got " +
                                  std::to_string(rates->size()));
    }
    ends = {rates->front(), rates->back()};
  }
  Convert<Spline>::push(L, Spline(times, rotations, ends, stop_if_interrupted));
  return {1};
}
Rotation at(const Spline& s, double t) { return s(t); }
Vector omega(const Spline& s, double t) { return s.omega(t); }
Vector acceleration(const Spline& s, double t) { return s.acceleration(t); }
std::vector<double> times(const Spline& s) { return s.times(); }
std::string text_of_spline(const Spline& s) {
  return "spline  " + std::to_string(s.times().size()) + " rotations  t " +
         shown(s.times().front()) + " .. " + shown(s.times().back());
}

Vector shadow_mrp(const Rotation& r) { return r.shadow_mrp(); }

#define ROTOR_RATES "rotation_rates(rotation({0, 0, 1}, pi), {0, 0, 2})"
#define ROTOR_SPLINE                          \
  "rotation.spline({0, 2, 3}, {rotation({0, " \
  "0, 1}, 0), rotation({0, 0, 1}, 2), rotation({0, 0, 1}, 3)})"

constexpr Entry kFunctions[] = {
    {"angular_velocity", bound<angular_velocity_entry>, kAngularVelocity,
     "The angular velocity (space frame) at which axis u and angle theta move at the given rates "
     "[N15]: theta' u + (1 - cos theta) u x u' + sin theta u'. The axis may have any length but 0; "
     "axis_rate is that of the unit vector, perpendicular to it (to 1e-6). Rates not given are 0.",
     "angular_velocity{axis = {0, 0, 2}, angle = 1, angle_rate = 3} --> vec(0.0, 0.0, 3.0)"},
    {"rotation_rates", bound<rotation_rates>, "rotation_rates(R, omega) -> rates",
     "How axis and angle of R move at the angular velocity omega (space frame) [P5], the inverse "
     "of "
     "angular_velocity. Where the angle is 2 pi n (to 2^-51 of it, up to 4e9), R is the identity "
     "whatever its axis: it keeps "
     "its axis if omega is along it; else the axis jumps, and the choice made is to omega/|omega|, "
     "with the angle growing at |omega| and axis_rate 0, as a constant omega has it.",
     ROTOR_RATES ".angle_rate --> 2.0"},
};

constexpr Entry kStatics[] = {
    {"left_jacobian", bound<left_jacobian>, "rotation.left_jacobian(v) -> matrix",
     "Jacobian J_l of the exponential map at the Euler vector v: omega = J_l(E) E', omega in the "
     "space frame.",
     "rotation.left_jacobian({0, 0, 0})[1] --> {1.0, 0.0, 0.0}"},
    {"right_jacobian", bound<right_jacobian>, "rotation.right_jacobian(v) -> matrix",
     "J_r(v) = J_l(-v): the angular velocity in the body frame is J_r(E) E'.",
     "rotation.right_jacobian({0, 0, 0})[1] --> {1.0, 0.0, 0.0}"},
    {"left_jacobian_inverse", bound<left_jacobian_inverse>,
     "rotation.left_jacobian_inverse(v) -> matrix",
     "E' = J_l(E)^-1 omega [P7], omega in the space frame. An error where the length of v is 2 pi "
     "k, k >= 1: J_l is singular there.",
     "rotation.left_jacobian_inverse({0, 0, 0})[1] --> {1.0, 0.0, 0.0}"},
    {"right_jacobian_inverse", bound<right_jacobian_inverse>,
     "rotation.right_jacobian_inverse(v) -> matrix",
     "E' = J_r(E)^-1 omega, omega in the body frame; singular as rotation.left_jacobian_inverse.",
     "rotation.right_jacobian_inverse({0, 0, 0})[1] --> {1.0, 0.0, 0.0}"},
    {"spline", bound<spline_entry>, kSpline,
     "A smooth motion through rotations at times that rise: angular velocity and angular "
     "acceleration are continuous; neighbours are joined the short way (half a turn apart is an "
     "error). rates = {first, last} are the angular velocities at the ends (space frame); without "
     "them the angular acceleration is zero there. Two rotations are joined at constant rate.",
     ROTOR_SPLINE " --> spline  3 rotations  t 0.0 .. 3.0"},
};

constexpr Entry kRotationFields[] = {
    {"shadow_mrp", bound<shadow_mrp>, "R.shadow_mrp -> vec",
     "Modified Rodrigues parameters of the same operator the other way round: n tan((theta - 2 "
     "pi)/4) = -n cot(theta/4), small where R.mrp is large; infinite at 0. rotation.from_mrp takes "
     "either.",
     "rotation({0, 0, 1}, pi).shadow_mrp.z --> -1.0"},
};

constexpr Entry kRatesFields[] = {
    {"angle_rate", bound<angle_rate>, "rates.angle_rate -> number", "omega . n [P5].",
     ROTOR_RATES ".angle_rate --> 2.0"},
    {"axis", bound<axis>, "rates.axis -> vec",
     "The axis that moves so: that of the rotation, or the one to which it jumps.",
     ROTOR_RATES ".axis --> vec(0.0, 0.0, 1.0)"},
    {"axis_rate", bound<axis_rate_of>, "rates.axis_rate -> vec",
     "dn/dt = (omega - n (omega . n)) cot(theta/2)/2 + omega x n/2 [P5].",
     ROTOR_RATES ".axis_rate --> vec(0.0, 0.0, 0.0)"},
    {"jump", bound<jump>, "rates.jump -> boolean",
     "Whether the axis jumps: at an angle of 2 pi n, unless omega is along the axis.",
     "rotation_rates(rotation.identity, {0, 0, 2}).jump --> true"},
};
constexpr Entry kRatesOperators[] = {
    {"__tostring", bound<text_of_rates>, "tostring(rates) -> string",
     "The text under which the terminal shows it.", "#tostring(" ROTOR_RATES ") > 0 --> true"},
};

constexpr Entry kSplineFields[] = {
    {"times", bound<times>, "spline.times -> table", "The times of its rotations.",
     ROTOR_SPLINE ".times --> {0.0, 2.0, 3.0}"},
};
constexpr Entry kSplineMethods[] = {
    {"omega", bound<omega>, "spline:omega(t) -> vec",
     "The angular velocity at t, in the space frame; evolve{omega = spline, from = spline(t0), t = "
     "{t0, t1}} is the same motion.",
     ROTOR_SPLINE ":omega(0.5) --> vec(0.0, 0.0, 1.0)"},
    {"acceleration", bound<acceleration>, "spline:acceleration(t) -> vec",
     "The angular acceleration at t, the derivative of omega, in the space frame.",
     ROTOR_SPLINE ":acceleration(0) --> vec(0.0, 0.0, 0.0)"},
};
constexpr Entry kSplineOperators[] = {
    {"__call", bound<at>, "spline(t) -> rotation",
     "The rotation at t; t outside the times is an error. Its quaternion is continuous in t, its "
     "angle in [0, 2 pi].",
     ROTOR_SPLINE "(0.5).angle --> 0.5"},
    {"__tostring", bound<text_of_spline>, "tostring(spline) -> string",
     "The text under which the terminal shows it.", "#tostring(" ROTOR_SPLINE ") > 0 --> true"},
};

constexpr Group kGroups[] = {
    {"", Kind::kFunction, kFunctions},           {"rotation", Kind::kFunction, kStatics},
    {"rotation", Kind::kField, kRotationFields}, {"rates", Kind::kField, kRatesFields},
    {"rates", Kind::kOperator, kRatesOperators}, {"spline", Kind::kField, kSplineFields},
    {"spline", Kind::kMethod, kSplineMethods},   {"spline", Kind::kOperator, kSplineOperators},
};

}  // namespace

std::span<const Group> kinematics_groups() { return kGroups; }

}  // namespace rotor::script
