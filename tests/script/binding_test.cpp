// The two crossings between C++ and Lua, and the tables of entries.
#include "script/binding.hpp"

#include <stdexcept>
#include <string>

#include "catch.hpp"
#include "script/interpreter.hpp"
#include "script/options.hpp"

using namespace rotor::script;
using rotor::Rotation;
using rotor::Vector;

namespace {

struct Counted {
  static inline int alive = 0;
  Counted() { ++alive; }
  ~Counted() { --alive; }
  Counted(const Counted&) = delete;
  Counted& operator=(const Counted&) = delete;
};

double raises_lua_error(double) {
  const Counted local;
  return luaL_error(current_state(), "from Lua's own code");
}
double throws(double) {
  const Counted local;
  throw std::runtime_error("from C++");
}
double calls_back(double x) {
  const Counted local;
  lua_State* L = current_state();
  const StackGuard guard(L);
  lua_getglobal(L, "back");
  lua_pushnumber(L, x);
  lua_call(L, 1, 1);
  return lua_tonumber(L, -1);
}
double sum(double a, const Vector& v, const Rotation& r) { return a + v.sum() + r.angle(); }

constexpr const char* kOptions = "options_of{first=, second=}";
Results options_of(lua_State* L) {
  const Options options(L, 1, kOptions);
  lua_pushnumber(L, options.get<double>("first").value_or(-1));
  return {1};
}

constexpr Entry kEntries[] = {
    {"raises_lua_error", bound<raises_lua_error>, "raises_lua_error(x)", "", ""},
    {"throws", bound<throws>, "throws(x)", "", ""},
    {"calls_back", bound<calls_back>, "calls_back(x)", "", ""},
    {"sum", bound<sum>, "sum(a, v, R) -> number", "", ""},
    {"options_of", bound<options_of>, kOptions, "", ""},
};

// A rotor state with the functions above as globals.
class Fixture {
 public:
  Fixture() {
    for (const Entry& entry : kEntries) {
      lua_pushlightuserdata(L(), const_cast<Entry*>(&entry));
      lua_pushinteger(L(), static_cast<lua_Integer>(Kind::kFunction));
      lua_pushcclosure(L(), entry.function, 2);
      lua_setglobal(L(), entry.name);
    }
  }
  lua_State* L() { return state_.get(); }

  // What the chunk returns, as the terminal shows it.
  std::string run(const std::string& chunk) {
    lua_settop(L(), 0);
    INFO(chunk);
    if (luaL_loadbuffer(L(), chunk.data(), chunk.size(), "=test") != LUA_OK ||
        lua_pcall(L(), 0, LUA_MULTRET, 0) != LUA_OK) {
      return std::string("error: ") + luaL_tolstring(L(), -1, nullptr);
    }
    if (lua_gettop(L()) == 0) return "";
    push_shown(L(), 1);
    return lua_tostring(L(), -1);
  }

 private:
  State state_ = make_state();
};

}  // namespace

TEST_CASE("Destructors run when an error of Lua or an exception passes") {
  Fixture lua;
  // raises_lua_error asks for the state that `bound` made current.
  CHECK(lua.run("return select('#', pcall(raises_lua_error, 1))") == "2");
  CHECK(Counted::alive == 0);
  CHECK(lua.run("local ok, m = pcall(throws, 1) return m") == "\"test:1: throws: from C++\"");
  CHECK(Counted::alive == 0);
  CHECK(lua.run("back = function(x) error('in the script') end "
                "local ok, m = pcall(calls_back, 1) return m") == "\"test:1: in the script\"");
  CHECK(Counted::alive == 0);
  CHECK(lua.run("back = function(x) return 2*x end return calls_back(21)") == "42.0");
}

TEST_CASE("No exception escapes a bound function: pcall sees an error with a message") {
  Fixture lua;
  lua_State* L = lua.L();
  lua_settop(L, 0);
  lua_getglobal(L, "throws");
  lua_pushnumber(L, 1);
  // -1 would be the status of a C++ exception that Lua caught.
  CHECK(lua_pcall(L, 1, 0, 0) == LUA_ERRRUN);
  CHECK(std::string(lua_tostring(L, -1)) == "throws: from C++");
}

TEST_CASE("Bad arguments are named with what was expected, what came and the usage") {
  Fixture lua;
  CHECK(lua.run("return sum(1, {1, 2, 3}, rotation.identity)") == "7.0");
  CHECK(lua.run("return sum('1', {1, 2, 3}, rotation.identity)") ==
        "error: test:1: sum: argument 1: expected a number, got string \"1\"; usage: sum(a, v, R) "
        "-> number");
  CHECK(lua.run("return sum(1, {1, 2}, rotation.identity)") ==
        "error: test:1: sum: argument 2: expected a vec or {x, y, z}, got table of 2 items; usage: "
        "sum(a, v, R) -> number");
  CHECK(lua.run("return sum(1, {1, 2, 'x'}, rotation.identity)") ==
        "error: test:1: sum: argument 2: expected a vec or {x, y, z}, got one whose item 3 is "
        "string \"x\"; "
        "usage: sum(a, v, R) -> number");
  CHECK(lua.run("return sum(1, {1, 2, 3})") ==
        "error: test:1: sum: argument 3: expected a rotation, got nothing; usage: sum(a, v, R) -> "
        "number");
  CHECK(lua.run("local R = rotation.identity return R.inverse()") ==
        "error: test:1: inverse: before the colon: expected a rotation, got nothing; usage: "
        "R:inverse() -> rotation");
}

TEST_CASE("Options tables refuse unknown keys, with a hint where there is one") {
  Fixture lua;
  CHECK(lua.run("return options_of{first = 3}") == "3.0");
  CHECK(lua.run("return options_of()") == "-1.0");
  CHECK(lua.run("return options_of{frist = 3}") ==
        "error: test:1: options_of: unknown option 'frist'; did you mean 'first'?");
  CHECK(lua.run("return options_of{quite_other = 3}") ==
        "error: test:1: options_of: unknown option 'quite_other'; usage: options_of{first=, "
        "second=}");
  CHECK(lua.run("return options_of{3}") ==
        "error: test:1: options_of: options are named, {key = value}, got a list; usage: "
        "options_of{first=, second=}");
  CHECK(lua.run("return options_of{first = {}}") ==
        "error: test:1: options_of: first: expected a number, got table of 0 items");
  CHECK(lua.run("return options_of(3)") ==
        "error: test:1: options_of: expected options in braces, got number 3; usage: "
        "options_of{first=, second=}");
}

TEST_CASE("Values cannot be changed, and unknown fields are errors") {
  Fixture lua;
  CHECK(lua.run("local v = vec(1, 2, 3) v.x = 2") ==
        "error: test:1: a vec cannot be changed: make a new one");
  CHECK(lua.run("return rotation.identity.angel") ==
        "error: test:1: a rotation has no field angel; did you mean 'angle'?");
  CHECK(lua.run("return rotation.identity[1]") ==
        "error: test:1: a rotation has no numbered components");
  CHECK(lua.run("local n = 0 for i, x in ipairs(vec(1, 2, 3)) do n = n + i*x end return n") ==
        "14.0");
  CHECK(lua.run("return getmetatable(vec(1, 2, 3))") == "\"vec\"");
}

TEST_CASE("The example of every entry shows what it says") {
  Fixture lua;
  lua_State* L = lua.L();
  lua_settop(L, 0);
  push_module(L, "rotor.entries");
  const auto count = lua_rawlen(L, 1);
  CHECK(count > 80);
  for (lua_Unsigned i = 1; i <= count; ++i) {
    lua_settop(L, 1);
    push_module(L, "rotor.entries");
    lua_rawgeti(L, -1, static_cast<lua_Integer>(i));
    lua_getfield(L, -1, "name");
    lua_getfield(L, -2, "example");
    const std::string name = lua_tostring(L, -2);
    const std::string example = lua_tostring(L, -1);
    INFO(name << ": " << example);
    const auto arrow = example.rfind(" --> ");
    if (arrow == example.npos) continue;  // rows whose example prints
    CHECK(lua.run("return " + example.substr(0, arrow)) == example.substr(arrow + 5));
    push_module(L, "rotor.entries");
    lua_insert(L, 1);
  }
}

TEST_CASE("Every entry says what it is") {
  Fixture lua;
  CHECK(lua.run(R"(
    local lacking = {}
    for _, row in ipairs(require "rotor.entries") do
      if row.summary == "" or row.signature == "" or row.example == "" then
        lacking[#lacking + 1] = row.name
      end
    end
    return #lacking)") == "0");
}

TEST_CASE("What a scripted omega can do wrong, and how it is said") {
  Fixture lua;
  const auto stop = [&](const std::string& omega, const std::string& field) {
    return lua.run("local ok, stop = pcall(evolve, {omega = " + omega + ", to = 2}) return stop." +
                   field);
  };
  CHECK(stop("function(t) if t > 1 then return 1, 2 end return 0, 0, 1 end", "reason") ==
        "\"omega failed\"");
  CHECK(
      stop("function(t) return 1, 2 end", "message") ==
      "\"test:1: evolve: stopped at t = 0.0 of 0.0 .. 2.0: omega (function at test:1) at t = 0.0: "
      "expected three "
      "numbers, a table {x, y, z} or a vec, got number 1, number 2\"");
  CHECK(stop("function(t) return 'abc' end", "message").find("got string \\\"abc\\\"") !=
        std::string::npos);
  CHECK(stop("function(t) end", "message").find("got nothing") != std::string::npos);
  CHECK(stop("function(t) return {1, 2} end", "message").find("got table of 2 items") !=
        std::string::npos);
  CHECK(
      stop("function(t) return 1, 0/0, 3 end", "message").find("gave (1.0, nan, 3.0) at t = 0.0") !=
      std::string::npos);
  CHECK(stop("function(t) return 1, 1/0, 3 end", "message").find("gave (1.0, inf, 3.0)") !=
        std::string::npos);
  CHECK(stop("function(t) error{code = 7} end", "cause.code") == "7");
  CHECK(stop("function(t) error('mine') end", "cause").find("test:1: mine\\nstack traceback:") !=
        std::string::npos);
  // The partial run is a run: it has the states up to where it stopped.
  CHECK(
      lua.run("local ok, stop = pcall(evolve, {omega = function(t) if t > 1 then error 'late' end "
              "return 0, 0, 1 end, to = 2}) "
              "return not stop.run.complete and stop.t > 0 and stop.run.t1 == stop.t and "
              "math.abs(stop.run(stop.t).angle - stop.t) < 1e-10") == "true");
}

TEST_CASE("omega runs in the coroutine that called, and may return tables and vecs") {
  Fixture lua;
  CHECK(lua.run("return coroutine.wrap(function() return evolve{omega = function(t) return {0, 0, "
                "1} end, "
                "to = 1, accuracy = 1e-12}(1).axis end)()") == "vec(0.0, 0.0, 1.0)");
  CHECK(lua.run("local run = coroutine.wrap(function() return evolve{omega = function(t) "
                "return vec(0, 0, t) end, to = 1} end)() collectgarbage() return run(0.5).omega") ==
        "vec(0.0, 0.0, 0.5)");
}

TEST_CASE("Numbers are shown at the precision asked for") {
  Fixture lua;
  CHECK(lua.run("precision(3) return 2/3") == "0.667");
  CHECK(lua.run("return vec(1/3, 2, 1e-9)") == "vec(0.333, 2.0, 1e-09)");
  CHECK(lua.run("return precision()") == "3");
  CHECK(lua.run("precision(17) return 2/3") == "0.6666666666666666");
  CHECK(lua.run("precision(18)") == "error: test:1: precision: expected 1 to 17 digits, got 18");
}

TEST_CASE("A value that was collected in the same cycle as its user is none any more") {
  Fixture lua;
  CHECK(lua.run(R"(
    local seen = {}
    local E = {}
    E.__gc = function(o) seen[#seen + 1] = select(2, pcall(function() return o.run.t1 end)) end
    for i = 1, 20 do
      local o = setmetatable({}, E)
      o.run = evolve{omega = function() return 0, 0, 1 end, to = 1}
    end
    collectgarbage()
    collectgarbage()
    for _, s in ipairs(seen) do
      if s ~= 1.0 and not tostring(s):find("userdata") then return s end
    end
    return #seen > 0)") == "true");
}

TEST_CASE("Tables and functions behind the values cannot be turned against them") {
  Fixture lua;
  CHECK(lua.run("return getmetatable(rotation)") == "\"rotation\"");
  CHECK(lua.run("local m = debug.getmetatable(rotation) return pcall(m.__index, 1, 'x')") ==
        "false");
  CHECK(lua.run("local m = debug.getmetatable(rotation) return pcall(m.__call)") == "false");
  CHECK(lua.run("local run = evolve{omega = {0, 0, 1}, to = 1} "
                "return pcall(debug.getmetatable(run).__gc, 'x')") == "true");
}

TEST_CASE("A short run is sampled within itself, and files have names") {
  Fixture lua;
  CHECK(
      lua.run(
          "return #evolve{omega = function() return 0, 0, 1 end, t = {0.1, 0.1}}:sample{n = 7}") ==
      "7");
  CHECK(lua.run("return select(2, pcall(function() evolve{omega = {0, 0, 1}, to = 1}:csv('') end))")
            .find("the file name is empty") != std::string::npos);
  CHECK(lua.run("return select(2, pcall(function() evolve{omega = {0, 0, 1}, to = 1}:csv('a\\0b') "
                "end))")
            .find("without NUL") != std::string::npos);
}
