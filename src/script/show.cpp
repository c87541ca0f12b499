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

constexpr int kDepth = 3;           // of tables within tables that are written out
constexpr std::size_t kItems = 20;  // of a table, at most

std::string shown_value(lua_State* L, int index, int depth);

// The items of a table: the list first, then "name = value" sorted; at most kItems and how many
// more.
std::vector<std::string> shown_items(lua_State* L, int index, int depth) {
  std::vector<std::string> list;
  std::vector<std::string> named;
  const auto size = static_cast<lua_Integer>(lua_rawlen(L, index));
  for (lua_Integer i = 1; i <= size && list.size() < kItems; ++i) {
    lua_rawgeti(L, index, i);
    list.push_back(shown_value(L, lua_gettop(L), depth + 1));
    lua_pop(L, 1);
  }
  if (size > static_cast<lua_Integer>(kItems)) {
    list.push_back("... (" + std::to_string(size) + " items)");
  }
  for (lua_pushnil(L); lua_next(L, index) != 0; lua_pop(L, 1)) {
    if (lua_isinteger(L, -2) && lua_tointeger(L, -2) >= 1 && lua_tointeger(L, -2) <= size) continue;
    if (named.size() == kItems) {
      named.emplace_back("...");
      lua_pop(L, 2);
      break;
    }
    const int value = lua_gettop(L);
    const std::string key = lua_type(L, -2) == LUA_TSTRING ? lua_tostring(L, -2) : "";
    const std::string name = is_name(key) ? key : "[" + shown_value(L, value - 1, depth + 1) + "]";
    named.push_back(name + " = " + shown_value(L, value, depth + 1));
  }
  std::sort(named.begin(), named.end());
  list.insert(list.end(), named.begin(), named.end());
  return list;
}

// {1, 2, name = 3} in one line where it fits, else an item a line.
std::string shown_table(lua_State* L, int index, int depth) {
  if (depth == kDepth) return "{...}";
  luaL_checkstack(L, 16, "too many tables within tables");
  const std::vector<std::string> items = shown_items(L, index, depth);
  std::string line = "{";
  std::string lines = "{";
  const std::string indent(2 * static_cast<std::size_t>(depth + 1), ' ');
  for (const std::string& item : items) {
    line += (line.size() > 1 ? ", " : "") + item;
    lines += "\n" + indent;
    for (const char c : item) lines += c == '\n' ? "\n" + indent : std::string(1, c);
    lines += ",";
  }
  line += "}";
  const bool fits = line.find('\n') == line.npos && line.size() + indent.size() <= kWidth;
  return fits ? line : lines + "\n" + indent.substr(2) + "}";
}

std::string shown_value(lua_State* L, int index, int depth) {
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
      if (luaL_getmetafield(L, index, "__tostring") == LUA_TNIL)
        return shown_table(L, index, depth);
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
  const std::string text = shown_value(L, lua_absindex(L, index), 0);
  lua_pushlstring(L, text.data(), text.size());
}

}  // namespace rotor::script
