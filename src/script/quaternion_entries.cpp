// quaternion: general quaternions of any norm.
#include "rotation/quaternion.hpp"
#include "script/binding.hpp"
#include "script/show.hpp"

namespace rotor::script {
namespace {

Quaternion make_quaternion(double w, double x, double y, double z) { return {w, x, y, z}; }
double scalar(const Quaternion& q) { return q.w(); }
template <int I>
double imaginary(const Quaternion& q) {
  return q.vec()(I);
}
Results numbered_quaternion(lua_State* L) {
  const Quaternion q = argument<Quaternion>(L, 1);
  const double components[] = {q.w(), q.x(), q.y(), q.z()};
  return push_component(L, components, 4);
}
Results size_quaternion(lua_State* L) {
  lua_pushinteger(L, 4);
  return {1};
}
Quaternion scaled(const Quaternion& q, double x) {
  return Quaternion(Eigen::Vector4d(q.coeffs() * x));
}
Results multiply_quaternion(lua_State* L) {
  const bool first = lua_type(L, 1) == LUA_TNUMBER;
  const bool second = lua_type(L, 2) == LUA_TNUMBER;
  const Quaternion result = first ? scaled(argument<Quaternion>(L, 2), lua_tonumber(L, 1))
                            : second
                                ? scaled(argument<Quaternion>(L, 1), lua_tonumber(L, 2))
                                : product(argument<Quaternion>(L, 1), argument<Quaternion>(L, 2));
  Convert<Quaternion>::push(L, result);
  return {1};
}
Quaternion divide_quaternion(const Quaternion& q, double x) {
  return Quaternion(Eigen::Vector4d(q.coeffs() / x));
}
Quaternion power_of_quaternion(const Quaternion& q, double x) { return power(q, x); }
Quaternion add_quaternions(const Quaternion& p, const Quaternion& q) {
  return Quaternion(Eigen::Vector4d(p.coeffs() + q.coeffs()));
}
Quaternion subtract_quaternions(const Quaternion& p, const Quaternion& q) {
  return Quaternion(Eigen::Vector4d(p.coeffs() - q.coeffs()));
}
Quaternion negative_quaternion(const Quaternion& q, const Quaternion&) { return scaled(q, -1); }
std::string text_of_quaternion(const Quaternion& q) { return shown(q); }
double norm_of_quaternion(const Quaternion& q) { return norm(q); }
Quaternion conjugate(const Quaternion& q) { return q.conjugate(); }
Quaternion unit_quaternion(const Quaternion& q) { return unit(q); }
Quaternion inverse_quaternion(const Quaternion& q) { return inverse(q); }
Quaternion exp_of_quaternion(const Quaternion& q) { return exp(q); }
Quaternion log_of_quaternion(const Quaternion& q) { return log(q); }
double dot_of_quaternions(const Quaternion& p, const Quaternion& q) {
  return static_cast<double>(p.cast<Extended>().dot(q.cast<Extended>()));
}
Results polar_form(lua_State* L) {
  refuse_more_arguments(L, 1);
  const Polar form = polar(argument<Quaternion>(L, 1));
  lua_pushnumber(L, form.norm);
  Convert<Rotation>::push(L, form.rotation);
  return {2};
}

constexpr Entry kFunctions[] = {
    {"quaternion", bound<make_quaternion>, "quaternion(w, x, y, z) -> quaternion",
     "A quaternion of any norm, scalar first. Its components are q.w, q.x, q.y, q.z and q[1] to "
     "q[4].",
     "quaternion(1, 2, 3, 4) --> quaternion(1.0, 2.0, 3.0, 4.0)"},
    {"continuous_quaternions", bound<continuous_quaternions>,
     "continuous_quaternions(list) -> table",
     "The same operators in quaternions without jumps of sign: each is q or -q, with a dot product "
     "of at least 0 with the one before; the first stays.",
     "continuous_quaternions({{1, 0, 0, 0}, {-0.8, 0.6, 0, 0}})[2] --> quaternion(0.8, -0.6, -0.0, "
     "-0.0)"},
};
constexpr Entry kStatics[] = {
    {"from_polar", bound<from_polar>, "quaternion.from_polar(norm, R) -> quaternion",
     "The quaternion norm (cos theta/2, u sin theta/2) of a rotation's axis u and angle theta, "
     "which "
     "counts modulo 4 pi: q:polar() gives norm and rotation back.",
     "quaternion.from_polar(3, rotation({0, 0, 1}, 4*pi)).w --> 3.0"},
};
constexpr Entry kFields[] = {
    {"w", bound<scalar>, "q.w -> number", "Scalar part.", "quaternion(1, 2, 3, 4).w --> 1.0"},
    {"x", bound<imaginary<0>>, "q.x -> number", "First imaginary part.",
     "quaternion(1, 2, 3, 4).x --> 2.0"},
    {"y", bound<imaginary<1>>, "q.y -> number", "Second imaginary part.",
     "quaternion(1, 2, 3, 4).y --> 3.0"},
    {"z", bound<imaginary<2>>, "q.z -> number", "Third imaginary part.",
     "quaternion(1, 2, 3, 4).z --> 4.0"},
    {"[i]", bound<numbered_quaternion>, "q[i] -> number",
     "Component i, from 1 (w) to 4; nil past the last.", "quaternion(1, 2, 3, 4)[1] --> 1.0"},
};
constexpr Entry kMethods[] = {
    {"norm", bound<norm_of_quaternion>, "q:norm() -> number", "Square root of the sum of squares.",
     "quaternion(1, 1, 1, 1):norm() --> 2.0"},
    {"conj", bound<conjugate>, "q:conj() -> quaternion", "The conjugate (w, -x, -y, -z).",
     "quaternion(1, 2, 3, 4):conj() --> quaternion(1.0, -2.0, -3.0, -4.0)"},
    {"unit", bound<unit_quaternion>, "q:unit() -> quaternion",
     "q divided by its norm; zero has none: an error.",
     "quaternion(0, 3, 0, 4):unit() --> quaternion(0.0, 0.6, 0.0, 0.8)"},
    {"polar", bound<polar_form>, "q:polar() -> number, rotation",
     "Polar form [N24-N26]: the norm, and the rotation whose axis u and angle theta in [0, 2 pi] "
     "make "
     "q = norm (cos theta/2, u sin theta/2).",
     "(quaternion(0, 2, 0, 0):polar()) --> 2.0"},
    {"inverse", bound<inverse_quaternion>, "q:inverse() -> quaternion",
     "The quaternion whose product with q is 1: conjugate over squared norm; zero has none: an "
     "error.",
     "quaternion(0, 2, 0, 0):inverse() --> quaternion(0.0, -0.5, -0.0, -0.0)"},
    {"dot", bound<dot_of_quaternions>, "p:dot(q) -> number", "Sum of products of components.",
     "quaternion(1, 2, 3, 4):dot(quaternion(4, 3, 2, 1)) --> 20.0"},
    {"exp", bound<exp_of_quaternion>, "q:exp() -> quaternion",
     "e^w (cos|v|, v/|v| sin|v|), v the imaginary part: of (0, n theta/2) the unit quaternion of "
     "the "
     "rotation by theta about n.",
     "quaternion(0, 0, 0, 0):exp() --> quaternion(1.0, 0.0, 0.0, 0.0)"},
    {"log", bound<log_of_quaternion>, "q:log() -> quaternion",
     "(ln norm, u theta/2) of the polar form, theta/2 in [0, pi]; the axis of a negative number is "
     "e1. Zero has none: an error.",
     "quaternion(0, 0, 1, 0):log() --> quaternion(0.0, 0.0, 1.5707963267948966, 0.0)"},
};
constexpr Entry kOperators[] = {
    {"__mul", bound<multiply_quaternion>, "p * q -> quaternion",
     "Quaternion product [N24-N26]; a number scales, from either side.",
     "quaternion(0, 1, 0, 0) * quaternion(0, 0, 1, 0) --> quaternion(0.0, 0.0, 0.0, 1.0)"},
    {"__div", bound<divide_quaternion>, "q / x -> quaternion",
     "Quaternion divided by a number. By a quaternion: q * p:inverse() or p:inverse() * q.",
     "quaternion(1, 2, 3, 4) / 2 --> quaternion(0.5, 1.0, 1.5, 2.0)"},
    {"__pow", bound<power_of_quaternion>, "q ^ x -> quaternion",
     "The repeated product for a whole x (of the inverse for x < 0), else norm^x with the "
     "rotation's "
     "angle times x.",
     "quaternion(1, 1, 0, 0) ^ 2 --> quaternion(0.0, 2.0, 0.0, 0.0)"},
    {"__add", bound<add_quaternions>, "p + q -> quaternion", "Sum of components.",
     "quaternion(1, 0, 0, 0) + quaternion(0, 0, 0, 1) --> quaternion(1.0, 0.0, 0.0, 1.0)"},
    {"__sub", bound<subtract_quaternions>, "p - q -> quaternion", "Difference of components.",
     "quaternion(1, 0, 0, 0) - quaternion(0, 0, 0, 1) --> quaternion(1.0, 0.0, 0.0, -1.0)"},
    {"__unm", bound<negative_quaternion>, "-q -> quaternion",
     "The opposite: the same operator, a turn further.",
     "-quaternion(1, 2, 3, 4) --> quaternion(-1.0, -2.0, -3.0, -4.0)"},
    {"__eq", bound<equal_values<Quaternion>>, "p == q -> boolean",
     "Whether all components are equal.",
     "quaternion(1, 0, 0, 0) == -quaternion(1, 0, 0, 0) --> false"},
    {"__len", bound<size_quaternion>, "#q -> number", "4.", "#quaternion(1, 2, 3, 4) --> 4"},
    {"__tostring", bound<text_of_quaternion>, "tostring(q) -> string",
     "The text under which the terminal shows it.",
     "tostring(quaternion(1, 0, 0, 0)) --> \"quaternion(1.0, 0.0, 0.0, 0.0)\""},
};

constexpr Group kGroups[] = {
    {"", Kind::kFunction, kFunctions},           {"quaternion", Kind::kFunction, kStatics},
    {"quaternion", Kind::kField, kFields},       {"quaternion", Kind::kMethod, kMethods},
    {"quaternion", Kind::kOperator, kOperators},
};

}  // namespace

std::span<const Group> quaternion_groups() { return kGroups; }

}  // namespace rotor::script
