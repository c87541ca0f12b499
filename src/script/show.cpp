#include "script/show.hpp"

#include <algorithm>
#include <numbers>
#include <utility>
#include <vector>

#include "rotation/text.hpp"
#include "script/interpreter.hpp"

namespace rotor::script {
namespace {

int digits_shown = kFullPrecision;

constexpr std::size_t kWidth = 80;
std::size_t room = kWidth;  // columns that a value's own text may take: fewer within a table

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

// The columns that its table takes of an item's lines: the indent, and the comma behind.
std::size_t margin(int depth) { return depth == 0 ? 0 : 2 * static_cast<std::size_t>(depth) + 1; }

// `name` is what stands before the value.
std::string shown_value(lua_State* L, int index, int depth, const std::string& name = "");

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
    named.push_back(shown_value(L, value, depth + 1, name + " = "));
  }
  std::sort(named.begin(), named.end());
  list.insert(list.end(), named.begin(), named.end());
  return list;
}

std::string indented(const std::string& lines) {
  std::string out;
  for (const char c : lines) out += c == '\n' ? "\n  " : std::string(1, c);
  return out;
}

// {1, 2, name = 3} in one line where it fits, else an item a line.
std::string shown_table(lua_State* L, int index, int depth, const std::string& name) {
  if (depth == kDepth) return name + "{...}";
  luaL_checkstack(L, 16, "too many tables within tables");
  const std::vector<std::string> items = shown_items(L, index, depth);
  std::string line = name + "{";
  std::string lines = line;
  for (const std::string& item : items) {
    line += (&item == &items.front() ? "" : ", ") + item;
    lines += indented("\n" + item) + ",";
  }
  line += "}";
  const bool fits = line.find('\n') == line.npos && margin(depth) + line.size() <= kWidth;
  return fits ? line : lines + "\n}";
}

// Gives a value's own text fewer columns, until it goes out of scope: Lua's errors unwind it, too.
class Narrowed {
 public:
  explicit Narrowed(std::size_t columns) : before_(std::exchange(room, columns)) {}
  ~Narrowed() { room = before_; }
  Narrowed(const Narrowed&) = delete;
  Narrowed& operator=(const Narrowed&) = delete;

 private:
  std::size_t before_;
};

std::string shown_value(lua_State* L, int index, int depth, const std::string& name) {
  switch (lua_type(L, index)) {
    case LUA_TNUMBER:
      if (!lua_isinteger(L, index)) return name + shown(lua_tonumber(L, index));
      break;
    case LUA_TSTRING: {
      std::size_t size = 0;
      const char* s = lua_tolstring(L, index, &size);
      return name + quoted({s, size});
    }
    case LUA_TTABLE:
      if (luaL_getmetafield(L, index, "__tostring") == LUA_TNIL)
        return shown_table(L, index, depth, name);
      lua_pop(L, 1);
      break;
    default:
      break;
  }
  const Narrowed narrowed(kWidth - margin(depth) - (name.empty() ? 0 : 2));
  std::size_t size = 0;
  const char* s = luaL_tolstring(L, index, &size);
  std::string text(s, size);
  lua_pop(L, 1);
  const bool fits =
      text.find('\n') == text.npos && margin(depth) + name.size() + text.size() <= kWidth;
  if (name.empty() || fits) return name + text;
  return name.substr(0, name.size() - 1) + indented("\n" + text);
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

std::string shown(const Quaternion& q) {
  const std::string first = "quaternion(" + shown(q.w()) + ",";
  const std::string second = shown(Vector(q.vec())).substr(1);
  if (first.size() + 1 + second.size() <= room) return first + " " + second;
  const std::size_t indent = std::min<std::size_t>(11, room - std::min(room, second.size()));
  return first + "\n" + std::string(indent, ' ') + second;
}

std::string shown_axis_angle(const Vector& axis, double angle, std::size_t indent) {
  const std::string first =
      "angle " + shown(angle) + " rad (" + shown(angle * (180 / std::numbers::pi)) + " deg)";
  std::string second = "axis " + shown(axis);
  if (indent + first.size() + 2 + second.size() <= room) return first + "  " + second;
  // Where it is too wide it is moved to the left, or its last component has a line of its own.
  const bool broken = second.size() > room;
  // Two components of 24 characters, the longest there are, fit into any room.
  const std::size_t width = broken ? second.rfind(' ') : second.size();
  const std::string start = "\n" + std::string(std::min(indent, room - width), ' ');
  if (broken) second.replace(width, 1, start + std::string(6, ' '));
  return first + start + second;
}

void push_shown(lua_State* L, int index) {
  const std::string text = shown_value(L, lua_absindex(L, index), 0);
  lua_pushlstring(L, text.data(), text.size());
}

}  // namespace rotor::script
