#include "script/binding.hpp"

#include <array>
#include <cstdio>
#include <cstring>
#include <string>
#include <string_view>

namespace rotor::script {
namespace {

// Upvalues of every bound function.
constexpr int kEntry = 1;
constexpr int kKind = 2;

const Entry& running_entry(lua_State* L) {
  return *static_cast<const Entry*>(lua_touserdata(L, lua_upvalueindex(kEntry)));
}

std::string_view before_arrow(const Entry& entry) {
  const std::string_view signature = entry.signature;
  return signature.substr(0, signature.find(" ->"));
}

std::string_view result_type(const Entry& entry) {
  const std::string_view signature = entry.signature;
  const auto arrow = signature.find("-> ");
  return arrow == signature.npos ? "nil" : signature.substr(arrow + 3);
}

// What help calls the entry: an operator's name is its use, "R * S".
std::string_view shown_name(const Entry& entry, Kind kind) {
  return kind == Kind::kOperator ? before_arrow(entry) : entry.name;
}

Kind running_kind(lua_State* L) {
  return static_cast<Kind>(lua_tointeger(L, lua_upvalueindex(kKind)));
}

void push_string(lua_State* L, std::string_view s) { lua_pushlstring(L, s.data(), s.size()); }

void set_string(lua_State* L, const char* key, std::string_view value) {
  push_string(L, value);
  lua_setfield(L, -2, key);
}

constexpr std::array kKindNames = {"function", "value", "method", "field", "operator"};

// The row of rotor.entries (at `rows`) for the value on top of the stack.
void add_row(lua_State* L, int rows, const Group& group, const Entry& entry) {
  lua_createtable(L, 0, 8);
  set_string(L, "owner", group.owner);
  set_string(L, "name", shown_name(entry, group.kind));
  set_string(L, "kind", kKindNames[static_cast<std::size_t>(group.kind)]);
  set_string(L, "signature", entry.signature);
  set_string(L, "result", result_type(entry));
  set_string(L, "summary", entry.summary);
  set_string(L, "example", entry.example);
  if (group.kind == Kind::kFunction) {
    lua_pushvalue(L, -2);
    lua_setfield(L, -2, "value");
  }
  lua_rawseti(L, rows, static_cast<lua_Integer>(lua_rawlen(L, rows)) + 1);
}

// value[key] of a type: upvalues methods, fields, the type's name.
int index_user_value(lua_State* L) {
  lua_settop(L, 2);
  lua_pushvalue(L, 2);
  if (lua_rawget(L, lua_upvalueindex(1)) != LUA_TNIL) return 1;
  lua_pushvalue(L, 2);
  if (lua_rawget(L, lua_upvalueindex(2)) != LUA_TNIL) {
    lua_pushvalue(L, 1);
    lua_call(L, 1, 1);
    return 1;
  }
  const char* type = lua_tostring(L, lua_upvalueindex(3));
  if (lua_type(L, 2) == LUA_TNUMBER) {
    // Components, where the type has them: v[1]; nil past the last, so that ipairs ends.
    if (lua_getfield(L, lua_upvalueindex(2), "[i]") == LUA_TNIL) {
      if (lua_istable(L, 1)) return 1;
      return luaL_error(L, "a %s has no numbered components", type);
    }
    lua_pushvalue(L, 1);
    lua_pushvalue(L, 2);
    lua_call(L, 2, 1);
    return 1;
  }
  std::string hint;
  if (lua_type(L, 2) == LUA_TSTRING) {
    hint = did_you_mean(L, lua_tostring(L, 2), lua_upvalueindex(2));
    if (hint.empty()) hint = did_you_mean(L, lua_tostring(L, 2), lua_upvalueindex(1));
  }
  return luaL_error(L, "a %s has no field %s%s", type, luaL_tolstring(L, 2, nullptr), hint.c_str());
}

int refuse_assignment(lua_State* L) {
  luaL_getmetafield(L, 1, "__name");
  return luaL_error(L, "a %s cannot be changed: make a new one", lua_tostring(L, -1));
}

// Pushes the metatable of a type, made at its first use.
void push_metatable(lua_State* L, const char* type) {
  if (luaL_newmetatable(L, metatable_key(type).c_str()) == 0) return;
  set_string(L, "__name", type);
  set_string(L, "__metatable", type);
  lua_newtable(L);
  lua_newtable(L);
  lua_pushvalue(L, -2);
  lua_setfield(L, -4, "methods");
  lua_pushvalue(L, -1);
  lua_setfield(L, -4, "fields");
  push_string(L, type);
  lua_pushcclosure(L, index_user_value, 3);
  lua_setfield(L, -2, "__index");
  lua_pushcfunction(L, refuse_assignment);
  lua_setfield(L, -2, "__newindex");
}

template <class T>
void make_type(lua_State* L) {
  push_metatable(L, UserType<T>::kName);
  if constexpr (!std::is_trivially_destructible_v<T>) {
    lua_pushcfunction(L, ConvertUser<T>::collect);
    lua_setfield(L, -2, "__gc");
  }
  lua_pop(L, 1);
}

int call_constructor(lua_State* L) {
  luaL_checkany(L, 1);
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_replace(L, 1);
  lua_call(L, lua_gettop(L) - 1, LUA_MULTRET);
  return lua_gettop(L);
}

int unknown_function(lua_State* L) {
  const std::string key = luaL_tolstring(L, 2, nullptr);
  return luaL_error(L, "%s has no function '%s'%s", lua_tostring(L, lua_upvalueindex(1)),
                    key.c_str(), did_you_mean(L, key, 1).c_str());
}

// Pushes the global table `name`, made at its first use; a function of that name becomes its call.
void push_global_table(lua_State* L, const char* name) {
  if (lua_getglobal(L, name) == LUA_TTABLE) return;
  lua_newtable(L);
  lua_newtable(L);
  set_string(L, "__metatable", name);
  push_string(L, name);
  lua_pushcclosure(L, unknown_function, 1);
  lua_setfield(L, -2, "__index");
  if (lua_isfunction(L, -3)) {
    lua_pushvalue(L, -3);
    lua_pushcclosure(L, call_constructor, 1);
    lua_setfield(L, -2, "__call");
  }
  lua_setmetatable(L, -2);
  lua_pushvalue(L, -1);
  lua_setglobal(L, name);
  lua_remove(L, -2);
}

// Pushes the table into which the entries of a group go.
void push_owner(lua_State* L, const Group& group) {
  switch (group.kind) {
    case Kind::kFunction:
    case Kind::kValue:
      if (*group.owner == '\0') {
        lua_pushglobaltable(L);
      } else {
        push_global_table(L, group.owner);
      }
      return;
    case Kind::kOperator:
      push_metatable(L, group.owner);
      return;
    default:
      push_metatable(L, group.owner);
      lua_getfield(L, -1, group.kind == Kind::kMethod ? "methods" : "fields");
      lua_remove(L, -2);
  }
}

void register_group(lua_State* L, int rows, const Group& group) {
  push_owner(L, group);
  for (const Entry& entry : group.entries) {
    lua_pushlightuserdata(L, const_cast<Entry*>(&entry));
    lua_pushinteger(L, static_cast<lua_Integer>(group.kind));
    lua_pushcclosure(L, entry.function, 2);
    if (group.kind == Kind::kValue) lua_call(L, 0, 1);
    add_row(L, rows, group, entry);
    lua_setfield(L, -2, entry.name);
  }
  lua_pop(L, 1);
}

}  // namespace

void push_place(lua_State* L) {
  lua_Debug info;
  for (int level = 1; lua_getstack(L, level, &info) != 0; ++level) {
    lua_getinfo(L, "Sl", &info);
    if (info.currentline > 0) {
      lua_pushfstring(L, "%s:%d: ", info.short_src, info.currentline);
      return;
    }
  }
  lua_pushliteral(L, "");
}

void push_error_message(lua_State* L, const char* what) {
  const std::string_view name = shown_name(running_entry(L), running_kind(L));
  push_place(L);
  // The core names its functions itself, where it knows.
  if (!std::string_view(what).starts_with(std::string(name) + ":")) {
    push_string(L, name);
    lua_pushliteral(L, ": ");
    lua_concat(L, 3);
  }
  lua_pushstring(L, what);
  lua_concat(L, 2);
}

void warn(lua_State* L, const std::string& what) {
  push_error_message(L, what.c_str());
  std::fprintf(stderr, "rotor: %s\n", lua_tostring(L, -1));
  std::fflush(stderr);
  lua_pop(L, 1);
}

void throw_bad_argument(lua_State* L, int index, const std::exception& mismatch) {
  const Kind kind = running_kind(L);
  std::string where;
  if (kind == Kind::kFunction || kind == Kind::kMethod) {
    const int number = kind == Kind::kMethod ? index - 1 : index;
    where = number == 0 ? "before the colon: " : "argument " + std::to_string(number) + ": ";
  }
  throw std::invalid_argument(where + mismatch.what() +
                              "; usage: " + std::string(running_entry(L).signature));
}

Results push_component(lua_State* L, const double* first, lua_Integer n) {
  const lua_Integer i = lua_tointeger(L, 2);
  if (i >= 1 && i <= n) {
    lua_pushnumber(L, first[i - 1]);
  } else {
    lua_pushnil(L);
  }
  return {1};
}

void refuse_more_arguments(lua_State* L, int count) {
  const Kind kind = running_kind(L);
  if ((kind != Kind::kFunction && kind != Kind::kMethod) || lua_isnoneornil(L, count + 1)) return;
  throw std::invalid_argument("one argument too many, " + describe(L, count + 1) +
                              "; usage: " + running_entry(L).signature);
}

void register_groups(lua_State* L) {
  make_type<Vector>(L);
  make_type<Rotation>(L);
  make_type<Quaternion>(L);
  make_type<Chain>(L);
  make_type<SharedRun>(L);
  make_type<RunState>(L);
  make_type<Crossing>(L);
  make_type<SharedPoints>(L);
  make_type<Cost>(L);
  make_type<Certificate>(L);
  make_type<SharedRecurrence>(L);
  make_type<LyapunovResult>(L);
  make_type<SignalSpectrum>(L);
  make_type<NamedFrequencies>(L);
  make_type<RigidFit>(L);
  make_type<RotationRates>(L);
  make_type<Spline>(L);
  make_type<SphericalTriangle>(L);
  make_type<AngularVelocity>(L);
  make_type<Jet>(L);

  lua_newtable(L);
  const int rows = lua_gettop(L);
  for (const auto groups :
       {rotation_groups(),   vector_groups(),     matrix_groups(),   quaternion_groups(),
        sequence_groups(),   kinematics_groups(), fit_groups(),      triangle_groups(),
        list_groups(),       spin_groups(),       run_groups(),      crossing_groups(),
        points_groups(),     certify_groups(),    lyapunov_groups(), spectrum_groups(),
        recurrence_groups(), plot_groups(),       jet_groups(),      terminal_groups()}) {
    for (const Group& group : groups) register_group(L, rows, group);
  }
  luaL_getsubtable(L, LUA_REGISTRYINDEX, LUA_LOADED_TABLE);
  lua_insert(L, rows);
  lua_setfield(L, rows, "rotor.entries");
  lua_pop(L, 1);
}

}  // namespace rotor::script
