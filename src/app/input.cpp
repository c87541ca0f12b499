#include "app/input.hpp"

#include <algorithm>
#include <string_view>

namespace rotor::app {
namespace {

constexpr const char* kChunkName = "=stdin";

std::string_view message(lua_State* L, int index) {
  std::size_t size = 0;
  const char* data = lua_tolstring(L, index, &size);
  return {data, size};
}

bool load(lua_State* L, const std::string& text) {
  return luaL_loadbufferx(L, text.data(), text.size(), kChunkName, "t") == LUA_OK;
}

bool compile(lua_State* L, const std::string& text) {
  if (load(L, text)) return true;
  if (!message(L, -1).ends_with("unfinished string near <eof>")) return false;
  // The end of the line settles whether the string may go on: only after "\" or "\z".
  lua_pop(L, 1);
  return load(L, text + "\n");
}

bool wants_more(std::string_view error) { return error.ends_with("<eof>"); }

/// Whether the parser stopped at the first word: as statements, the text has no meaning at all.
bool stopped_at_once(std::string_view error, std::string_view text) {
  constexpr std::string_view kStopped = "unexpected symbol near '";
  const std::size_t found = error.find(kStopped);
  if (found == error.npos) return false;
  std::string_view word = error.substr(found + kStopped.size());
  word.remove_suffix(1);
  text.remove_prefix(std::min(text.find_first_not_of(" \t\n"), text.size()));
  return text.starts_with(word);
}

}  // namespace

Input compile_input(lua_State* L, const std::string& text) {
  const bool expression_only = text.starts_with('=');
  if (compile(L, "return " + text.substr(expression_only ? 1 : 0))) return Input::kComplete;
  bool more = wants_more(message(L, -1));
  if (!expression_only) {
    const bool good = compile(L, text);
    const bool keep_first = !good && stopped_at_once(message(L, -1), text);
    more = more || (!good && wants_more(message(L, -1)));
    lua_remove(L, keep_first ? -1 : -2);
    if (good) return Input::kComplete;
  }
  return more ? Input::kIncomplete : Input::kWrong;
}

}  // namespace rotor::app
