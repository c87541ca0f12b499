#include "app/repl.hpp"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "app/completion.hpp"
#include "app/errors.hpp"
#include "app/input.hpp"
#include "app/options.hpp"
#include "script/interpreter.hpp"
#include "script/interrupt.hpp"
#include "script/lua_value.hpp"

namespace rotor::app {
namespace {

constexpr const char* kPrompt = "rotor> ";
constexpr const char* kContinuationPrompt = "   ..> ";
constexpr std::string_view kPrompts[] = {"rotor> ", "..> "};  // without indent
constexpr const char* kSpace = " \t\r";

std::string without_indent(const std::string& text) {
  return text.substr(std::min(text.find_first_not_of(kSpace), text.size()));
}

/// The length of the prompt, indented or not, that a line from a session or from help begins with.
std::size_t leading_prompt(const std::string& line) {
  const std::size_t indent = std::min(line.find_first_not_of(kSpace), line.size());
  for (const std::string_view prompt : kPrompts) {
    if (line.compare(indent, prompt.size(), prompt) == 0) return indent + prompt.size();
    // An editor may have cut the space after a bare prompt.
    if (line.substr(indent) + ' ' == prompt) return line.size();
  }
  return 0;
}

/// The type of a global, past any metamethods that a script gave to _G.
int type_of_global(lua_State* L, const char* name) {
  lua_pushglobaltable(L);
  lua_pushstring(L, name);
  const int type = lua_rawget(L, -2);
  lua_pop(L, 2);
  return type;
}

/// Past any metamethods that a script gave to _G.
void set_answer(lua_State* L, int index) {
  lua_pushvalue(L, index);
  lua_pushglobaltable(L);
  lua_insert(L, -2);
  lua_pushliteral(L, "ans");
  lua_insert(L, -2);
  lua_rawset(L, -3);
  lua_pop(L, 1);
}

/// Its arguments are the values of an input: prints them and keeps the first as the answer.
int show_values(lua_State* L) {
  const int count = lua_gettop(L);
  if (count == 0) return 0;
  luaL_checkstack(L, LUA_MINSTACK, "too many values to show");
  if (!lua_isnil(L, 1)) set_answer(L, 1);
  std::vector<std::string> texts;
  bool several_lines = false;
  for (int i = 1; i <= count; ++i) {
    script::push_shown(L, i);
    std::size_t size = 0;
    const char* data = lua_tolstring(L, -1, &size);
    texts.emplace_back(data, size);
    several_lines = several_lines || texts.back().find('\n') != std::string::npos;
    lua_pop(L, 1);
  }
  std::string shown;
  for (const std::string& text : texts) {
    if (!shown.empty()) shown += several_lines ? "\n" : ", ";
    shown += text;
  }
  shown += '\n';
  std::fwrite(shown.data(), 1, shown.size(), stdout);
  return 0;
}

/// An error object with .run, the run up to where evolve stopped: keeps it as the answer and
/// returns its time in words, else nil.
int keep_partial_run(lua_State* L) {
  lua_getfield(L, 1, "reason");
  lua_getfield(L, 1, "run");
  if (lua_isnil(L, -1) || lua_isnil(L, -2)) return 0;
  set_answer(L, -1);
  lua_getfield(L, 1, "t");
  script::push_shown(L, -1);
  return 1;
}

/// The time up to which the partial run of the error value on top goes, or "" when it has none.
std::string partial_run_time(lua_State* L) {
  if (!lua_istable(L, -1) && !lua_isuserdata(L, -1)) return "";
  lua_pushcfunction(L, keep_partial_run);
  lua_pushvalue(L, -2);
  std::string time;
  if (call(L, 1, 1) && lua_isstring(L, -1)) time = lua_tostring(L, -1);
  lua_pop(L, 1);
  return time;
}

int call_help(lua_State* L) {
  const char* name = lua_tostring(L, 1);
  script::push_module(L, "rotor.help");
  if (*name == '\0') {
    lua_call(L, 0, 0);
  } else {
    lua_pushvalue(L, 1);
    lua_call(L, 1, 0);
  }
  return 0;
}

}  // namespace

void print_banner() {
  std::printf("%s   ? help   ?name about a name   Ctrl-D quit\n%s\n", version_text().c_str(),
              "radians (or 30*deg)  quaternions (w,x,y,z)  active rotations  space-frame omega");
}

Repl::Repl(lua_State* L)
    : L_(L), reader_([L](const std::string& line, std::size_t cursor) {
        return complete(L, line, cursor);
      }) {
  // A pipe that a script opened may break without taking the session with it. Not SIG_IGN: the
  // commands that a script runs would inherit it.
  if (reader_.on_terminal()) std::signal(SIGPIPE, [](int) {});
}

void Repl::run() {
  for (;;) {
    std::string line;
    switch (reader_.read(input_.empty() ? kPrompt : kContinuationPrompt, line)) {
      case LineReader::Event::kInterrupted:
        script::clear_interrupt(L_);
        input_.clear();
        break;
      case LineReader::Event::kEnd:
        std::fputs("\n", stdout);
        if (input_.empty()) return;
        give_up_input();
        break;
      case LineReader::Event::kLine:
        line.find('\n') == line.npos ? add(line) : add_paste(line);
        break;
    }
  }
}

bool Repl::add(const std::string& text) {
  const std::string line = text.substr(leading_prompt(text));
  if (!input_.empty()) {
    input_ += "\n" + line;
    return evaluate();
  }
  input_ = without_indent(line);
  if (input_.empty()) return true;
  if (input_[0] == '?') return explain();
  const std::string word = input_.substr(0, input_.find_last_not_of(kSpace) + 1);
  if ((word == "quit" || word == "exit") && type_of_global(L_, word.c_str()) == LUA_TNIL) {
    std::puts("Ctrl-D quits");
    take_input();
    return true;
  }
  if (word == "help" && type_of_global(L_, "help") == LUA_TFUNCTION) input_ = "help()";
  return evaluate();
}

bool Repl::add_paste(const std::string& text) {
  const bool session = leading_prompt(text) > 0;
  bool one_input = !session;
  if (one_input && input_.empty()) {
    one_input = compile_input(L_, without_indent(text)) != Input::kWrong;
    lua_pop(L_, 1);
  }
  if (one_input) return add(text);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const bool answer = session && input_.empty() && leading_prompt(line) == 0;
    if (!answer && !add(line)) return false;
  }
  return true;
}

bool Repl::evaluate() {
  const int function = lua_gettop(L_) + 1;
  const Input input = compile_input(L_, input_);
  if (input == Input::kIncomplete) {
    lua_pop(L_, 1);
    return true;
  }
  const std::string text = take_input();
  bool good = input == Input::kComplete && call(L_, 0, LUA_MULTRET);
  if (good) {
    lua_pushcfunction(L_, show_values);
    lua_insert(L_, function);
    good = call(L_, lua_gettop(L_) - function, 0);
  }
  return finish(good, text);
}

bool Repl::explain() {
  const std::string text = take_input();
  const std::size_t last = text.find_last_not_of(kSpace);
  const std::size_t first = std::min(text.find_first_not_of(kSpace, 1), last + 1);
  lua_pushcfunction(L_, call_help);
  lua_pushlstring(L_, text.data() + first, last + 1 - first);
  return finish(call(L_, 1, 0), text);
}

void Repl::give_up_input() {
  compile_input(L_, input_);
  finish(false, take_input());
}

/// Kept before it runs, so that an input that brings everything down can be recalled.
std::string Repl::take_input() {
  reader_.remember(input_);
  return std::exchange(input_, {});
}

bool Repl::finish(bool good, const std::string& text) {
  const bool interrupted = script::interrupt_pending();
  script::clear_interrupt(L_);
  if (good) return true;
  const std::string time = partial_run_time(L_);
  const bool several_lines = text.find('\n') != text.npos;
  const std::string error = for_the_prompt(take_error(L_), several_lines);
  if (interrupted && reader_.on_terminal()) std::fputs("\n", stdout);  // after the echo of ^C
  print_error_at_prompt(interrupted && time.empty() ? "interrupted" : error);
  if (!time.empty()) print_error_at_prompt("the run up to t = " + time + " is in ans");
  return false;
}

}  // namespace rotor::app
