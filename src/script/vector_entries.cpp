// vec: the value, and the functions of vectors.
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "rotation/spaces.hpp"
#include "rotation/text.hpp"
#include "script/binding.hpp"
#include "script/show.hpp"

namespace rotor::script {

/// Of any dimension: a vec or a list of numbers; pushed as a vec where it has three components.
template <>
struct Convert<Eigen::VectorXd> {
  static Eigen::VectorXd get(lua_State* L, int index) {
    if (const Vector* v = test_user_value<Vector>(L, index)) return *v;
    if (!lua_istable(L, index)) throw Mismatch(L, index, "a vec or a list of numbers");
    const auto list = Convert<std::vector<double>>::get(L, index);
    return Eigen::Map<const Eigen::VectorXd>(list.data(), static_cast<Eigen::Index>(list.size()));
  }
  static void push(lua_State* L, const Eigen::VectorXd& v) {
    if (v.size() == 3) {
      Convert<Vector>::push(L, v);
    } else {
      Convert<std::vector<double>>::push(L, {v.begin(), v.end()});
    }
  }
};

namespace {

Results make_vec(lua_State* L) {
  if (lua_istable(L, 1) || test_user_value<Vector>(L, 1) != nullptr) {
    refuse_more_arguments(L, 1);
    Convert<Vector>::push(L, argument<Vector>(L, 1));
    return {1};
  }
  refuse_more_arguments(L, 3);
  const auto x = argument<double>(L, 1);
  const auto y = argument<double>(L, 2);
  Convert<Vector>::push(L, {x, y, argument<double>(L, 3)});
  return {1};
}

template <int I>
double component(const Vector& v) {
  return v(I);
}

Results numbered_vec(lua_State* L) { return push_component(L, argument<Vector>(L, 1).data(), 3); }

Vector add(const Vector& a, const Vector& b) { return a + b; }
Vector subtract(const Vector& a, const Vector& b) { return a - b; }
Vector negative(const Vector& v, const Vector&) { return -v; }
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

double dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  if (a.size() != b.size()) {
    throw std::invalid_argument("expected vectors of one size, got " + std::to_string(a.size()) +
                                " and " + std::to_string(b.size()) + " components");
  }
  return a.dot(b);
}
double norm_of(const Eigen::VectorXd& v) { return static_cast<double>(v.cast<Extended>().norm()); }
Vector unit_of(const Vector& v) { return unit(v); }

// All arguments.
std::vector<Eigen::VectorXd> any_vectors(lua_State* L) {
  std::vector<Eigen::VectorXd> vectors;
  const int count = lua_gettop(L);
  for (int i = 1; i <= count; ++i) vectors.push_back(argument<Eigen::VectorXd>(L, i));
  return vectors;
}

Results cross_product(lua_State* L) {
  Convert<Eigen::VectorXd>::push(L, cross(any_vectors(L)));
  return {1};
}

Results box_product(lua_State* L) {
  lua_pushnumber(L, box(any_vectors(L)));
  return {1};
}

// The determinant of an operator is the box product of the rows of its matrix.
double determinant_of(const std::vector<Eigen::VectorXd>& rows) {
  for (const Eigen::VectorXd& row : rows) {
    if (row.size() != static_cast<Eigen::Index>(rows.size())) {
      throw std::invalid_argument("expected an n x n matrix, n from 2 to 8, got " +
                                  std::to_string(rows.size()) + " rows, one of " +
                                  std::to_string(row.size()) + " numbers");
    }
  }
  return box(rows);
}

Results orientation_of(lua_State* L) {
  lua_pushinteger(L, orientation(any_vectors(L)));
  return {1};
}

Results sign_of_permutation(lua_State* L) {
  refuse_more_arguments(L, 1);
  lua_pushinteger(L, permutation_sign(argument<std::vector<std::size_t>>(L, 1)));
  return {1};
}

constexpr Entry kFunctions[] = {
    {"vec", bound<make_vec>, "vec(x, y, z) -> vec",
     "A vector, of three numbers or of {x, y, z}; wherever one is taken, {x, y, z} will do. Its "
     "components are v.x, v.y, v.z and v[1], v[2], v[3].",
     "vec(1, 2, 3) --> vec(1.0, 2.0, 3.0)"},
    {"dot", bound<dot>, "dot(a, b) -> number",
     "Scalar product of two vectors, or of two lists of n numbers.",
     "dot({1, 2, 3}, {4, 5, 6}) --> 32.0"},
    {"cross", bound<cross_product>, "cross(a2, ..., an) -> vec",
     "Vector product of two vectors [N1]. Of n - 1 lists of n numbers, n from 2 to 8: the list "
     "that "
     "is perpendicular to all of them. Exact (then rounded once) for integers whose product of "
     "lengths is below 1e37.",
     "cross({1, 0, 0}, {0, 1, 0}) --> vec(0.0, 0.0, 1.0)"},
    {"box", bound<box_product>, "box(a1, ..., an) -> number",
     "Box product a . cross(b, c), the signed volume [N2]; of n lists of n numbers, n from 2 to 8. "
     "Exact (then rounded once) for integers whose product of lengths is below 1e37.",
     "box({1, 2, 3}, {4, 5, 6}, {7, 8, 10}) --> -3.0"},
    {"det", bound<determinant_of>, "det(T) -> number",
     "Determinant of the operator with the matrix T [N3]: n rows of n numbers, n from 2 to 8. "
     "Exact (then rounded once) for integers whose product of lengths is below 1e37.",
     "det({{1, 2}, {3, 4}}) --> -2.0"},
    {"orientation", bound<orientation_of>, "orientation(a1, ..., an) -> number",
     "1 if the basis is right-handed, -1 if it is left-handed; of n lists of n numbers, n from 2 "
     "to "
     "8. Vectors that are dependent, or too nearly so to tell, are an error.",
     "orientation({1, 0, 0}, {0, 0, 1}, {0, 1, 0}) --> -1"},
    {"permutation_sign", bound<sign_of_permutation>, "permutation_sign(list) -> number",
     "1 for an even permutation of 1, 2, ..., n (an even number of interchanges), -1 for an odd "
     "one.",
     "permutation_sign {2, 3, 1} --> 1"},
    {"norm", bound<norm_of>, "norm(v) -> number",
     "Length of a vector or list; does not over- or underflow on the way.",
     "norm {3, 0, 4} --> 5.0"},
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
    {"__eq", bound<equal_values<Vector>>, "v == w -> boolean", "Whether all components are equal.",
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
