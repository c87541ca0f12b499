// The Lua side of rotor: a state with the standard libraries and everything that rotor adds to it.
#pragma once

#include <lua.hpp>
#include <memory>

namespace rotor::script {

struct CloseState {
  void operator()(lua_State* L) const { lua_close(L); }
};
using State = std::unique_ptr<lua_State, CloseState>;

/// A new state: Lua's libraries, rotor's names as globals, the embedded Lua modules in
/// package.preload as "rotor.NAME" (lua/NAME.lua). Throws std::bad_alloc when there is no memory
/// for it. `use_environment` false ignores LUA_PATH and LUA_CPATH (option -E).
State make_state(bool use_environment = true);

/// Pushes the text under which the terminal shows the value at `index`: numbers shortest round trip
/// (or with precision(n)), strings quoted, rotor's values by their own text, other tables in short.
void push_shown(lua_State* L, int index);

/// Message handler for lua_pcall: a string gets a traceback, an error object stays as it is.
int add_traceback(lua_State* L);

}  // namespace rotor::script
