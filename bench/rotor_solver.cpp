#include <cstdio>
#include <map>
#include <stdexcept>
#include <string>

#include "integrate/propagator.hpp"
#include "script/convert.hpp"
#include "script/interpreter.hpp"
#include "solver.hpp"

namespace rotor::bench {
namespace {

/// A run that did not reach its end has no samples, and says why.
Result stopped(const Problem& problem, double accuracy, const std::string& why) {
  std::fprintf(stderr, "rotor on %s, asked for %.1e: %s\n", problem.name.c_str(), accuracy,
               why.c_str());
  return {};
}

Result run_native(const Problem& problem, double accuracy) {
  Scene scene{.omega = std::visit(
                  [](const auto& omega) {
                    return AngularVelocity([omega](double t) {
                      const auto [x, y, z] = omega(t);
                      return Vector(x, y, z);
                    });
                  },
                  problem.native)};
  scene.t1 = problem.t1;
  scene.accuracy = accuracy;
  scene.method = Method::kFgl;
  const Propagator run = propagate(scene);
  const Quaternion from = start().quaternion();
  if (run.stop) return stopped(problem, accuracy, run.stop->message);
  Result result{{}, run.cost.omega_calls, run.error_estimate};
  result.samples.reserve(problem.times.size());
  for (const double t : problem.times) result.samples.push_back(run(t, from));
  return result;
}

/// What a user writes, and what comes of it.
constexpr const char* kScript = R"(
local code, to, times = ...
local omega, from = load(code)(), rotation({1, 1, 1}, 1)
return function(accuracy)
  local run = evolve{omega = omega, from = from, to = to, accuracy = accuracy, method = "fgl"}
  local quaternions = {}
  for i = 1, #times do quaternions[i] = run(times[i]).quaternion end
  return run.cost.omega_calls, run.error_estimate, quaternions
end
)";

void require_ok(lua_State* L, int status) {
  if (status != LUA_OK) throw std::runtime_error(luaL_tolstring(L, -1, nullptr));
}

/// A state of rotor with the problem's function of the accuracy on top.
script::State prepare(const Problem& problem) {
  script::State state = script::make_state(false);
  lua_State* const L = state.get();
  require_ok(L, luaL_loadstring(L, kScript));
  lua_pushstring(L, problem.code.c_str());
  lua_pushnumber(L, problem.t1);
  lua_createtable(L, static_cast<int>(problem.times.size()), 0);
  for (std::size_t i = 0; i < problem.times.size(); ++i) {
    lua_pushnumber(L, problem.times[i]);
    lua_rawseti(L, -2, static_cast<lua_Integer>(i + 1));
  }
  require_ok(L, lua_pcall(L, 3, 1, 0));
  return state;
}

Result run_lua(const Problem& problem, double accuracy) {
  static std::map<std::string, script::State> states;
  script::State& state = states[problem.name];
  if (!state) state = prepare(problem);
  lua_State* const L = state.get();
  lua_settop(L, 1);
  lua_pushvalue(L, 1);
  lua_pushnumber(L, accuracy);
  if (lua_pcall(L, 1, 3, 0) != LUA_OK) {
    return stopped(problem, accuracy, luaL_tolstring(L, -1, nullptr));
  }
  Result result{{}, static_cast<std::size_t>(lua_tointeger(L, 2)), lua_tonumber(L, 3)};
  result.samples.reserve(problem.times.size());
  for (std::size_t i = 0; i < problem.times.size(); ++i) {
    lua_rawgeti(L, 4, static_cast<lua_Integer>(i + 1));
    result.samples.push_back(*script::test_user_value<Quaternion>(L, -1));
    lua_pop(L, 1);
  }
  return result;
}

}  // namespace

Solver rotor_solver() {
  return {"rotor", false, [](const Problem& problem, Kind kind, double accuracy) {
            return kind == Kind::kLua ? run_lua(problem, accuracy) : run_native(problem, accuracy);
          }};
}

}  // namespace rotor::bench
