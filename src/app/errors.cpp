#include "app/errors.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <sstream>
#include <vector>

#include "script/convert.hpp"
#include "script/embedded_lua.hpp"
#include "script/interpreter.hpp"

namespace rotor::app {
namespace {

constexpr std::string_view kTraceback = "\nstack traceback:\n";
constexpr std::string_view kTailCalls = "\t(...tail calls...)";
constexpr std::string_view kInput = "stdin:";  // how Lua names what was typed

int push_error_text(lua_State* L) {
  if (lua_isstring(L, 1)) return 1;  // or a number
  if (luaL_callmeta(L, 1, "__tostring") && lua_type(L, -1) == LUA_TSTRING) return 1;
  lua_pushfstring(L, "(error object is a %s value)", luaL_typename(L, 1));
  return 1;
}

/// The argument is the name of a global that is not there.
int push_suggestion(lua_State* L) {
  lua_pushglobaltable(L);
  const std::string suggestion = script::did_you_mean(L, lua_tostring(L, 1), -1);
  lua_pushlstring(L, suggestion.data(), suggestion.size());
  return 1;
}

void suggest_global(lua_State* L, std::string& error) {
  constexpr std::string_view kNilGlobal = "a nil value (global '";
  const std::size_t found = error.find(kNilGlobal);
  if (found == error.npos) return;
  const std::size_t name = found + kNilGlobal.size();
  const std::size_t end = error.find("')", name);
  if (end == error.npos) return;
  lua_pushcfunction(L, push_suggestion);
  lua_pushlstring(L, error.data() + name, end - name);
  if (lua_pcall(L, 1, 1, 0) == LUA_OK) error.insert(end + 2, lua_tostring(L, -1));
  lua_pop(L, 1);
}

/// The length of a leading "stdin:12: ", or 0.
std::size_t leading_place(const std::string& message) {
  if (!message.starts_with(kInput)) return 0;
  const std::size_t after = message.find_first_not_of("0123456789", kInput.size());
  return after != message.npos && message.compare(after, 2, ": ") == 0 ? after + 2 : 0;
}

/// Whether a frame of a traceback is Lua code with a place.
bool leads_further(std::string_view frame) {
  return frame.find("[C]:") == frame.npos && frame != kTailCalls;
}

/// Whether a frame of a traceback is in a module that rotor embeds.
bool in_rotor(std::string_view frame) {
  const auto& modules = script::embedded_modules();
  return std::any_of(modules.begin(), modules.end(), [&](const script::EmbeddedModule& module) {
    return frame.starts_with("\trotor." + module.name + ":");
  });
}

/// Leaves out the frames of rotor's modules, with the C functions that these call and the tail
/// calls by which they are reached, unless there are no others.
void hide_rotor_frames(std::string& error) {
  const std::size_t found = error.rfind(kTraceback);
  if (found == error.npos) return;
  std::vector<std::string> frames;
  std::istringstream lines(error.substr(found + kTraceback.size()));
  for (std::string line; std::getline(lines, line);) frames.push_back(line);
  std::vector<bool> hidden(frames.size());
  for (std::size_t i = frames.size(); i-- > 0;) {
    const bool called_by_hidden = i + 1 < frames.size() && hidden[i + 1];
    hidden[i] = in_rotor(frames[i]) || (called_by_hidden && !leads_further(frames[i]));
  }
  for (std::size_t i = 1; i < frames.size(); ++i) {
    hidden[i] = hidden[i] || (hidden[i - 1] && frames[i] == kTailCalls);
  }
  std::string kept;
  bool further = false;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (hidden[i]) continue;
    further = further || leads_further(frames[i]);
    kept += (kept.empty() ? "" : "\n") + frames[i];
  }
  if (further) error.replace(found + kTraceback.size(), error.npos, kept);
}

/// The frames above the input, or nothing when none of the user's leads further. Those of what was
/// typed are named by their line alone.
std::string trim_traceback(const std::string& traceback) {
  std::string kept;
  bool further = false;
  std::istringstream frames(traceback);
  for (std::string frame; std::getline(frames, frame);) {
    if (frame == "\t[C]: in ?" || frame == "\t[C]: in function 'error'") continue;
    if (frame.ends_with("in main chunk") && frame.find(kInput) != frame.npos) continue;
    further = further || (leads_further(frame) && !in_rotor(frame));
    for (std::size_t at = 0; (at = frame.find(kInput)) != frame.npos;) {
      frame.replace(at, kInput.size(), "line ");
    }
    kept += "\n" + frame;
  }
  return further ? kept : "";
}

/// The columns that a string of UTF-8 takes, a tab the most that it can: bytes that continue a
/// character take none.
std::size_t width(std::string_view text) {
  constexpr std::size_t kTab = 8;
  std::size_t columns = 0;
  for (const char c : text) columns += c == '\t' ? kTab : (c & 0xC0) != 0x80 ? 1 : 0;
  return columns;
}

/// The line in pieces, broken at spaces, that take these columns at most where the words allow it.
std::string wrapped(std::string_view line, std::size_t columns) {
  std::string pieces;
  std::size_t used = 0;  // by the last piece
  while (!line.empty()) {
    const std::size_t end = line.find(' ', line.find_first_not_of(' '));
    std::string_view word = line.substr(0, end);  // with the spaces before it
    line.remove_prefix(word.size());
    if (used > 0 && used + width(word) > columns) {
      pieces += '\n';
      word.remove_prefix(1);
      used = 0;
    }
    pieces += word;
    used += width(word);
  }
  return pieces;
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
  hide_rotor_frames(text);
  suggest_global(L, text);
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

void print_error_at_prompt(const std::string& message) {
  winsize size = {};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return print_error(message);
  std::string text;
  std::istringstream lines(message);
  for (std::string line; std::getline(lines, line);) {
    text += wrapped(line, size.ws_col) + '\n';
  }
  print_error(text.substr(0, text.size() - 1));
}

}  // namespace rotor::app
