#include "script/lua_value.hpp"

namespace rotor::script {
namespace {

thread_local lua_State* current = nullptr;

lua_State* main_thread(lua_State* L) {
  lua_rawgeti(L, LUA_REGISTRYINDEX, LUA_RIDX_MAINTHREAD);
  lua_State* main = lua_tothread(L, -1);
  lua_pop(L, 1);
  return main;
}

int keep(lua_State* L, int index) {
  lua_pushvalue(L, index);
  return luaL_ref(L, LUA_REGISTRYINDEX);
}

}  // namespace

lua_State* current_state() { return current; }

CurrentState::CurrentState(lua_State* L) : before_(current) { current = L; }
CurrentState::~CurrentState() { current = before_; }

Reference::Reference(lua_State* L, int index) : main_(main_thread(L)), key_(keep(L, index)) {}

Reference::~Reference() { luaL_unref(main_, LUA_REGISTRYINDEX, key_); }

void Reference::push(lua_State* L) const { lua_rawgeti(L, LUA_REGISTRYINDEX, key_); }

void push_module(lua_State* L, const char* name) {
  luaL_getsubtable(L, LUA_REGISTRYINDEX, LUA_LOADED_TABLE);
  lua_getfield(L, -1, name);
  if (lua_isnil(L, -1)) {
    lua_pop(L, 1);
    luaL_getsubtable(L, LUA_REGISTRYINDEX, LUA_PRELOAD_TABLE);
    lua_getfield(L, -1, name);
    lua_remove(L, -2);
    lua_pushstring(L, name);
    lua_call(L, 1, 1);
    lua_pushvalue(L, -1);
    lua_setfield(L, -3, name);
  }
  lua_remove(L, -2);
}

}  // namespace rotor::script
