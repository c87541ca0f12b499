#include "script/options.hpp"

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "output/columns.hpp"
#include "script/binding.hpp"
#include "script/lua_value.hpp"

namespace rotor::script {
namespace {

// Pushes a table whose keys are those between the braces of the signature.
void push_keys(lua_State* L, std::string_view signature) {
  lua_newtable(L);
  std::string_view rest = signature.substr(signature.find('{') + 1);
  rest = rest.substr(0, rest.find('}'));
  while (!rest.empty()) {
    const std::string_view item = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(rest.size(), item.size() + 1));
    const std::string_view key = item.substr(0, item.find('='));
    const std::string_view name = key.substr(key.find_first_not_of(' '));
    lua_pushlstring(L, name.data(), name.size());
    lua_pushboolean(L, 1);
    lua_rawset(L, -3);
  }
}

}  // namespace

Options::Options(lua_State* L, int index, const char* signature)
    : L_(L), index_(lua_absindex(L, index)) {
  refuse_more_arguments(L, index_);
  if (lua_isnoneornil(L, index)) {
    lua_newtable(L);
    index_ = lua_gettop(L);
    return;
  }
  if (!lua_istable(L, index_)) {
    throw std::invalid_argument("expected options in braces, got " + describe(L, index_) +
                                "; usage: " + signature);
  }
  const StackGuard guard(L);
  push_keys(L, signature);
  const int keys = lua_gettop(L);
  for (lua_pushnil(L); lua_next(L, index_) != 0; lua_pop(L, 1)) {
    if (lua_type(L, -2) != LUA_TSTRING) {
      throw std::invalid_argument(
          std::string("options are named, {key = value}, got a list; usage: ") + signature);
    }
    const std::string key = lua_tostring(L, -2);
    lua_pushvalue(L, -2);
    if (lua_rawget(L, keys) == LUA_TNIL) {
      const std::string hint = did_you_mean(L, key, keys);
      throw std::invalid_argument("unknown option '" + key + "'" +
                                  (hint.empty() ? std::string("; usage: ") + signature : hint));
    }
    lua_pop(L, 1);
  }
}

bool Options::has(const char* key) const {
  const StackGuard guard(L_);
  return lua_getfield(L_, index_, key) != LUA_TNIL;
}

std::size_t Options::word(const char* key, const std::vector<std::string>& words) const {
  const std::string given = get<std::string>(key).value_or(words.front());
  const auto found = std::find(words.begin(), words.end(), given);
  if (found == words.end()) {
    throw std::invalid_argument(std::string(key) + ": expected " +
                                (words.size() == 2 ? "\"" + words[0] + "\" or \"" + words[1] + "\""
                                                   : "one of " + listed(words, "\"")) +
                                ", got \"" + given + "\"");
  }
  return static_cast<std::size_t>(found - words.begin());
}

}  // namespace rotor::script
