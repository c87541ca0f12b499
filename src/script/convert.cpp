#include "script/convert.hpp"

#include "rotation/text.hpp"
#include "script/lua_value.hpp"

namespace rotor::script {
namespace {

// The N numbers of a table {x, y, ...}.
template <int N>
Eigen::Matrix<double, N, 1> numbers_of_table(lua_State* L, int index, const char* expected) {
  if (!lua_istable(L, index) || lua_rawlen(L, index) != N) throw Mismatch(L, index, expected);
  Eigen::Matrix<double, N, 1> v;
  for (int i = 0; i < N; ++i) {
    if (lua_rawgeti(L, index, i + 1) != LUA_TNUMBER) {
      throw Mismatch("expected " + std::string(expected) + ", got one whose item " +
                     std::to_string(i + 1) + " is " + describe(L, -1));
    }
    v(i) = lua_tonumber(L, -1);
    lua_pop(L, 1);
  }
  return v;
}

}  // namespace

Mismatch::Mismatch(lua_State* L, int index, const std::string& expected)
    : std::runtime_error("expected " + expected + ", got " + describe(L, index)) {}

std::string describe(lua_State* L, int index) {
  switch (lua_type(L, index)) {
    case LUA_TNONE:
      return "nothing";
    case LUA_TNUMBER:
      return "number " + (lua_isinteger(L, index) ? std::to_string(lua_tointeger(L, index))
                                                  : text(lua_tonumber(L, index)));
    case LUA_TSTRING: {
      const std::string s = lua_tostring(L, index);
      return "string \"" + (s.size() > 40 ? s.substr(0, 37) + "..." : s) + "\"";
    }
    case LUA_TBOOLEAN:
      return lua_toboolean(L, index) != 0 ? "true" : "false";
    default:
      break;
  }
  if (luaL_getmetafield(L, index, "__name") == LUA_TSTRING) {
    std::string name = lua_tostring(L, -1);
    lua_pop(L, 1);
    return name;
  }
  if (lua_istable(L, index)) {
    return "table of " + std::to_string(lua_rawlen(L, index)) + " items";
  }
  return luaL_typename(L, index);
}

std::string did_you_mean(lua_State* L, const std::string& word, int index) {
  if (!lua_istable(L, index)) return "";
  const StackGuard guard(L);
  index = lua_absindex(L, index);
  push_module(L, "rotor.names");
  lua_getfield(L, -1, "suggest");
  lua_pushstring(L, word.c_str());
  lua_newtable(L);
  lua_Integer count = 0;
  for (lua_pushnil(L); lua_next(L, index) != 0; lua_pop(L, 1)) {
    if (lua_type(L, -2) != LUA_TSTRING) continue;
    lua_pushvalue(L, -2);
    lua_rawseti(L, -4, ++count);
  }
  lua_call(L, 2, 1);
  if (!lua_isstring(L, -1)) return "";
  return std::string("; did you mean '") + lua_tostring(L, -1) + "'?";
}

std::string metatable_key(const char* type) { return std::string("rotor.") + type; }

void require_list(lua_State* L, int index, lua_Unsigned size) {
  index = lua_absindex(L, index);
  const StackGuard guard(L);
  lua_pushnil(L);
  if (size > 0 || lua_next(L, index) == 0) return;
  throw Mismatch("expected a list, got a table with the key " + describe(L, -2));
}

bool is_vector(lua_State* L, int index) {
  if (test_user_value<Vector>(L, index) != nullptr) return true;
  const StackGuard guard(L);
  return lua_istable(L, index) && lua_rawgeti(L, index, 1) == LUA_TNUMBER;
}

Vector Convert<Vector>::get(lua_State* L, int index) {
  if (const Vector* v = test_user_value<Vector>(L, index)) return *v;
  return numbers_of_table<3>(L, lua_absindex(L, index), "a vec or {x, y, z}");
}

Quaternion Convert<Quaternion>::get(lua_State* L, int index) {
  if (const Quaternion* q = test_user_value<Quaternion>(L, index)) return *q;
  const auto c = numbers_of_table<4>(L, lua_absindex(L, index), "a quaternion or {w, x, y, z}");
  return {c(0), c(1), c(2), c(3)};
}

Jet Convert<Jet>::get(lua_State* L, int index) {
  if (const Jet* jet = test_user_value<Jet>(L, index)) return *jet;
  if (lua_type(L, index) != LUA_TNUMBER) throw Mismatch(L, index, "a number or a jet");
  return Jet::constant(lua_tonumber(L, index));
}

Matrix Convert<Matrix>::get(lua_State* L, int index) {
  constexpr const char* kExpected = "a matrix {{a, b, c}, {d, e, f}, {g, h, i}}";
  if (!lua_istable(L, index) || lua_rawlen(L, index) != 3) throw Mismatch(L, index, kExpected);
  Matrix m;
  for (int i = 0; i < 3; ++i) {
    lua_rawgeti(L, index, i + 1);
    m.row(i) = numbers_of_table<3>(L, lua_gettop(L), "a matrix row of three numbers").transpose();
    lua_pop(L, 1);
  }
  return m;
}

void Convert<Matrix>::push(lua_State* L, const Matrix& m) {
  lua_createtable(L, 3, 0);
  for (int i = 0; i < 3; ++i) {
    lua_createtable(L, 3, 0);
    for (int j = 0; j < 3; ++j) {
      lua_pushnumber(L, m(i, j));
      lua_rawseti(L, -2, j + 1);
    }
    lua_rawseti(L, -2, i + 1);
  }
  luaL_setmetatable(L, metatable_key("matrix").c_str());
}

double Convert<double>::get(lua_State* L, int index) {
  if (lua_type(L, index) != LUA_TNUMBER) throw Mismatch(L, index, "a number");
  return lua_tonumber(L, index);
}

bool Convert<bool>::get(lua_State* L, int index) {
  if (!lua_isboolean(L, index)) throw Mismatch(L, index, "true or false");
  return lua_toboolean(L, index) != 0;
}

std::size_t Convert<std::size_t>::get(lua_State* L, int index) {
  int exact = 0;
  const lua_Integer n = lua_tointegerx(L, index, &exact);
  if (lua_type(L, index) != LUA_TNUMBER || exact == 0 || n < 0) {
    throw Mismatch(L, index, "a whole number, 0 or more");
  }
  return static_cast<std::size_t>(n);
}

std::string Convert<std::string>::get(lua_State* L, int index) {
  if (lua_type(L, index) != LUA_TSTRING) throw Mismatch(L, index, "a string");
  std::size_t size = 0;
  const char* s = lua_tolstring(L, index, &size);
  if (std::char_traits<char>::length(s) != size) {
    throw Mismatch("expected a string without NUL, got " + describe(L, index) + " with one");
  }
  return {s, size};
}

}  // namespace rotor::script
