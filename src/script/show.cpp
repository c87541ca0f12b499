#include "script/show.hpp"

#include <algorithm>
#include <numbers>
#include <vector>

#include "rotation/text.hpp"
#include "script/interpreter.hpp"

namespace rotor::script {
namespace {

int digits_shown = kFullPrecision;

constexpr std::size_t kWidth = 80;

std::string quoted(const std::string& s) {
  std::string out = "\"";
  for (const char c : s) {
    if (c == '"' || c == '\\') out += '\\';
    if (c == '\n') {
      out += "\\n";
    } else {
      out += c;
    }
  }
  return out + "\"";
}

bool is_name(const std::string& s) {
  return !s.empty() &&
         s.find_first_not_of(
             "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_"
             "0123456789") == s.npos &&
         (s[0] < '0' || s[0] > '9');
}

std::string shown_value(lua_State* L, int index);

// {1, 2, name = 3}: the list first, the rest sorted; what goes past the width is "...". Tables
// within are written in short.
std::string shown_table(lua_State* L, int index) {
  std::vector<std::string> items;
  const auto size = static_cast<lua_Integer>(lua_rawlen(L, index));
  const auto add = [&](const std::string& prefix) {
    items.push_back(prefix +
                    (lua_istable(L, -1) && luaL_getmetafield(L, -1, "__tostring") == LUA_TNIL
                         ? "{...}"
                         : shown_value(L, lua_gettop(L))));
  };
  for (lua_Integer i = 1; i <= size && items.size() < 40; ++i) {
    const int top = lua_gettop(L);
    lua_rawgeti(L, index, i);
    add("");
    lua_settop(L, top);
  }
  std::vector<std::string> list = std::move(items);
  items.clear();
  for (lua_pushnil(L); lua_next(L, index) != 0;) {
    const int top = lua_gettop(L);
    const bool in_list =
        lua_isinteger(L, -2) && lua_tointeger(L, -2) >= 1 && lua_tointeger(L, -2) <= size;
    if (!in_list) {
      const std::string key = lua_type(L, -2) == LUA_TSTRING ? lua_tostring(L, -2) : "";
      add((is_name(key) ? key : "[" + shown_value(L, top - 1) + "]") + " = ");
    }
    lua_settop(L, top - 1);
  }
  std::sort(items.begin(), items.end());
  list.insert(list.end(), items.begin(), items.end());
  std::string text = "{";
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (text.size() + list[i].size() > kWidth - 6) return text + "...}";
    text += list[i] + (i + 1 < list.size() ? ", " : "");
  }
  return text + "}";
}

std::string shown_value(lua_State* L, int index) {
  switch (lua_type(L, index)) {
    case LUA_TNUMBER:
      if (!lua_isinteger(L, index)) return shown(lua_tonumber(L, index));
      break;
    case LUA_TSTRING: {
      std::size_t size = 0;
      const char* s = lua_tolstring(L, index, &size);
      return quoted({s, size});
    }
    case LUA_TTABLE:
      if (luaL_getmetafield(L, index, "__tostring") == LUA_TNIL) return shown_table(L, index);
      lua_pop(L, 1);
      break;
    default:
      break;
  }
  std::size_t size = 0;
  const char* s = luaL_tolstring(L, index, &size);
  std::string text(s, size);
  lua_pop(L, 1);
  return text;
}

}  // namespace

int precision() { return digits_shown; }
void set_precision(int digits) { digits_shown = digits; }

std::string shown(double x) {
  return digits_shown < kFullPrecision ? text(x, digits_shown) : text(x);
}

std::string shown(const Vector& v) {
  return "(" + shown(v.x()) + ", " + shown(v.y()) + ", " + shown(v.z()) + ")";
}

std::string shown_axis_angle(const Vector& axis, double angle, std::size_t indent) {
  const std::string first =
      "angle " + shown(angle) + " rad (" + shown(angle * (180 / std::numbers::pi)) + " deg)";
  const std::string second = "axis " + shown(axis);
  const bool fits = indent + first.size() + 2 + second.size() <= kWidth;
  return first + (fits ? "  " : "\n" + std::string(indent, ' ')) + second;
}

void push_shown(lua_State* L, int index) {
  const std::string text = shown_value(L, lua_absindex(L, index));
  lua_pushlstring(L, text.data(), text.size());
}

}  // namespace rotor::script
