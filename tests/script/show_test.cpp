// What the terminal shows fits into its 80 columns.
#include <algorithm>
#include <lua.hpp>
#include <sstream>
#include <string>

#include "catch.hpp"
#include "script/interpreter.hpp"

using namespace rotor::script;

namespace {

std::string shown_by_terminal(const std::string& expression) {
  const State state = make_state();
  lua_State* L = state.get();
  REQUIRE(luaL_dostring(L, ("return " + expression).c_str()) == LUA_OK);
  push_shown(L, -1);
  return lua_tostring(L, -1);
}

std::size_t widest(const std::string& text) {
  std::istringstream lines(text);
  std::size_t widest = 0;
  for (std::string line; std::getline(lines, line);) widest = std::max(widest, line.size());
  return widest;
}

}  // namespace

TEST_CASE("Show: rotations in tables of any depth fit into 80 columns") {
  for (const char* expression :
       {"rotation.random(1, 40)", "rotation.random(1).quaternion",
        "{{rotation.random(1).quaternion}}", "quaternion(-1/3, -2e-300/3, -2e-300/3, -2e-300/3)",
        "{rotation.random(2, 40)}", "{{rotation.random(3, 40)}}",
        "{body_to_space = rotation.random(4), list = {first_of_them = rotation.random(5)}}",
        // Components of 24 characters: the widest there are.
        "rotation({-1, -1.2345678901234567e-300, -1.2345678901234567e-300}, -1/3)",
        "{{rotation({-1/3, -1.2345678901234567e-300, -1.2345678901234567e-300}, -1/3)}}",
        // Each short enough for one line but for the name.
        "{first = rotation({0, 0.6, 0.8}, 0.1234567), another_name = rotation({0, 1, 0}, 0.75)}",
        "{a_name_before_a_list = {0.123456789, 0.123456789, 0.123456789, 0.123456789, 0.12}}"}) {
    CAPTURE(expression);
    const std::string text = shown_by_terminal(expression);
    INFO(text);
    CHECK(widest(text) <= 80);
  }
}

TEST_CASE("Show: a rotation has one line or two, and the axis stands below the angle") {
  CHECK(shown_by_terminal("{rotation({0, 0, 1}, 1)}") ==
        "{rotation  angle 1.0 rad (57.29577951308232 deg)  axis (0.0, 0.0, 1.0)}");
  CHECK(shown_by_terminal("{rotation({0, 0, 1}, 1), 2}") ==
        "{rotation  angle 1.0 rad (57.29577951308232 deg)  axis (0.0, 0.0, 1.0), 2}");
  CHECK(shown_by_terminal("{rotation({0, 0.6, 0.8}, 1/3), R = rotation({0, 0.6, 0.8}, 1/3), "
                          "{{rotation({0, 0.6, 0.8}, 1/3)}}}") ==
        "{\n"
        "  rotation  angle 0.3333333333333333 rad (19.09859317102744 deg)\n"
        "            axis (0.0, 0.6, 0.8),\n"
        "  {\n"
        "    {\n"
        "      rotation  angle 0.3333333333333333 rad (19.09859317102744 deg)\n"
        "                axis (0.0, 0.6, 0.8),\n"
        "    },\n"
        "  },\n"
        "  R =\n"
        "    rotation  angle 0.3333333333333333 rad (19.09859317102744 deg)\n"
        "              axis (0.0, 0.6, 0.8),\n"
        "}");
}

TEST_CASE("Show: an error in a __tostring is passed on, and the room is as before") {
  const State state = make_state();
  lua_State* L = state.get();
  const std::string wide = "rotation  angle 1.0 rad (57.29577951308232 deg)  axis (0.0, 0.0, 1.0)";
  lua_pushcfunction(L, [](lua_State* own) {
    REQUIRE(luaL_dostring(own,
                          "return {[('x'):rep(70)] = setmetatable({}, {__tostring = "
                          "function() error('no', 0) end})}") == LUA_OK);
    push_shown(own, -1);
    return 1;
  });
  CHECK(lua_pcall(L, 0, 1, 0) == LUA_ERRRUN);
  CHECK(lua_tostring(L, -1) == std::string("no"));
  REQUIRE(luaL_dostring(L, "return tostring(rotation({0, 0, 1}, 1))") == LUA_OK);
  CHECK(lua_tostring(L, -1) == wide);
}
