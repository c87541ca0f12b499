// Calling Lua so that nothing escapes, and saying what went wrong.
#pragma once

#include <lua.hpp>
#include <string>
#include <string_view>

namespace rotor::app {

/// lua_pcall with a traceback: calls the function below the `arguments` values on top of the stack.
/// When it fails, the error value is left on top.
bool call(lua_State* L, int arguments, int results);

/// The text of the error value on top, which is popped. An object says it through __tostring; a
/// global that is not there brings the name that may have been meant; of a traceback, the frames
/// of rotor's own Lua code are left out where it leads further.
/// Raises nothing, whatever the object does.
std::string take_error(lua_State* L);

/// An error message of Lua as a person at the prompt wants it: the message first; the line only
/// where the input has several; the traceback only when it leads further than the input itself.
std::string for_the_prompt(const std::string& error, bool several_lines);

/// Writes to standard error, after what is waiting for standard output.
void print_error(std::string_view message);

/// The same, with lines broken between words where standard error is a terminal too narrow.
void print_error_at_prompt(const std::string& message);

}  // namespace rotor::app
