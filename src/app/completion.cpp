#include "app/completion.hpp"

#include "app/errors.hpp"
#include "script/lua_value.hpp"

namespace rotor::app {
namespace {

struct Request {
  const std::string& line;
  std::size_t cursor;
  Completions answer;
};

int ask_module(lua_State* L) {
  auto& request = *static_cast<Request*>(lua_touserdata(L, 1));
  script::push_module(L, "rotor.complete");
  lua_pushlstring(L, request.line.data(), request.line.size());
  lua_pushinteger(L, static_cast<lua_Integer>(request.cursor));
  lua_call(L, 2, 2);
  const lua_Integer start = luaL_checkinteger(L, -2);
  luaL_argcheck(L, start >= 1, 1, "start below 1");
  request.answer.start = static_cast<std::size_t>(start - 1);
  for (lua_Integer i = 1; lua_geti(L, -1, i) == LUA_TSTRING; ++i) {
    request.answer.words.emplace_back(lua_tostring(L, -1));
    lua_pop(L, 1);
  }
  return 0;
}

}  // namespace

Completions complete(lua_State* L, const std::string& line, std::size_t cursor) {
  Request request{line, cursor, {}};
  lua_pushcfunction(L, ask_module);
  lua_pushlightuserdata(L, &request);
  if (call(L, 1, 0)) return std::move(request.answer);
  lua_pop(L, 1);
  return {};
}

}  // namespace rotor::app
