#include "script/scripted_omega.hpp"

#include <memory>
#include <stdexcept>
#include <string>

#include "integrate/loop.hpp"
#include "rotation/text.hpp"
#include "script/convert.hpp"
#include "script/interpreter.hpp"
#include "script/interrupt.hpp"
#include "script/lua_value.hpp"

namespace rotor::script {
namespace {

// "omega (function at script.lua:3)"
std::string name_of_function(lua_State* L, int index) {
  lua_Debug info;
  lua_pushvalue(L, index);
  lua_getinfo(L, ">S", &info);
  return "omega (function at " + std::string(info.short_src) +
         (info.linedefined > 0 ? ":" + std::to_string(info.linedefined) : "") + ")";
}

std::string describe_results(lua_State* L, int first, int count) {
  std::string list = count == 0 ? "nothing" : "";
  for (int i = 0; i < count && i < 8; ++i) list += (i == 0 ? "" : ", ") + describe(L, first + i);
  return list + (count > 8 ? ", ... (" + std::to_string(count) + " values)" : "");
}

// The vector among `count` results of the function, the first at `first`.
Vector vector_of_results(lua_State* L, int first, int count, const std::string& name, double t) {
  if (count == 3) {
    Vector v;
    bool numbers = true;
    for (int i = 0; i < 3; ++i) {
      numbers = numbers && lua_type(L, first + i) == LUA_TNUMBER;
      v(i) = lua_tonumber(L, first + i);
    }
    if (numbers) return v;
  }
  if (count == 1 && (lua_istable(L, first) || test_user_value<Vector>(L, first) != nullptr)) {
    try {
      return Convert<Vector>::get(L, first);
    } catch (const Mismatch& mismatch) {
      throw std::runtime_error(name + " at t = " + text(t) + ": " + mismatch.what());
    }
  }
  throw std::runtime_error(name + " at t = " + text(t) +
                           ": expected three numbers, a table {x, y, z} or a vec, got " +
                           describe_results(L, first, count));
}

}  // namespace

AngularVelocity scripted_omega(lua_State* L, int index) {
  if (const Spline* spline = test_user_value<Spline>(L, index)) {
    return {[s = *spline](double t) { return s.omega(t); }, "the spline's omega"};
  }
  if (!lua_isfunction(L, index)) return Convert<Vector>::get(L, index);
  auto function = std::make_shared<const Reference>(L, index);
  std::string name = name_of_function(L, index);
  auto value_at = [function, name](double t) {
    lua_State* const running = current_state();
    const StackGuard guard(running);
    luaL_checkstack(running, 8, "omega");
    lua_pushcfunction(running, add_traceback);
    const int handler = lua_gettop(running);
    function->push(running);
    lua_pushnumber(running, t);
    if (lua_pcall(running, 1, LUA_MULTRET, handler) != LUA_OK) {
      if (interrupt_pending()) throw Interrupted();
      std::string raised = describe(running, -1);
      if (lua_isstring(running, -1) || luaL_getmetafield(running, -1, "__tostring") != LUA_TNIL) {
        lua_settop(running, handler + 1);
        raised = luaL_tolstring(running, -1, nullptr);
        lua_pop(running, 1);
      }
      throw ScriptError(std::make_shared<const Reference>(running, -1),
                        name + " failed at t = " + text(t) + ": " + raised);
    }
    return vector_of_results(running, handler + 1, lua_gettop(running) - handler, name, t);
  };
  return {std::move(value_at), std::move(name)};
}

}  // namespace rotor::script
