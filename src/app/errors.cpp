#include "app/errors.hpp"

#include <cstdio>
#include <sstream>

#include "script/interpreter.hpp"

namespace rotor::app {
namespace {

constexpr std::string_view kTraceback = "\nstack traceback:\n";
constexpr std::string_view kInput = "stdin:";  // how Lua names what was typed

int push_error_text(lua_State* L) {
  if (lua_isstring(L, 1)) return 1;  // or a number
  if (luaL_callmeta(L, 1, "__tostring") && lua_type(L, -1) == LUA_TSTRING) return 1;
  lua_pushfstring(L, "(error object is a %s value)", luaL_typename(L, 1));
  return 1;
}

/// The length of a leading "stdin:12: ", or 0.
std::size_t leading_place(const std::string& message) {
  if (!message.starts_with(kInput)) return 0;
  const std::size_t after = message.find_first_not_of("0123456789", kInput.size());
  return after != message.npos && message.compare(after, 2, ": ") == 0 ? after + 2 : 0;
}

/// Whether a frame of a traceback is Lua code with a place.
bool leads_further(std::string_view frame) {
  return frame.find("[C]:") == frame.npos && frame.find("(...tail calls...)") == frame.npos;
}

/// The frames above the input, or nothing when none of them leads further. Those of what was typed
/// are named by their line alone.
std::string trim_traceback(const std::string& traceback) {
  std::string kept;
  bool further = false;
  std::istringstream frames(traceback);
  for (std::string frame; std::getline(frames, frame);) {
    if (frame == "\t[C]: in ?" || frame == "\t[C]: in function 'error'") continue;
    if (frame.ends_with("in main chunk") && frame.find(kInput) != frame.npos) continue;
    further = further || leads_further(frame);
    for (std::size_t at; (at = frame.find(kInput)) != frame.npos;) {
      frame.replace(at, kInput.size(), "line ");
    }
    kept += "\n" + frame;
  }
  return further ? kept : "";
}

}  // namespace

bool call(lua_State* L, int arguments, int results) {
  const int handler = lua_gettop(L) - arguments;
  lua_pushcfunction(L, script::add_traceback);
  lua_insert(L, handler);
  const int status = lua_pcall(L, arguments, results, handler);
  lua_remove(L, handler);
  return status == LUA_OK;
}

std::string take_error(lua_State* L) {
  lua_pushcfunction(L, push_error_text);
  lua_insert(L, -2);
  std::string text = "(error object whose __tostring fails)";
  if (lua_pcall(L, 1, 1, 0) == LUA_OK) {
    std::size_t size = 0;
    const char* data = lua_tolstring(L, -1, &size);
    text.assign(data, size);
  }
  lua_pop(L, 1);
  return text;
}

std::string for_the_prompt(const std::string& error, bool several_lines) {
  const std::size_t end = error.rfind(kTraceback);
  std::string message = error.substr(0, end);
  std::string line = "1";
  while (const std::size_t place = leading_place(message)) {  // coroutine.wrap adds a second one
    line = message.substr(kInput.size(), place - kInput.size() - 2);
    message.erase(0, place);
  }
  if (several_lines || line != "1") message += " (line " + line + ")";
  if (end == error.npos) return message;
  const std::string frames = trim_traceback(error.substr(end + kTraceback.size()));
  return frames.empty() ? message : message + "\nstack traceback:" + frames;
}

void print_error(std::string_view message) {
  std::fflush(stdout);
  std::fwrite(message.data(), 1, message.size(), stderr);
  std::fputc('\n', stderr);
}

}  // namespace rotor::app
