// What a person typed, made into something that Lua can run.
#pragma once

#include <lua.hpp>
#include <string>

namespace rotor::app {

enum class Input { kComplete, kIncomplete, kWrong };

/// Compiles `text` as an expression or, if it is none, as statements; "= expression" is an
/// expression. Pushes the function, or the message that says best what is wrong or missing.
Input compile_input(lua_State* L, const std::string& text);

}  // namespace rotor::app
