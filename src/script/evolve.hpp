// evolve{...}: from an options table to a run.
#pragma once

#include <lua.hpp>

#include "script/convert.hpp"

namespace rotor::script {

constexpr const char* kEvolve =
    "evolve{omega=, from=, to=, t=, accuracy=, method=, step=, max_step=, max_steps=, breaks=, "
    "equation=, f=, restart=, singularity=, points=, crossing_tolerance=} -> run";

/// The run of the options table at index 1. A run that stops early is a ScriptError whose value is
/// a table of type "stop": .reason .t .run .message, and .cause, what omega raised if it did.
SharedRun evolve_options(lua_State* L);

}  // namespace rotor::script
