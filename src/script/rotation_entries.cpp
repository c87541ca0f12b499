// rotation: the value, its faces, composition, interpolation.
#include <optional>
#include <string>
#include <vector>

#include "rotation/rotation.hpp"
#include "script/binding.hpp"
#include "script/options.hpp"
#include "script/show.hpp"

namespace rotor::script {
namespace {

Rotation make_rotation(const Vector& axis, double angle) { return {axis, angle}; }
Rotation identity() { return {}; }

Results of_quaternion(lua_State* L) {
  if (lua_type(L, 1) != LUA_TNUMBER) {
    Convert<Rotation>::push(L, from_quaternion(argument<Quaternion>(L, 1)));
    return {1};
  }
  const auto w = argument<double>(L, 1);
  const auto x = argument<double>(L, 2);
  const auto y = argument<double>(L, 3);
  const Quaternion q(w, x, y, argument<double>(L, 4));
  Convert<Rotation>::push(L, from_quaternion(q));
  return {1};
}

// The faces.
Vector axis(const Rotation& r) { return r.axis(); }
double angle(const Rotation& r) { return r.angle(); }
Quaternion quaternion(const Rotation& r) { return r.quaternion(); }
Matrix matrix(const Rotation& r) { return r.matrix(); }
Vector euler_vector(const Rotation& r) { return r.euler_vector(); }
Vector modified_gibbs(const Rotation& r) { return r.modified_gibbs(); }
Vector gibbs(const Rotation& r) { return r.gibbs(); }
Vector mrp(const Rotation& r) { return r.mrp(); }

Results multiply(lua_State* L) {
  const Rotation& second = argument<Rotation>(L, 1);
  if (const Rotation* first = test_user_value<Rotation>(L, 2)) {
    Convert<Rotation>::push(L, second * *first);
  } else if (is_vector(L, 2)) {
    Convert<Vector>::push(L, second * argument<Vector>(L, 2));
  } else {
    throw std::invalid_argument("expected a rotation or a vector on the right, got " +
                                describe(L, 2) + "; R:rotate(points) takes a list of points");
  }
  return {1};
}
Rotation power(const Rotation& r, double x) { return r.power(x); }
std::string text_of(const Rotation& r) {
  return "rotation  " + shown_axis_angle(r.axis(), r.angle(), 10);
}
Rotation inverse(const Rotation& r) { return r.inverse(); }
Rotation canonical(const Rotation& r) { return r.canonical(); }
double distance_to(const Rotation& r, const Rotation& s) { return distance(r, s); }
bool same_operator(const Rotation& r, const Rotation& s, std::optional<double> tolerance) {
  return distance(r, s) <= tolerance.value_or(1e-12);
}
std::vector<Vector> rotate(const Rotation& r, const std::vector<Vector>& points) {
  std::vector<Vector> rotated;
  rotated.reserve(points.size());
  for (const Vector& p : points) rotated.push_back(r * p);
  return rotated;
}

constexpr const char* kSlerp = "slerp(R, S, s, {way=}) -> rotation";
Results slerp_at(lua_State* L) {
  const Rotation& r = argument<Rotation>(L, 1);
  const Rotation& s = argument<Rotation>(L, 2);
  const double fraction = argument<double>(L, 3);
  const Options options(L, 4, kSlerp);
  const Way way = options.word("way", {"short", "long"}) == 1 ? Way::kLong : Way::kShort;
  Convert<Rotation>::push(L, slerp(r, s, fraction, way));
  return {1};
}

constexpr Entry kFunctions[] = {
    {"rotation", bound<make_rotation>, "rotation(axis, angle) -> rotation",
     "The rotation about an axis of any length but zero by an angle in radians, counter-clockwise "
     "seen from the "
     "tip. The angle is kept as given: 7 rad stays 7 rad.",
     "rotation({0, 0, 2}, 90*deg).axis --> vec(0.0, 0.0, 1.0)"},
    {"slerp", bound<slerp_at>, kSlerp,
     "The geodesic from R (s = 0) to S (s = 1) at constant rate, the \"short\" way round (default) "
     "or the \"long\" "
     "one. Where both are as long (distance pi) N3's axis decides.",
     "slerp(rotation.identity, rotation({0, 0, 1}, 1), 0.5).angle --> 0.5"},
};

constexpr Entry kStatics[] = {
    {"from_quaternion", bound<of_quaternion>, "rotation.from_quaternion(w, x, y, z) -> rotation",
     "From a unit quaternion, scalar first: four numbers, a quaternion or {w, x, y, z}; unit to "
     "1e-6, then "
     "normalised. The angle is in [0, 2 pi]: q and -q are the same operator, a turn apart.",
     "rotation.from_quaternion(0, 0, 0, 1) --> rotation  angle 3.141592653589793 rad (180.0 deg)  "
     "axis (0.0, 0.0, 1.0)"},
    {"from_matrix", bound<from_matrix>, "rotation.from_matrix(m) -> rotation",
     "From a proper orthogonal matrix (to 1e-6, then made exact), m[i][j]. Canonical: the angle is "
     "in [0, pi].",
     "rotation.from_matrix({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}).angle --> 0.0"},
    {"from_euler_vector", bound<from_euler_vector>, "rotation.from_euler_vector(v) -> rotation",
     "From E = n theta (rotation vector): the angle is the length of v.",
     "rotation.from_euler_vector({0, 0, 2}).angle --> 2.0"},
    {"from_modified_gibbs", bound<from_modified_gibbs>,
     "rotation.from_modified_gibbs(m) -> rotation",
     "From M = n sin(theta/2), of length 1 at most. The angle is in [0, pi]: M does not carry the "
     "sign of "
     "cos(theta/2).",
     "rotation.from_modified_gibbs({0, 0, 1}).angle --> 3.141592653589793"},
    {"from_gibbs", bound<from_gibbs>, "rotation.from_gibbs(g) -> rotation",
     "From G = n tan(theta/2) (Rodrigues vector). The angle is in [0, pi].",
     "rotation.from_gibbs({0, 0, 1}).angle --> 1.5707963267948966"},
    {"from_mrp", bound<from_mrp>, "rotation.from_mrp(p) -> rotation",
     "From the modified Rodrigues parameters n tan(theta/4). The angle is in [0, 2 pi].",
     "rotation.from_mrp({0, 0, 1}).angle --> 3.141592653589793"},
    {"nearest", bound<nearest_rotation>, "rotation.nearest(m) -> rotation",
     "The rotation whose matrix is nearest to m (Frobenius norm); an error where there is none or "
     "more than one.",
     "rotation.nearest({{2, 0, 0}, {0, 1, 0}, {0, 0, 1}}).angle --> 0.0"},
};

constexpr Entry kValues[] = {
    {"identity", bound<identity>, "rotation.identity -> rotation",
     "Angle 0; the axis is e1, by N3's rule.",
     "rotation.identity --> rotation  angle 0.0 rad (0.0 deg)  axis (1.0, 0.0, 0.0)"},
};

constexpr Entry kFields[] = {
    {"axis", bound<axis>, "R.axis -> vec", "Unit axis n.",
     "rotation({0, 3, 4}, 1).axis --> vec(0.0, 0.6, 0.8)"},
    {"angle", bound<angle>, "R.angle -> number",
     "Angle theta in radians, as given: any real number.", "rotation({0, 0, 1}, 7).angle --> 7.0"},
    {"quaternion", bound<quaternion>, "R.quaternion -> quaternion",
     "Unit quaternion (cos theta/2, n sin theta/2); its sign tells theta from theta + 2 pi.",
     "rotation({0, 0, 1}, 0).quaternion --> quaternion(1.0, 0.0, 0.0, 0.0)"},
    {"matrix", bound<matrix>, "R.matrix -> matrix", "Matrix of the operator [N5], m[i][j].",
     "rotation({0, 0, 1}, 0).matrix[1][1] --> 1.0"},
    {"euler_vector", bound<euler_vector>, "R.euler_vector -> vec", "E = n theta (rotation vector).",
     "rotation({0, 0, 1}, 7).euler_vector --> vec(0.0, 0.0, 7.0)"},
    {"modified_gibbs", bound<modified_gibbs>, "R.modified_gibbs -> vec", "M = n sin(theta/2).",
     "rotation({0, 0, 1}, pi).modified_gibbs --> vec(0.0, 0.0, 1.0)"},
    {"gibbs", bound<gibbs>, "R.gibbs -> vec",
     "G = n tan(theta/2) (Rodrigues vector); infinite at pi, but 1.6e16 at the double nearest to "
     "it.",
     "rotation({0, 0, 1}, 0).gibbs --> vec(0.0, 0.0, 0.0)"},
    {"mrp", bound<mrp>, "R.mrp -> vec",
     "Modified Rodrigues parameters n tan(theta/4); singular at 2 pi.",
     "rotation({0, 0, 1}, 0).mrp --> vec(0.0, 0.0, 0.0)"},
};

constexpr Entry kMethods[] = {
    {"inverse", bound<inverse>, "R:inverse() -> rotation", "Same axis, opposite angle.",
     "rotation({0, 0, 1}, 7):inverse().angle --> -7.0"},
    {"canonical", bound<canonical>, "R:canonical() -> rotation",
     "The operator's own rotation by N3's rule: angle in [0, pi]; at 0 the axis is e1; at pi "
     "(within an ulp) the "
     "last component of the axis that is not zero is positive.",
     "rotation({0, 0, -1}, pi):canonical().axis --> vec(-0.0, -0.0, 1.0)"},
    {"distance", bound<distance_to>, "R:distance(S) -> number",
     "Angle between the operators, in [0, pi]: the geodesic distance.",
     "rotation({0, 0, 1}, 1):distance(rotation({0, 0, 1}, 1.5)) --> 0.5"},
    {"same_operator", bound<same_operator>, "R:same_operator(S, tolerance) -> boolean",
     "Whether the operators are within the tolerance (rad, default 1e-12): turns by 2 pi do not "
     "count.",
     "rotation({0, 0, 1}, 1):same_operator(rotation({0, 0, 1}, 1 + 2*pi)) --> true"},
    {"slerp", bound<slerp_at>, "R:slerp(S, s, {way=}) -> rotation",
     "As slerp(R, S, s): the geodesic from R to S.",
     "rotation.identity:slerp(rotation({0, 0, 1}, 1), 0.5).angle --> 0.5"},
    {"rotate", bound<rotate>, "R:rotate(points) -> table",
     "The list of R * p for a list of points.",
     "rotation({0, 0, 1}, 0):rotate({{1, 2, 3}})[1] --> vec(1.0, 2.0, 3.0)"},
};

constexpr Entry kOperators[] = {
    {"__mul", bound<multiply>, "R * S -> rotation",
     "Composition, S first, by Rodrigues' formula [P11, P12]; the angle is in [0, 2 pi].",
     "(rotation({0, 0, 1}, 1) * rotation({0, 0, 1}, 2)).angle --> 3.0"},
    {"__mul", bound<multiply>, "R * v -> vec",
     "The vector v rotated, by Rodrigues' formula [P3, N4].",
     "rotation({0, 0, 1}, 0) * {1, 2, 3} --> vec(1.0, 2.0, 3.0)"},
    {"__pow", bound<power>, "R ^ x -> rotation", "Same axis, angle times x.",
     "(rotation({0, 0, 1}, 1) ^ 10).angle --> 10.0"},
    {"__eq", bound<equal_values<Rotation>>, "R == S -> boolean",
     "Same axis and same angle; see R:same_operator(S).",
     "rotation({0, 0, 1}, 1) == rotation({0, 0, 2}, 1) --> true"},
    {"__tostring", bound<text_of>, "tostring(R) -> string",
     "The text under which the terminal shows it.", "#tostring(rotation.identity) > 0 --> true"},
};

constexpr Group kGroups[] = {
    {"", Kind::kFunction, kFunctions},     {"rotation", Kind::kFunction, kStatics},
    {"rotation", Kind::kValue, kValues},   {"rotation", Kind::kField, kFields},
    {"rotation", Kind::kMethod, kMethods}, {"rotation", Kind::kOperator, kOperators},
};

}  // namespace

std::span<const Group> rotation_groups() { return kGroups; }

}  // namespace rotor::script
