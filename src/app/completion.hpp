// What may stand at the cursor, asked of the module rotor.complete.
#pragma once

#include <lua.hpp>
#include <string>

#include "app/line_reader.hpp"

namespace rotor::app {

/// Raises nothing: where the module fails, there is nothing to complete.
Completions complete(lua_State* L, const std::string& line, std::size_t cursor);

}  // namespace rotor::app
