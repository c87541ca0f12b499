// The terminal: reads, runs and shows until the input ends.
#pragma once

#include <lua.hpp>
#include <string>

#include "app/line_reader.hpp"

namespace rotor::app {

class Repl {
 public:
  explicit Repl(lua_State* L);

  void run();

 private:
  /// Takes one more line of input, after a prompt or not, and runs what is complete. These say
  /// whether nothing went wrong.
  bool add(const std::string& text);
  /// Several lines at once are one input if they can be: what is local in them stays known to the
  /// rest. Otherwise they are taken as if they were typed, up to the first that goes wrong. Of a
  /// session with its prompts, what rotor answered is passed over.
  bool add_paste(const std::string& text);
  bool evaluate();
  bool explain();  // "?name"

  void give_up_input();  // the end came in the middle of it
  std::string take_input();
  /// Reports the error on the stack if it was not `good`; an interrupt ends here.
  bool finish(bool good, const std::string& text);

  lua_State* L_;
  LineReader reader_;
  std::string input_;  // the lines so far of an incomplete input
};

/// What the terminal says when it opens.
void print_banner();

}  // namespace rotor::app
