#include "app/program.hpp"

#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

#include "app/errors.hpp"
#include "app/locale.hpp"
#include "app/repl.hpp"
#include "app/tests_to_run.hpp"
#include "script/interrupt.hpp"
#include "script/lua_value.hpp"

namespace rotor::app {
namespace {

constexpr const char* kInitVariables[] = {"LUA_INIT_" LUA_VERSION_MAJOR "_" LUA_VERSION_MINOR,
                                          "LUA_INIT"};

/// Pushes the arguments of the script, from the table arg as it is now. Returns their number.
int push_script_arguments(lua_State* L) {
  if (lua_getglobal(L, "arg") != LUA_TTABLE) luaL_error(L, "'arg' is not a table");
  const int table = lua_gettop(L);
  const auto count = static_cast<int>(luaL_len(L, table));
  luaL_checkstack(L, count + 3, "too many arguments to script");
  for (int i = 1; i <= count; ++i) lua_rawgeti(L, table, i);
  lua_remove(L, table);
  return count;
}

/// "name", or "global=name".
int require_into_global(lua_State* L) {
  const std::string argument = lua_tostring(L, 1);
  const std::size_t equals = argument.find('=');
  lua_getglobal(L, "require");
  lua_pushstring(L, argument.c_str() + (equals == argument.npos ? 0 : equals + 1));
  lua_call(L, 1, 1);
  lua_setglobal(L, argument.substr(0, equals).c_str());
  return 0;
}

/// Prints what the function of rotor.help, whose name is the argument, returns.
int print_help_page(lua_State* L) {
  script::push_module(L, "rotor.help");
  lua_getfield(L, -1, lua_tostring(L, 1));
  lua_call(L, 0, 1);
  std::size_t size = 0;
  const char* page = luaL_checklstring(L, -1, &size);
  std::fwrite(page, 1, size, stdout);
  return 0;
}

/// Returns whether the theorems of the script all passed; a script without any has not loaded the
/// module.
int finish_theorems(lua_State* L) {
  luaL_getsubtable(L, LUA_REGISTRYINDEX, LUA_LOADED_TABLE);
  if (lua_getfield(L, -1, "rotor.testing") != LUA_TTABLE) {
    lua_pushboolean(L, true);
    return 1;
  }
  lua_getfield(L, -1, "finish");
  lua_call(L, 0, 1);
  return 1;
}

struct Tests {
  std::vector<std::string> files;
  std::string filter;
};

/// Returns whether all passed, and nil or why none was run.
int run_test_files(lua_State* L) {
  const auto& [files, filter] = *static_cast<const Tests*>(lua_touserdata(L, 1));
  script::push_module(L, "rotor.testing");
  lua_getfield(L, -1, "run");
  lua_createtable(L, static_cast<int>(files.size()), 0);
  for (std::size_t i = 0; i < files.size(); ++i) {
    lua_pushlstring(L, files[i].data(), files[i].size());
    lua_rawseti(L, -2, static_cast<lua_Integer>(i + 1));
  }
  if (filter.empty()) {
    lua_pushnil(L);
  } else {
    lua_pushlstring(L, filter.data(), filter.size());
  }
  lua_call(L, 2, 2);
  return 2;
}

}  // namespace

int Program::run(lua_State* L) {
  L_ = L;
  lua_pushcfunction(L, run_protected);
  lua_pushlightuserdata(L, this);
  if (lua_pcall(L, 1, 0, 0) != LUA_OK) checked(false);
  script::unwatch_interrupts();
  return status_;
}

/// Under one protected call, since any call of Lua's can run out of memory.
int Program::run_protected(lua_State* L) {
  auto& program = *static_cast<Program*>(lua_touserdata(L, 1));
  lua_settop(L, 0);
  script::watch_interrupts(L);
  keep_numbers_plain(L);
  program.make_arg_table();
  program.run_all();
  return 0;
}

bool Program::run_all() {
  if (options_.show_version) std::puts(version_text().c_str());
  if (!options_.ignore_environment && !run_init()) return false;
  if (!prepare()) return false;
  if (options_.task != Options::Task::kRun) return run_task();
  if (options_.script != 0 && !run_script(argv_[options_.script])) return false;
  sum_up_theorems();
  if (options_.interactive) return run_terminal();
  if (options_.script != 0 || options_.executes() || options_.show_version) return true;
  if (isatty(STDIN_FILENO)) return run_terminal();
  if (!run_chunk(luaL_loadfile(L_, nullptr))) return false;
  sum_up_theorems();
  return true;
}

bool Program::run_task() {
  switch (options_.task) {
    case Options::Task::kTest:
      return run_tests();
    case Options::Task::kPrintReference:
      return print_help_module("reference");
    case Options::Task::kPrintStub:
      return print_help_module("stub");
    default:
      return true;
  }
}

bool Program::run_init() {
  for (const char* variable : kInitVariables) {
    const char* init = std::getenv(variable);
    if (init == nullptr) continue;
    if (init[0] == '@') return run_chunk(luaL_loadfile(L_, init + 1));
    return run_text(init, variable);
  }
  return true;
}

bool Program::prepare() {
  for (const Preparation& preparation : options_.preparations) {
    switch (preparation.kind) {
      case Preparation::Kind::kExecute:
        if (!run_text(preparation.text, "(command line)")) return false;
        break;
      case Preparation::Kind::kRequire:
        lua_pushcfunction(L_, require_into_global);
        lua_pushstring(L_, preparation.text.c_str());
        if (!checked(call(L_, 1, 0))) return false;
        break;
      case Preparation::Kind::kWarnings:
        lua_warning(L_, "@on", 0);
        break;
    }
  }
  return true;
}

bool Program::run_script(const char* name) {
  // After "--" a script may be called "-".
  const bool standard_input =
      std::string_view(name) == "-" && std::string_view(argv_[options_.script - 1]) != "--";
  const int status = luaL_loadfile(L_, standard_input ? nullptr : name);
  return run_chunk(status, status == LUA_OK ? push_script_arguments(L_) : 0);
}

bool Program::run_tests() {
  Tests tests{{}, options_.filter};
  try {
    tests.files = tests_to_run(options_.tests);
  } catch (const std::exception& error) {
    lua_pushstring(L_, error.what());
    return checked(false);
  }
  lua_pushcfunction(L_, run_test_files);
  lua_pushlightuserdata(L_, &tests);
  if (!checked(call(L_, 1, 2))) return false;
  if (lua_isstring(L_, -1)) return checked(false);
  const bool passed = lua_toboolean(L_, -2);
  lua_pop(L_, 2);
  if (!passed) status_ = EXIT_FAILURE;
  return passed;
}

/// After a script with theorems; one that failed makes the status 1.
void Program::sum_up_theorems() {
  lua_pushcfunction(L_, finish_theorems);
  if (!checked(call(L_, 0, 1))) return;
  if (!lua_toboolean(L_, -1)) status_ = EXIT_FAILURE;
  lua_pop(L_, 1);
}

bool Program::run_terminal() {
  if (!options_.quiet) print_banner();
  Repl(L_).run();
  return true;
}

bool Program::print_help_module(const char* function) {
  lua_pushcfunction(L_, print_help_page);
  lua_pushstring(L_, function);
  return checked(call(L_, 1, 0));
}

void Program::make_arg_table() {
  const int script = options_.script;  // 0, the program's own name, where there is none
  lua_createtable(L_, argc_ - script, script + 1);
  for (int i = 0; i < argc_; ++i) {
    lua_pushstring(L_, argv_[i]);
    lua_rawseti(L_, -2, i - script);
  }
  lua_setglobal(L_, "arg");
}

/// Calls the chunk below its arguments, if loading it went well.
bool Program::run_chunk(int load_status, int arguments) {
  return checked(load_status == LUA_OK && call(L_, arguments, 0));
}

bool Program::run_text(const std::string& text, const char* chunk_name) {
  const std::string name = std::string("=") + chunk_name;
  return run_chunk(luaL_loadbuffer(L_, text.data(), text.size(), name.c_str()));
}

/// Where `good` is false, reports the error on the stack and sets the status.
bool Program::checked(bool good) {
  if (good) return true;
  status_ = script::interrupt_pending() ? script::kInterruptedStatus : EXIT_FAILURE;
  script::clear_interrupt(L_);
  print_error("rotor: " + take_error(L_));
  return false;
}

}  // namespace rotor::app
