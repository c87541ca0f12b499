// An angular velocity given by a script.
#pragma once

#include <lua.hpp>

#include "spin/angular_velocity.hpp"

namespace rotor::script {

/// From the value at `index`: a vec or {x, y, z} (constant), or a function of t that returns three
/// numbers, a table {x, y, z} or a vec. The function runs in the coroutine that called rotor; what
/// it raises becomes a ScriptError; a wrong result is an error that names the function's place, t
/// and what came.
AngularVelocity scripted_omega(lua_State* L, int index);

}  // namespace rotor::script
