// The problems of the measurements: an omega in C++ and in Lua, an interval, and the true motion.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <lua.hpp>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "rotation/extended.hpp"
#include "rotation/rotation.hpp"

namespace rotor::bench {

using Components = std::array<double, 3>;

/// [P15] omega = (cos at, sin at, 0).
struct Turning {
  double a;
  Components operator()(double t) const { return {std::cos(a * t), std::sin(a * t), 0}; }
};

/// P4: oscillation, a chirp that decays, slow growth.
struct Mixed {
  Components operator()(double t) const {
    return {std::sin(3 * t) + 0.3 * std::cos(17 * t), std::exp(-t / 50) * std::cos(t * t / 40),
            0.5 * std::log(1 + t)};
  }
};

/// P6: one turning until `jump`, another from there on.
struct Jump {
  Turning before;
  Turning after;
  double jump;
  Components operator()(double t) const { return t < jump ? before(t) : after(t); }
};

/// The function that the Lua code returns, called through Lua's own C interface.
class LuaOmega {
 public:
  explicit LuaOmega(const std::string& code);
  Components operator()(double t) const {
    lua_State* const L = state_.get();
    lua_pushvalue(L, 1);
    lua_pushnumber(L, t);
    if (lua_pcall(L, 1, 3, 0) != LUA_OK) fail();
    const Components omega{lua_tonumber(L, -3), lua_tonumber(L, -2), lua_tonumber(L, -1)};
    lua_settop(L, 1);
    return omega;
  }

 private:
  [[noreturn]] void fail() const;
  std::shared_ptr<lua_State> state_;  // with the function at 1
};

using NativeOmega = std::variant<Turning, Mixed, Jump>;
enum class Kind { kNative, kLua };

struct Problem {
  std::string name;
  std::string statement;  // for people
  NativeOmega native;
  std::string code;  // of Lua, that returns the same function
  LuaOmega lua;      // which is this
  double t1;
  std::vector<double> times;              // 100, the last of them t1; in P5 more
  std::vector<ExtendedQuaternion> truth;  // there, from start()
};

/// E(0) = (1, 1, 1)/sqrt 3.
Rotation start();

const Problem& p1();
const Problem& p2();
const Problem& p3();
const Problem& p4();
/// P1 at t = 0, 0.01, ..., 4200: 420,001 times.
const Problem& p5();
const Problem& p6();
const Problem& p1_long();

/// The greatest |q -+ truth| of quaternions at the problem's times; infinite where some are
/// missing.
double greatest_error(const Problem& problem, const std::vector<Quaternion>& computed);

}  // namespace rotor::bench
