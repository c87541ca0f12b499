// vec: the value, and the functions of vectors.
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

Results numbered_vec(lua_State* L) { return push_component(L, argument<Vector>(L, 1).data(), 3); }

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

constexpr Group kGroups[] = {
    {"", Kind::kFunction, kFunctions},
    {"vec", Kind::kField, kFields},
    {"vec", Kind::kOperator, kOperators},
};

}  // namespace

std::span<const Group> vector_groups() { return kGroups; }

}  // namespace rotor::script
