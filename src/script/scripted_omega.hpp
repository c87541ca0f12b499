// Functions of t given by a script: an angular velocity, a rate, the f of a generalized Euler
// vector.
#pragma once

#include <functional>
#include <lua.hpp>

#include "spin/angular_velocity.hpp"
#include "spin/jet.hpp"
#include "spin/models.hpp"

namespace rotor::script {

// A function runs in the coroutine that called rotor; what it raises becomes a ScriptError; a wrong
// result is an error that names the function's place, t and what came. Its derivatives come from a
// call with a jet in place of t, and are held against its values (check_jet).

/// From the value at `index`: a vec or {x, y, z} (constant), a function of t that returns three
/// numbers, a table {x, y, z} or a vec, a spin or a spline. Throws Mismatch for anything else.
AngularVelocity scripted_omega(lua_State* L, int index);

/// From a function of t that returns a number. Throws Mismatch for anything else.
ScalarFunction scripted_scalar(lua_State* L, int index);

/// From a function of one variable that returns a number, to be called with jets. What it gives is
/// held against its value at each call. Throws Mismatch for anything but a function;
/// NotDifferentiable when called, where it has no derivatives.
std::function<Jet(const Jet&)> scripted_jet_function(lua_State* L, int index);

}  // namespace rotor::script
