// The log of a gyroscope, as a script gives it.
#pragma once

#include <lua.hpp>

#include "script/options.hpp"
#include "spin/samples.hpp"

namespace rotor::script {

/// The samples of the argument at `index`, a file name, rows {{t, x, y, z}, ...} or columns {t =
/// {...}, x = {...}, ...}, by the options columns, unit, time_unit, bias, scale, missing, order,
/// duplicates and separator. Throws std::invalid_argument as samples_of and cleaned do, ScriptError
/// for an argument of another kind, and what reading a file throws.
Samples log_argument(lua_State* L, int index, const Options& options);

}  // namespace rotor::script
