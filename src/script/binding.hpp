// Functions of C++ as functions of Lua: bound<f>, and the tables of entries from which
// registration, help, completion and the reference come.
#pragma once

#include <exception>
#include <lua.hpp>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>

#include "script/convert.hpp"
#include "script/lua_value.hpp"

namespace rotor::script {

/// One row: the one place to add a function. The signature ends in "-> type" where something is
/// returned; the example is "expression --> what the terminal shows".
struct Entry {
  const char* name;
  lua_CFunction function;
  const char* signature;
  const char* summary;
  const char* example;
};

/// A value is what its function gives at the start.
enum class Kind { kFunction, kValue, kMethod, kField, kOperator };

/// Rows of one kind and owner. An owner is "" (globals), a global table ("rotation": its functions)
/// or the name of a type (fields, methods, operators; an operator's row is named by its
/// metamethod).
struct Group {
  const char* owner;
  Kind kind;
  std::span<const Entry> entries;
};

/// For functions that push their results themselves.
struct Results {
  int count;
};

/// Pushes "script.lua:3: ", the nearest place in Lua code, or "".
void push_place(lua_State* L);

/// The message of an error for scripts: where in the script, which function, what. Pushed.
void push_error_message(lua_State* L, const char* what);
/// The same as a line on stderr, where the function goes on.
void warn(lua_State* L, const std::string& what);
/// As a bad argument of the running function.
[[noreturn]] void throw_bad_argument(lua_State* L, int index, const std::exception& mismatch);

/// Component i (the argument after the value) of n numbers, counted from 1; nil past the last, so
/// that ipairs ends.
Results push_component(lua_State* L, const double* first, lua_Integer n);

/// Whether both arguments are values of type T, and equal: values of different types are not.
template <class T>
Results equal_values(lua_State* L) {
  const T* a = test_user_value<T>(L, 1);
  const T* b = test_user_value<T>(L, 2);
  bool equal = a != nullptr && b != nullptr;
  if constexpr (requires { *a == *b; }) {
    equal = equal && *a == *b;
  } else {
    equal = equal && a->coeffs() == b->coeffs();
  }
  lua_pushboolean(L, equal ? 1 : 0);
  return {1};
}

/// More arguments than a function or method takes are an error (an operator gets what Lua gives
/// it).
void refuse_more_arguments(lua_State* L, int count);

template <class A>
auto argument(lua_State* L, int index) -> decltype(Convert<A>::get(L, index)) {
  try {
    return Convert<A>::get(L, index);
  } catch (const Mismatch& mismatch) {
    throw_bad_argument(L, index, mismatch);
  }
}

template <class R>
int push_result(lua_State* L, R&& result) {
  using Value = std::remove_cvref_t<R>;
  if constexpr (std::is_same_v<Value, Results>) {
    return result.count;
  } else {
    Convert<Value>::push(L, std::forward<R>(result));
    return 1;
  }
}

template <auto F, class R, class... A, std::size_t... I>
int call_with_arguments(lua_State* L, std::index_sequence<I...>) {
  refuse_more_arguments(L, static_cast<int>(sizeof...(A)));
  // Braces: the arguments are converted from left to right.
  using Tuple = std::tuple<decltype(Convert<std::remove_cvref_t<A>>::get(L, 0))...>;
  Tuple arguments{argument<std::remove_cvref_t<A>>(L, static_cast<int>(I) + 1)...};
  if constexpr (std::is_void_v<R>) {
    F(std::get<I>(arguments)...);
    return 0;
  } else {
    return push_result(L, F(std::get<I>(arguments)...));
  }
}

template <auto F, class R, class... A>
int call_bound(lua_State* L, R (*)(A...)) {
  return call_with_arguments<F, R, A...>(L, std::index_sequence_for<A...>{});
}
/// A function that takes the state reads its arguments itself.
template <auto F>
int call_bound(lua_State* L, Results (*)(lua_State*)) {
  return F(L).count;
}

/// F with its arguments converted; no C++ exception leaves it: std::exception becomes a Lua error,
/// a ScriptError gives the script its own error value back. Lua's errors (of a private type) pass
/// through.
template <auto F>
int bound(lua_State* L) {
  try {
    const CurrentState current(L);
    return call_bound<F>(L, +F);
  } catch (const ScriptError& error) {
    error.push(L);
  } catch (const std::exception& error) {
    push_error_message(L, error.what());
  }
  return lua_error(L);
}

/// The groups of all floors' names, in the order of the reference.
std::span<const Group> rotation_groups();
std::span<const Group> vector_groups();
std::span<const Group> matrix_groups();
std::span<const Group> quaternion_groups();
std::span<const Group> sequence_groups();
std::span<const Group> kinematics_groups();
std::span<const Group> fit_groups();
std::span<const Group> triangle_groups();
std::span<const Group> list_groups();
std::span<const Group> spin_groups();
std::span<const Group> run_groups();
std::span<const Group> crossing_groups();
std::span<const Group> points_groups();
std::span<const Group> certify_groups();
std::span<const Group> recurrence_groups();
std::span<const Group> lyapunov_groups();
std::span<const Group> spectrum_groups();
std::span<const Group> plot_groups();
std::span<const Group> jet_groups();
std::span<const Group> terminal_groups();

/// Makes a type's metatable and the registry row of each entry, and sets globals.
void register_groups(lua_State* L);

}  // namespace rotor::script
