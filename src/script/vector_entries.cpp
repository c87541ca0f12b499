// vec and quaternion: the values, and the functions of vectors.
#include <cmath>
#include <optional>

#include "rotation/text.hpp"
#include "script/binding.hpp"
#include "script/show.hpp"

namespace rotor::script {
namespace {

Vector make_vec(double x, double y, double z) { return {x, y, z}; }

template <int I>
double component(const Vector& v) {
  return v(I);
}

// Component i of n, counted from 1; nil past the last, so that ipairs ends.
Results numbered(lua_State* L, const double* first, lua_Integer n) {
  const lua_Integer i = lua_tointeger(L, 2);
  if (i >= 1 && i <= n) {
    lua_pushnumber(L, first[i - 1]);
  } else {
    lua_pushnil(L);
  }
  return {1};
}
Results numbered_vec(lua_State* L) { return numbered(L, argument<Vector>(L, 1).data(), 3); }

Vector add(const Vector& a, const Vector& b) { return a + b; }
Vector subtract(const Vector& a, const Vector& b) { return a - b; }
Vector negative(const Vector& v, const Vector&) { return -v; }
bool equal(const Vector& a, const Vector& b) { return a == b; }
Results size_vec(lua_State* L) {
  lua_pushinteger(L, 3);
  return {1};
}
std::string text_of(const Vector& v) { return "vec" + shown(v); }

// A vector by a number, from either side.
Results multiply(lua_State* L) {
  const bool number_first = lua_type(L, 1) == LUA_TNUMBER;
  if (!number_first && lua_type(L, 2) != LUA_TNUMBER) {
    throw std::invalid_argument("a vec times " + describe(L, 2) +
                                " is not defined: use dot(a, b) or cross(a, b)");
  }
  const double factor = lua_tonumber(L, number_first ? 1 : 2);
  Convert<Vector>::push(L, factor * argument<Vector>(L, number_first ? 2 : 1));
  return {1};
}
Vector divide(const Vector& v, double x) { return v / x; }

double dot(const Vector& a, const Vector& b) { return a.dot(b); }
Vector cross(const Vector& a, const Vector& b) { return a.cross(b); }
double norm_of(const Vector& v) { return norm(v); }
Vector unit_of(const Vector& v) { return unit(v); }

constexpr Entry kFunctions[] = {
    {"vec", bound<make_vec>, "vec(x, y, z) -> vec",
     "A vector. Wherever one is taken, {x, y, z} will do. Its components are v.x, v.y, v.z and "
     "v[1], v[2], v[3].",
     "vec(1, 2, 3) --> vec(1.0, 2.0, 3.0)"},
    {"dot", bound<dot>, "dot(a, b) -> number", "Scalar product of two vectors.",
     "dot({1, 2, 3}, {4, 5, 6}) --> 32.0"},
    {"cross", bound<cross>, "cross(a, b) -> vec", "Vector product of two vectors [N1].",
     "cross({1, 0, 0}, {0, 1, 0}) --> vec(0.0, 0.0, 1.0)"},
    {"norm", bound<norm_of>, "norm(v) -> number",
     "Length of a vector; does not over- or underflow on the way.", "norm {3, 0, 4} --> 5.0"},
    {"unit", bound<unit_of>, "unit(v) -> vec",
     "The vector of length 1 in the direction of v. The zero vector has none: an error.",
     "unit {0, 3, 4} --> vec(0.0, 0.6, 0.8)"},
};

constexpr Entry kFields[] = {
    {"x", bound<component<0>>, "v.x -> number", "First component.", "vec(1, 2, 3).x --> 1.0"},
    {"y", bound<component<1>>, "v.y -> number", "Second component.", "vec(1, 2, 3).y --> 2.0"},
    {"z", bound<component<2>>, "v.z -> number", "Third component.", "vec(1, 2, 3).z --> 3.0"},
    {"[i]", bound<numbered_vec>, "v[i] -> number", "Component i, from 1 to 3; nil past the last.",
     "vec(1, 2, 3)[2] --> 2.0"},
};

constexpr Entry kOperators[] = {
    {"__add", bound<add>, "v + w -> vec", "Sum.",
     "vec(1, 2, 3) + {1, 1, 1} --> vec(2.0, 3.0, 4.0)"},
    {"__sub", bound<subtract>, "v - w -> vec", "Difference.",
     "vec(1, 2, 3) - {1, 1, 1} --> vec(0.0, 1.0, 2.0)"},
    {"__unm", bound<negative>, "-v -> vec", "The opposite vector.",
     "-vec(1, 2, 3) --> vec(-1.0, -2.0, -3.0)"},
    {"__mul", bound<multiply>, "v * x -> vec",
     "Vector times number, from either side. Two vectors have dot(a, b) and cross(a, b).",
     "2 * vec(1, 2, 3) --> vec(2.0, 4.0, 6.0)"},
    {"__div", bound<divide>, "v / x -> vec", "Vector divided by a number.",
     "vec(1, 2, 3) / 2 --> vec(0.5, 1.0, 1.5)"},
    {"__eq", bound<equal>, "v == w -> boolean", "Whether all components are equal.",
     "vec(1, 2, 3) == vec(1, 2, 3) --> true"},
    {"__len", bound<size_vec>, "#v -> number", "3.", "#vec(1, 2, 3) --> 3"},
    {"__tostring", bound<text_of>, "tostring(v) -> string",
     "The text under which the terminal shows it.",
     "tostring(vec(1, 2, 3)) --> \"vec(1.0, 2.0, 3.0)\""},
};

// Quaternions in general, scalar first [N24].
Quaternion make_quaternion(double w, double x, double y, double z) { return {w, x, y, z}; }
double scalar(const Quaternion& q) { return q.w(); }
template <int I>
double imaginary(const Quaternion& q) {
  return q.vec()(I);
}
Results numbered_quaternion(lua_State* L) {
  const Quaternion q = argument<Quaternion>(L, 1);
  const double components[] = {q.w(), q.x(), q.y(), q.z()};
  return numbered(L, components, 4);
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
  Quaternion product = first    ? scaled(argument<Quaternion>(L, 2), lua_tonumber(L, 1))
                       : second ? scaled(argument<Quaternion>(L, 1), lua_tonumber(L, 2))
                                : argument<Quaternion>(L, 1) * argument<Quaternion>(L, 2);
  Convert<Quaternion>::push(L, product);
  return {1};
}
Quaternion add_quaternions(const Quaternion& p, const Quaternion& q) {
  return Quaternion(Eigen::Vector4d(p.coeffs() + q.coeffs()));
}
Quaternion subtract_quaternions(const Quaternion& p, const Quaternion& q) {
  return Quaternion(Eigen::Vector4d(p.coeffs() - q.coeffs()));
}
Quaternion negative_quaternion(const Quaternion& q, const Quaternion&) { return scaled(q, -1); }
bool equal_quaternions(const Quaternion& p, const Quaternion& q) {
  return p.coeffs() == q.coeffs();
}
std::string text_of_quaternion(const Quaternion& q) {
  return "quaternion(" + shown(q.w()) + ", " + shown(q.x()) + ", " + shown(q.y()) + ", " +
         shown(q.z()) + ")";
}
double norm_of_quaternion(const Quaternion& q) { return norm(q); }
Quaternion conjugate(const Quaternion& q) { return q.conjugate(); }
Quaternion unit_quaternion(const Quaternion& q) { return unit(q); }
Results polar_form(lua_State* L) {
  const Polar form = polar(argument<Quaternion>(L, 1));
  lua_pushnumber(L, form.norm);
  Convert<Rotation>::push(L, form.rotation);
  return {2};
}

constexpr Entry kQuaternionFunctions[] = {
    {"quaternion", bound<make_quaternion>, "quaternion(w, x, y, z) -> quaternion",
     "A quaternion of any norm, scalar first. Its components are q.w, q.x, q.y, q.z and q[1] to "
     "q[4].",
     "quaternion(1, 2, 3, 4) --> quaternion(1.0, 2.0, 3.0, 4.0)"},
};
constexpr Entry kQuaternionFields[] = {
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
constexpr Entry kQuaternionMethods[] = {
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
};
constexpr Entry kQuaternionOperators[] = {
    {"__mul", bound<multiply_quaternion>, "p * q -> quaternion",
     "Quaternion product [N24-N26]; a number scales, from either side.",
     "quaternion(0, 1, 0, 0) * quaternion(0, 0, 1, 0) --> quaternion(0.0, 0.0, 0.0, 1.0)"},
    {"__add", bound<add_quaternions>, "p + q -> quaternion", "Sum of components.",
     "quaternion(1, 0, 0, 0) + quaternion(0, 0, 0, 1) --> quaternion(1.0, 0.0, 0.0, 1.0)"},
    {"__sub", bound<subtract_quaternions>, "p - q -> quaternion", "Difference of components.",
     "quaternion(1, 0, 0, 0) - quaternion(0, 0, 0, 1) --> quaternion(1.0, 0.0, 0.0, -1.0)"},
    {"__unm", bound<negative_quaternion>, "-q -> quaternion",
     "The opposite: the same operator, a turn further.",
     "-quaternion(1, 2, 3, 4) --> quaternion(-1.0, -2.0, -3.0, -4.0)"},
    {"__eq", bound<equal_quaternions>, "p == q -> boolean", "Whether all components are equal.",
     "quaternion(1, 0, 0, 0) == -quaternion(1, 0, 0, 0) --> false"},
    {"__len", bound<size_quaternion>, "#q -> number", "4.", "#quaternion(1, 2, 3, 4) --> 4"},
    {"__tostring", bound<text_of_quaternion>, "tostring(q) -> string",
     "The text under which the terminal shows it.",
     "tostring(quaternion(1, 0, 0, 0)) --> \"quaternion(1.0, 0.0, 0.0, 0.0)\""},
};

constexpr Group kGroups[] = {
    {"", Kind::kFunction, kFunctions},
    {"vec", Kind::kField, kFields},
    {"vec", Kind::kOperator, kOperators},
    {"", Kind::kFunction, kQuaternionFunctions},
    {"quaternion", Kind::kField, kQuaternionFields},
    {"quaternion", Kind::kMethod, kQuaternionMethods},
    {"quaternion", Kind::kOperator, kQuaternionOperators},
};

}  // namespace

std::span<const Group> vector_groups() { return kGroups; }

}  // namespace rotor::script
