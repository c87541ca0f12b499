#include "script/interpreter.hpp"

#include <new>
#include <stdexcept>
#include <string>

#include "script/binding.hpp"
#include "script/embedded_lua.hpp"
#include "script/lua_value.hpp"

namespace rotor::script {
namespace {

int load_embedded(lua_State* L) {
  const auto* module = static_cast<const EmbeddedModule*>(lua_touserdata(L, lua_upvalueindex(1)));
  const std::string name = "=rotor." + module->name;
  if (luaL_loadbuffer(L, module->source.data(), module->source.size(), name.c_str()) != LUA_OK) {
    return lua_error(L);
  }
  lua_pushvalue(L, 1);
  lua_call(L, 1, 1);
  return 1;
}

int open_everything(lua_State* L) {
  luaL_openlibs(L);
  register_groups(L);
  luaL_getsubtable(L, LUA_REGISTRYINDEX, LUA_PRELOAD_TABLE);
  for (const EmbeddedModule& module : embedded_modules()) {
    lua_pushlightuserdata(L, const_cast<EmbeddedModule*>(&module));
    lua_pushcclosure(L, load_embedded, 1);
    lua_setfield(L, -2, ("rotor." + module.name).c_str());
  }
  push_module(L, "rotor.prelude");
  return 0;
}

}  // namespace

State make_state(bool use_environment) {
  State state(luaL_newstate());
  if (!state) throw std::bad_alloc();
  lua_State* L = state.get();
  if (!use_environment) {
    lua_pushboolean(L, 1);
    lua_setfield(L, LUA_REGISTRYINDEX, "LUA_NOENV");
  }
  lua_pushcfunction(L, open_everything);
  if (lua_pcall(L, 0, 0, 0) != LUA_OK) {
    throw std::runtime_error(luaL_tolstring(L, -1, nullptr));
  }
  return state;
}

int add_traceback(lua_State* L) {
  if (lua_type(L, 1) != LUA_TSTRING) return 1;
  luaL_traceback(L, L, lua_tostring(L, 1), 1);
  return 1;
}

}  // namespace rotor::script
