// Between Lua's values and C++'s: one Convert<T> a type.
//
// get(L, index) gives the value or throws Mismatch; push(L, value) pushes it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <lua.hpp>
#include <memory>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "dynamics/lyapunov.hpp"
#include "dynamics/recurrence.hpp"
#include "dynamics/strobe.hpp"
#include "integrate/certify.hpp"
#include "motion/run.hpp"
#include "output/spectrum_output.hpp"
#include "rotation/chain.hpp"
#include "rotation/fit.hpp"
#include "rotation/kinematics.hpp"
#include "rotation/rotation.hpp"
#include "rotation/spherical_triangle.hpp"
#include "rotation/spline.hpp"

namespace rotor::script {

/// "expected a rotation, got nil".
class Mismatch : public std::runtime_error {
 public:
  Mismatch(lua_State* L, int index, const std::string& expected);
  explicit Mismatch(const std::string& message) : std::runtime_error(message) {}
};

/// What a value is, for people: `nil`, `number 3.0`, `string "abc"`, `vec`, `table`.
std::string describe(lua_State* L, int index);

/// "; did you mean 'angle'?" or nothing. The candidates are the string keys of the table at
/// `index`.
std::string did_you_mean(lua_State* L, const std::string& word, int index);

/// The types that live in userdata. `name` is what scripts call the type; `member` may read numeric
/// keys.
template <class T>
struct UserType;  // static constexpr const char* kName

/// A run is shared with its states.
using SharedRun = std::shared_ptr<const Run>;
using SharedRecurrence = std::shared_ptr<const RunRecurrence>;

/// A state and the run that it is of. Axis and angle are found when they are asked for.
struct RunState {
  SharedRun run;
  State attitude;
  mutable std::optional<State> full = std::nullopt;
};

/// Times of a run: of a strobe, which has a period, or of a section.
struct RunPoints {
  SharedRun run;
  std::vector<double> times;
  std::optional<double> period;
  mutable std::optional<StrobeCircle> circle = std::nullopt;
};
using SharedPoints = std::shared_ptr<const RunPoints>;
/// What run:lyapunov found, and how.
struct LyapunovResult {
  LyapunovSpectrum spectrum;
  Chart chart;
  LyapunovMethod method;
  double t0;
  double isometry;
};

// clang-format off
template <> struct UserType<Vector>     { static constexpr const char* kName = "vec"; };
template <> struct UserType<Rotation>   { static constexpr const char* kName = "rotation"; };
template <> struct UserType<Quaternion> { static constexpr const char* kName = "quaternion"; };
template <> struct UserType<Chain>      { static constexpr const char* kName = "chain"; };
template <> struct UserType<SharedRun>  { static constexpr const char* kName = "run"; };
template <> struct UserType<RunState>   { static constexpr const char* kName = "state"; };
template <> struct UserType<SharedPoints> { static constexpr const char* kName = "points"; };
template <> struct UserType<Crossing>   { static constexpr const char* kName = "crossing"; };
template <> struct UserType<Cost>       { static constexpr const char* kName = "cost"; };
template <> struct UserType<Certificate> { static constexpr const char* kName = "certificate"; };
template <> struct UserType<SharedRecurrence> { static constexpr const char* kName = "recurrence"; };
template <> struct UserType<LyapunovResult> { static constexpr const char* kName = "lyapunov"; };
template <> struct UserType<SignalSpectrum> { static constexpr const char* kName = "spectrum"; };
template <> struct UserType<NamedFrequencies> { static constexpr const char* kName = "frequencies"; };
template <> struct UserType<RigidFit>   { static constexpr const char* kName = "rigid_fit"; };
template <> struct UserType<RotationRates> { static constexpr const char* kName = "rates"; };
template <> struct UserType<Spline>     { static constexpr const char* kName = "spline"; };
template <> struct UserType<SphericalTriangle> { static constexpr const char* kName = "spherical_triangle"; };
template <> struct UserType<AngularVelocity> { static constexpr const char* kName = "spin"; };
template <> struct UserType<Jet>        { static constexpr const char* kName = "jet"; };
// clang-format on

/// The key of a type's metatable in the registry.
std::string metatable_key(const char* type);

/// Where in its block a value lies: Lua aligns to 8, Eigen's quaternion wants 16.
template <class T>
T* aligned(void* block) {
  std::size_t space = sizeof(T) + alignof(T);
  return static_cast<T*>(std::align(alignof(T), sizeof(T), block, space));
}

template <class T>
T* test_user_value(lua_State* L, int index) {
  void* block = luaL_testudata(L, index, metatable_key(UserType<T>::kName).c_str());
  return block == nullptr ? nullptr : aligned<T>(block);
}

/// About how many bytes a value keeps where Lua's collector does not see them.
template <class T>
std::size_t hidden_bytes(const T&) {
  return 0;
}
inline std::size_t hidden_bytes(const Spline& spline) { return 300 * spline.times().size(); }
inline std::size_t hidden_bytes(const SharedPoints& points) { return 8 * points->times.size(); }
inline std::size_t hidden_bytes(const SharedRecurrence& r) { return 44 * r->times.size(); }
inline std::size_t hidden_bytes(const LyapunovResult& result) {
  return sizeof(double) * 4 * result.spectrum.times.size();
}
inline std::size_t hidden_bytes(const SignalSpectrum& s) { return 16 * s.spectrum.density.size(); }
inline std::size_t hidden_bytes(const SharedRun& run) { return 400 * run->propagator().cost.steps; }

/// As if Lua had allocated them: else garbage of this kind would outgrow the memory.
inline void tell_collector(lua_State* L, std::size_t bytes) {
  const auto kilobytes = static_cast<int>(std::min<std::size_t>(bytes >> 10, 1 << 30));
  if (kilobytes > 0) lua_gc(L, LUA_GCSTEP, kilobytes);  // 0 would be a whole step
}

template <class T>
struct ConvertUser {
  static const T& get(lua_State* L, int index) {
    const T* value = test_user_value<T>(L, index);
    if (value == nullptr) throw Mismatch(L, index, std::string("a ") + UserType<T>::kName);
    return *value;
  }
  static void push(lua_State* L, const T& value) {
    void* block = lua_newuserdatauv(L, sizeof(T) + alignof(T), 1);
    new (aligned<T>(block)) T(value);
    luaL_setmetatable(L, metatable_key(UserType<T>::kName).c_str());
    tell_collector(L, hidden_bytes(value));
  }
  // Without its metatable the value is none any more: another finalizer may still hold it.
  static int collect(lua_State* L) {
    if (T* value = test_user_value<T>(L, 1)) {
      std::destroy_at(value);
      lua_pushnil(L);
      lua_setmetatable(L, 1);
    }
    return 0;
  }
};

template <class T>
struct Convert : ConvertUser<T> {};

/// vec or {x, y, z}.
template <>
struct Convert<Vector> : ConvertUser<Vector> {
  static Vector get(lua_State* L, int index);
};

/// Whether it is a vec or a list of numbers: not of rows or points.
bool is_vector(lua_State* L, int index);

/// quaternion or {w, x, y, z}.
template <>
struct Convert<Quaternion> : ConvertUser<Quaternion> {
  static Quaternion get(lua_State* L, int index);
};

/// jet or number.
template <>
struct Convert<Jet> : ConvertUser<Jet> {
  static Jet get(lua_State* L, int index);
};

/// A table of three rows of three numbers; pushed with the metatable "matrix".
template <>
struct Convert<Matrix> {
  static Matrix get(lua_State* L, int index);
  static void push(lua_State* L, const Matrix& m);
};

template <>
struct Convert<double> {
  static double get(lua_State* L, int index);
  static void push(lua_State* L, double x) { lua_pushnumber(L, x); }
};

/// An integer, 0 or more.
template <>
struct Convert<std::size_t> {
  static std::size_t get(lua_State* L, int index);
  static void push(lua_State* L, std::size_t x) { lua_pushinteger(L, static_cast<lua_Integer>(x)); }
};

template <>
struct Convert<bool> {
  static bool get(lua_State* L, int index);
  static void push(lua_State* L, bool x) { lua_pushboolean(L, x); }
};

template <>
struct Convert<std::string> {
  static std::string get(lua_State* L, int index);
  static void push(lua_State* L, const std::string& s) { lua_pushlstring(L, s.data(), s.size()); }
};

template <class T>
struct Convert<std::optional<T>> {
  static std::optional<T> get(lua_State* L, int index) {
    if (lua_isnoneornil(L, index)) return std::nullopt;
    return Convert<T>::get(L, index);
  }
  static void push(lua_State* L, const std::optional<T>& value) {
    value ? Convert<T>::push(L, *value) : lua_pushnil(L);
  }
};

/// A table of named values is no empty list: throws Mismatch.
void require_list(lua_State* L, int index, lua_Unsigned size);

/// A list {a, b, ...}.
template <class T>
struct Convert<std::vector<T>> {
  static std::vector<T> get(lua_State* L, int index) {
    if (!lua_istable(L, index)) throw Mismatch(L, index, "a list");
    const auto size = lua_rawlen(L, index);
    require_list(L, index, size);
    std::vector<T> list;
    list.reserve(size);
    for (lua_Unsigned i = 1; i <= size; ++i) {
      lua_rawgeti(L, index, static_cast<lua_Integer>(i));
      try {
        list.push_back(Convert<T>::get(L, lua_gettop(L)));
      } catch (const Mismatch& error) {
        throw Mismatch("item " + std::to_string(i) + ": " + error.what());
      }
      lua_pop(L, 1);
    }
    return list;
  }
  static void push(lua_State* L, const std::vector<T>& list) {
    lua_createtable(L, static_cast<int>(list.size()), 0);
    for (std::size_t i = 0; i < list.size(); ++i) {
      Convert<T>::push(L, list[i]);
      lua_rawseti(L, -2, static_cast<lua_Integer>(i + 1));
    }
  }
};

}  // namespace rotor::script
