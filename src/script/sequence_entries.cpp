// Sequences of rotations: chains, Euler angles, factoring, and whether two commute.
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "rotation/chain.hpp"
#include "rotation/factoring.hpp"
#include "script/binding.hpp"
#include "script/options.hpp"
#include "script/show.hpp"

namespace rotor::script {
namespace {

Frame frame_of(const Options& options) {
  return options.word("frame", {"body", "space"}) == 1 ? Frame::kSpace : Frame::kBody;
}

// One line on stderr for a singular factoring: "script.lua:3: euler_angles: singular: ...".
void warn_if_singular(lua_State* L, const Factoring& factoring, const Options& options) {
  if (options.word("singular", {"warn", "silent"}) == 1 || factoring.singular.empty()) return;
  warn(L, "singular: " + factoring.singular);
}

constexpr const char* kAnglesAbout = "R:angles_about(a1, a2, a3, {singular=}) -> table";
Results angles_about_axes(lua_State* L) {
  const Rotation& r = argument<Rotation>(L, 1);
  const auto u1 = argument<Vector>(L, 2), u2 = argument<Vector>(L, 3);
  // Options are named: a table with items is the third axis.
  const bool two = lua_istable(L, 4) && lua_rawlen(L, 4) == 0;
  const int last = two ? 4 : 5;
  const auto u3 = two ? std::nullopt : argument<std::optional<Vector>>(L, 4);
  const Options options(L, last, kAnglesAbout);
  const Factoring factoring = u3 ? angles_about(r, u1, u2, *u3) : angles_about(r, u1, u2);
  warn_if_singular(L, factoring, options);
  Convert<std::vector<std::vector<double>>>::push(L, factoring.solutions);
  return {1};
}

constexpr const char* kFromEulerAngles =
    "rotation.from_euler_angles(sequence, a, b, c, {frame=}) -> rotation";
Results of_euler_angles(lua_State* L) {
  const auto sequence = argument<std::string>(L, 1);
  Vector angles;
  const bool list = lua_type(L, 2) != LUA_TNUMBER;
  if (list) {
    angles = argument<Vector>(L, 2);
  } else {
    for (int i = 0; i < 3; ++i) angles(i) = argument<double>(L, 2 + i);
  }
  const int last = list ? 3 : 5;
  const Frame frame = frame_of(Options(L, last, kFromEulerAngles));
  Convert<Rotation>::push(L,
                          from_euler_angles(sequence, {angles.x(), angles.y(), angles.z()}, frame));
  return {1};
}

constexpr const char* kEulerAngles =
    "R:euler_angles(sequence, {frame=, solution=, singular=}) -> number, number, number";
Results euler_angles_of(lua_State* L) {
  const Rotation& r = argument<Rotation>(L, 1);
  const auto sequence = argument<std::string>(L, 2);
  const Options options(L, 3, kEulerAngles);
  const std::size_t solution = options.get<std::size_t>("solution").value_or(1);
  if (solution != 1 && solution != 2) {
    throw std::invalid_argument("solution: expected 1 or 2, got " + std::to_string(solution));
  }
  const Factoring factoring = euler_angles(r, sequence, frame_of(options));
  warn_if_singular(L, factoring, options);
  for (const double angle :
       solution == 1 ? factoring.solutions.front() : factoring.solutions.back()) {
    lua_pushnumber(L, angle);
  }
  return {3};
}

// Letters, or a list of vectors.
std::vector<Vector> axes_of(lua_State* L, const Options& options) {
  const StackGuard guard(L);
  options.push("axes");
  const int type = lua_type(L, -1);
  if (type == LUA_TSTRING) return axes_of_letters(lua_tostring(L, -1));
  if (type != LUA_TTABLE) {
    throw std::invalid_argument("axes: expected letters or a list of vectors, got " +
                                describe(L, -1));
  }
  return *options.get<std::vector<Vector>>("axes");
}

constexpr const char* kChain = "chain{axes=, angles=, rates=, frame=} -> chain";
Results make_chain(lua_State* L) {
  const Options options(L, 1, kChain);
  const std::vector<Vector> axes = axes_of(L, options);
  const auto angles = options.get<std::vector<double>>("angles");
  if (!angles) throw std::invalid_argument("angles: expected a list, got nothing");
  const auto rates = options.get<std::vector<double>>("rates");
  Convert<Chain>::push(L, Chain(axes, *angles, rates, frame_of(options)));
  return {1};
}

Rotation rotation_of_chain(const Chain& chain) { return chain.rotation(); }
Vector omega(const Chain& chain) { return chain.omega(); }
std::vector<Vector> axes(const Chain& chain) { return chain.axes(); }
std::vector<Matrix> derivatives(const Chain& chain) { return chain.derivatives(); }
std::vector<std::vector<double>> jacobian(const Chain& chain) {
  std::vector<std::vector<double>> rows;
  const Eigen::Matrix3Xd j = chain.jacobian();
  for (const auto& row : j.rowwise()) rows.emplace_back(row.begin(), row.end());
  return rows;
}
Results rank_of_chain(lua_State* L) {
  lua_pushinteger(L, argument<Chain>(L, 1).rank());
  return {1};
}
std::vector<double> rates(const Chain& chain, const Vector& omega) { return chain.rates(omega); }
std::string text_of(const Chain& chain) {
  return "chain  axes " + std::to_string(chain.size()) + "  rank " + std::to_string(chain.rank()) +
         "\nrotation  " + shown_axis_angle(chain.rotation().axis(), chain.rotation().angle(), 10);
}

Results commute_and_why(lua_State* L) {
  const Rotation& r = argument<Rotation>(L, 1);
  const Rotation& s = argument<Rotation>(L, 2);
  const auto tolerance = argument<std::optional<double>>(L, 3);
  refuse_more_arguments(L, 3);
  const Commutation result = tolerance ? commute(r, s, *tolerance) : commute(r, s);
  lua_pushboolean(L, result.commute);
  Convert<std::string>::push(
      L, result.commute ? result.why : "R*S and S*R differ by " + shown(result.distance) + " rad");
  return {2};
}

constexpr Entry kFunctions[] = {
    {"chain", bound<make_chain>, kChain,
     "A sequence of rotations [N20-N23] about any number of axes: a list of vectors of any length "
     "but zero, or letters (\"zyx\"). The axes are fixed in the \"body\" (default: Q = Q1 Q2 ... "
     "Qn) or in \"space\" (Q = Qn ... Q2 Q1). With one rate for each angle it has an omega; "
     "C:rates(omega) is the way back: Euler rates to angular velocity and back.",
     "chain{axes = \"zyx\", angles = {0, 0, 1}}.rotation.angle --> 1.0"},
    {"commute", bound<commute_and_why>, "commute(R, S, tolerance) -> boolean, string",
     "Whether the operators commute, R*S and S*R within the tolerance (rad, default 1e-12), and "
     "why: \"identity\", \"parallel axes\" or \"perpendicular half turns\"; if not, how far they "
     "differ.",
     "select(2, commute(rotation({1, 0, 0}, pi), rotation({0, 1, 0}, pi))) --> \"perpendicular "
     "half turns\""},
};

constexpr Entry kStatics[] = {
    {"from_euler_angles", bound<of_euler_angles>, kFromEulerAngles,
     "From Euler angles, three numbers or {a, b, c}, about the letters of a sequence, one of xyz "
     "xzy yxz yzx zxy zyx xyx xzx "
     "yxy yzy zxz zyz; about axes of the \"body\" (default, intrinsic: \"zyx\" is Qz(a) Qy(b) "
     "Qx(c), yaw, pitch and roll) or of \"space\" (extrinsic: Qx(c) Qy(b) Qz(a)). Angle in [0, 2 "
     "pi].",
     "rotation.from_euler_angles(\"zyx\", 0, 0.5, 0).axis --> vec(0.0, 1.0, 0.0)"},
};

constexpr Entry kMethods[] = {
    {"euler_angles", bound<euler_angles_of>, kEulerAngles,
     "The Euler angles a, b, c for a sequence such as \"zyx\" (see rotation.from_euler_angles), in "
     "(-pi, pi]. Of the two solutions the first (default) has b in [0, pi] where the outer letters "
     "agree, else in [-pi/2, pi/2]. Where that ends (gimbal lock) only a + c or a - c is "
     "determined: then c = 0, and a line on stderr says so, unless singular = \"silent\".",
     "vec(rotation({0, 0, 1}, 90*deg):euler_angles(\"zyx\"))/deg --> vec(90.0, 0.0, 0.0)"},
    {"angles_about", bound<angles_about_axes>, kAnglesAbout,
     "All {a, b, c} with R = Q(a1, a) Q(a2, b) Q(a3, c), in (-pi, pi], smaller |b| first; without "
     "a3 all {a, b} with R = Q(a1, a) Q(a2, b). Axes of any length but zero. If R is out of reach "
     "an error says what is reachable. Where only a sum or difference is determined one solution "
     "is given, and a line on stderr says so, unless singular = \"silent\".",
     "rotation({0, 0, 1}, 0.5):angles_about({0, 0, 1}, {0, 1, 0}, {1, 0, 0})[1][1] --> 0.5"},
};

constexpr Entry kChainFields[] = {
    {"rotation", bound<rotation_of_chain>, "C.rotation -> rotation",
     "The product of the sequence [N20], angle in [0, 2 pi].",
     "chain{axes = \"zz\", angles = {0.25, 0.5}}.rotation.angle --> 0.75"},
    {"omega", bound<omega>, "C.omega -> vec",
     "Angular velocity [N23] of the chain's rates, in the space frame; in the body frame it is "
     "C.rotation:inverse() * C.omega.",
     "chain{axes = \"zyx\", angles = {0, 0, 0}, rates = {1, 2, 3}}.omega --> vec(3.0, 2.0, 1.0)"},
    {"axes", bound<axes>, "C.axes -> table",
     "The axes where they are now, v_k of [N23], in the space frame.",
     "chain{axes = \"zyx\", angles = {0, 0, 0}}.axes[2] --> vec(0.0, 1.0, 0.0)"},
    {"jacobian", bound<jacobian>, "C.jacobian -> table",
     "The three rows of the 3 x n matrix J with omega = J * rates; its columns are C.axes.",
     "chain{axes = \"zyx\", angles = {0, 0, 0}}.jacobian[1][3] --> 1.0"},
    {"rank", bound<rank_of_chain>, "C.rank -> number",
     "Rank of the Jacobian, 1 to 3. Below 3 the chain is singular: some omega has no rates. A "
     "singular value counts as zero if rounding of axes and angles can make it that.",
     "chain{axes = \"zyx\", angles = {0, pi/2, 0}}.rank --> 2"},
    {"derivatives", bound<derivatives>, "C.derivatives -> table",
     "The matrices dQ/dtheta_k [N21], one for each axis.",
     "chain{axes = \"z\", angles = {0}}.derivatives[1][2][1] --> 1.0"},
};

constexpr Entry kChainMethods[] = {
    {"rates", bound<rates>, "C:rates(omega) -> table",
     "The rates for a wanted angular velocity in the space frame (for one in the body frame give "
     "C.rotation * omega): the inverse of C.omega. Of several the smallest (least sum of squares); "
     "if there are none an error says what part of omega is out of reach.",
     "chain{axes = \"zyx\", angles = {0, 0, 0}}:rates({3, 2, 1})[1] --> 1.0"},
};

constexpr Entry kChainOperators[] = {
    {"__tostring", bound<text_of>, "tostring(C) -> string",
     "The text under which the terminal shows it.",
     "#tostring(chain{axes = \"z\", angles = {1}}) > 0 --> true"},
};

constexpr Group kGroups[] = {
    {"", Kind::kFunction, kFunctions},       {"rotation", Kind::kFunction, kStatics},
    {"rotation", Kind::kMethod, kMethods},   {"chain", Kind::kField, kChainFields},
    {"chain", Kind::kMethod, kChainMethods}, {"chain", Kind::kOperator, kChainOperators},
};

}  // namespace

std::span<const Group> sequence_groups() { return kGroups; }

}  // namespace rotor::script
