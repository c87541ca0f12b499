#include "script/evolve.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "integrate/generalized.hpp"
#include "rotation/text.hpp"
#include "script/binding.hpp"
#include "script/lua_value.hpp"
#include "script/options.hpp"
#include "script/progress.hpp"
#include "script/scripted_omega.hpp"

namespace rotor::script {
namespace {

AngularVelocity omega_of(lua_State* L, const Options& options) {
  const StackGuard guard(L);
  options.push("omega");
  if (lua_isnil(L, -1))
    throw std::invalid_argument(std::string("omega is missing; usage: ") + kEvolve);
  try {
    return scripted_omega(L, lua_gettop(L));
  } catch (const Mismatch&) {
    throw std::invalid_argument(
        "omega: expected a function of t, a vec, {x, y, z}, a model of spin or a spline, got " +
        describe(L, -1));
  }
}

void set_interval(const Options& options, Scene& scene) {
  const auto interval = options.get<std::vector<double>>("t");
  const auto to = options.get<double>("to");
  if (interval.has_value() == to.has_value()) {
    throw std::invalid_argument(interval ? "give t = {t0, t1} or to = t1, not both"
                                         : "give to = t1 or t = {t0, t1}");
  }
  if (to) {
    scene.t1 = *to;
    return;
  }
  if (interval->size() != 2) {
    throw std::invalid_argument("t: expected {t0, t1}, got a list of " +
                                std::to_string(interval->size()));
  }
  scene.t0 = interval->front();
  scene.t1 = interval->back();
}

void set_equation(lua_State* L, const Options& options, Scene& scene) {
  scene.equation = static_cast<Equation>(  // in its order
      options.word("equation", {"quaternion", "euler", "modified_gibbs", "gibbs", "axis_angle",
                                "body_points", "generalized"}));
  scene.restart = options.get<bool>("restart").value_or(false);
  scene.ignore_singularity = options.word("singularity", {"stop", "ignore"}) == 1;
  const bool generalized = scene.equation == Equation::kGeneralized;
  if (generalized != options.has("f")) {
    throw std::invalid_argument(generalized
                                    ? "equation = \"generalized\" needs f, a function of theta"
                                    : "f is for equation = \"generalized\"");
  }
  if (!generalized) return;
  const StackGuard guard(L);
  options.push("f");
  scene.f = std::make_shared<const GeneralizedAngle>(scripted_jet_function(L, lua_gettop(L)));
}

Scene scene_of(lua_State* L, const Options& options) {
  Scene scene{.omega = omega_of(L, options)};
  set_interval(options, scene);
  scene.method = static_cast<Method>(  // in its order
      options.word("method", {"auto", "exact", "fgl", "rk4", "dop853"}));
  scene.step = options.get<double>("step");
  if (scene.step && options.has("accuracy")) {
    throw std::invalid_argument(
        "give accuracy or step, not both: a fixed step has no say in accuracy");
  }
  scene.accuracy = options.get<double>("accuracy").value_or(scene.accuracy);
  scene.max_step = options.get<double>("max_step");
  scene.max_steps = options.get<std::size_t>("max_steps").value_or(scene.max_steps);
  scene.breaks = options.get<std::vector<double>>("breaks").value_or(std::vector<double>());
  set_equation(L, options, scene);
  return scene;
}

// Pushes what omega raised, or nil.
void push_cause(lua_State* L, const Stop& stop) {
  try {
    if (stop.cause) std::rethrow_exception(stop.cause);
    lua_pushnil(L);
  } catch (const ScriptError& error) {
    error.push(L);
  } catch (const std::exception& error) {
    lua_pushstring(L, error.what());
  }
}

int message_of_stop(lua_State* L) {
  lua_getfield(L, 1, "message");
  return 1;
}

int concatenate(lua_State* L) {
  luaL_tolstring(L, 1, nullptr);
  luaL_tolstring(L, 2, nullptr);
  lua_concat(L, 2);
  return 1;
}

[[noreturn]] void raise_stop(lua_State* L, const SharedRun& run, const Scene& scene) {
  const Stop& stop = *run->propagator().stop;
  push_place(L);
  const std::string message =
      lua_tostring(L, -1) + ("evolve: stopped at t = " + text(stop.t) + " of " + text(scene.t0) +
                             " .. " + text(scene.t1) + ": " + stop.message);
  lua_createtable(L, 0, 5);
  Convert<std::string>::push(L, stop.reason);
  lua_setfield(L, -2, "reason");
  lua_pushnumber(L, stop.t);
  lua_setfield(L, -2, "t");
  Convert<SharedRun>::push(L, run);
  lua_setfield(L, -2, "run");
  Convert<std::string>::push(L, message);
  lua_setfield(L, -2, "message");
  push_cause(L, stop);
  lua_setfield(L, -2, "cause");
  if (luaL_newmetatable(L, metatable_key("stop").c_str()) != 0) {
    lua_pushliteral(L, "stop");
    lua_setfield(L, -2, "__name");
    lua_pushcfunction(L, message_of_stop);
    lua_setfield(L, -2, "__tostring");
    lua_pushcfunction(L, concatenate);
    lua_setfield(L, -2, "__concat");
  }
  lua_setmetatable(L, -2);
  throw ScriptError(std::make_shared<const Reference>(L, -1), message);
}

}  // namespace

SharedRun evolve_options(lua_State* L) {
  const Options options(L, 1, kEvolve);
  const Scene scene = scene_of(L, options);
  const Rotation from = options.get<Rotation>("from").value_or(Rotation());
  auto points = options.get<std::vector<Vector>>("points").value_or(std::vector<Vector>());
  const auto run = std::make_shared<const Run>(evolve(scene, from, watching(scene.t0, scene.t1),
                                                      std::move(points),
                                                      options.get<double>("crossing_tolerance")));
  if (!run->complete()) raise_stop(L, run, scene);
  return run;
}

}  // namespace rotor::script
