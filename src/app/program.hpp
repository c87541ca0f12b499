// The order of things: LUA_INIT, the options -e -l -W, the script, the terminal; or one of the
// tasks.
#pragma once

#include <lua.hpp>

#include "app/options.hpp"

namespace rotor::app {

class Program {
 public:
  Program(const Options& options, int argc, char** argv)
      : options_(options), argc_(argc), argv_(argv) {}

  /// Does everything and returns the exit status.
  int run(lua_State* L);

 private:
  static int run_protected(lua_State* L);

  // Each returns whether all went well.
  bool run_all();
  bool run_task();
  bool run_init();
  bool prepare();
  bool require(const std::string& argument);
  bool run_script(const char* name);
  bool run_tests();
  bool run_terminal();
  bool print_help_module(const char* function);

  void make_arg_table();
  void sum_up_theorems();
  bool run_chunk(int load_status, int arguments = 0);
  bool run_text(const std::string& text, const char* chunk_name);
  bool checked(bool good);

  const Options& options_;
  int argc_;
  char** argv_;
  lua_State* L_ = nullptr;
  int status_ = 0;
};

}  // namespace rotor::app
