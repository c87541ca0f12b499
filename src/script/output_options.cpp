#include "script/output_options.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "motion/times.hpp"
#include "rotation/text.hpp"
#include "script/binding.hpp"
#include "script/lua_value.hpp"
#include "script/progress.hpp"

namespace rotor::script {
namespace {

// Columns or rows of a picture.
int size_option(const Options& options, const char* key, int otherwise) {
  constexpr std::size_t kMost = 1000;
  const auto size = options.get<std::size_t>(key).value_or(static_cast<std::size_t>(otherwise));
  if (size > kMost) {
    throw std::invalid_argument(std::string(key) + ": expected at most 1000, got " +
                                std::to_string(size));
  }
  return static_cast<int>(size);
}

// The whole run where it is not given.
std::pair<double, double> interval_option(const Options& options, const Run& run) {
  const auto interval = options.get<std::vector<double>>("t");
  if (!interval) return {run.t0(), run.t1()};
  if (interval->size() != 2) {
    throw std::invalid_argument("t: expected {from, to}, got a list of " +
                                std::to_string(interval->size()));
  }
  if (options.has("times")) throw std::invalid_argument("give t or times, not both");
  const auto [low, high] = std::minmax({run.t0(), run.t1()});
  for (const double t : *interval) {
    if (!(t >= low && t <= high)) {
      throw std::invalid_argument("t: expected times of the run, " + text(run.t0()) + " .. " +
                                  text(run.t1()) + ", got " + text(t));
    }
  }
  return {interval->front(), interval->back()};
}

}  // namespace

void print(lua_State* L, const std::string& text) {
  lua_getglobal(L, "print");
  lua_pushlstring(L, text.data(), text.ends_with('\n') ? text.size() - 1 : text.size());
  lua_call(L, 1, 0);
}

void print_written(lua_State* L, const std::string& file, std::size_t rows, bool with_json) {
  print(L, "wrote " + file + " (" + std::to_string(rows) + (rows == 1 ? " row)" : " rows)") +
               (with_json ? " and " + file + ".json" : ""));
}

bool say_drawn(lua_State* L, const std::string& file, bool drawn) {
  if (drawn) {
    const std::filesystem::path path(file);
    print(L, "wrote " + file + ", and what draws it: " +
                 std::filesystem::path(path).replace_extension(".gp").filename().string() + ", " +
                 std::filesystem::path(path).replace_extension(".dat").filename().string());
  } else {
    warn(L, "there is no gnuplot to draw " + file +
                " (Debian's package gnuplot-nox has it): its script and its data are written");
  }
  return drawn;
}

std::string file_argument(lua_State* L, int index) {
  const std::string file = argument<std::string>(L, index);
  if (file.empty()) throw std::invalid_argument("the file name is empty");
  return file;
}

Names Convert<Names>::get(lua_State* L, int index) {
  if (lua_type(L, index) == LUA_TSTRING) return {{Convert<std::string>::get(L, index)}};
  if (!lua_istable(L, index)) throw Mismatch(L, index, "a name or a list of names");
  return {Convert<std::vector<std::string>>::get(L, index)};
}

std::vector<double> times_option(const Options& options, const Run& run, std::size_t otherwise) {
  const auto n = options.get<std::size_t>("n");
  const auto every = options.get<double>("every");
  const auto times = options.get<std::vector<double>>("times");
  if (int{n.has_value()} + int{every.has_value()} + int{times.has_value()} > 1) {
    throw std::invalid_argument("give one of n, every and times");
  }
  const auto [begin, end] = interval_option(options, run);
  if (times) return *times;
  if (every) return times_every(begin, end, *every);
  return times_in(begin, end, n.value_or(otherwise));
}

PlotOptions look_option(const Options& options) {
  PlotOptions look;
  look.title = options.get<std::string>("title").value_or(look.title);
  look.width = size_option(options, "width", look.width);
  look.height = size_option(options, "height", look.height);
  return look;
}

void show(lua_State* L, const Options& options, const Picture& picture) {
  const auto file = options.get<std::string>("file");
  if (file && say_drawn(L, *file, draw(picture, *file))) return;
  print(L, in_characters(picture));
}

void push_states(lua_State* L, const SharedRun& run, const std::vector<double>& times) {
  lua_createtable(L, static_cast<int>(times.size()), 0);
  lua_Integer count = 0;
  visit_times(times, watching(run->t0(), run->t1()), [&](double t) {
    Convert<RunState>::push(L, {run, run->attitude(t)});
    lua_rawseti(L, -2, ++count);
  });
}

void draw_on_sphere(lua_State* L, const SharedRun& run, const std::vector<double>& times,
                    bool joined) {
  lua_settop(L, 2);
  Convert<SharedRun>::push(L, run);
  push_states(L, run, times);
  lua_pushboolean(L, joined ? 1 : 0);
  lua_pushvalue(L, 2);
  call_sphere(L, "draw_motion", 4);
}

void call_sphere(lua_State* L, const char* function, int count) {
  push_module(L, "rotor.sphere");
  lua_getfield(L, -1, function);
  lua_remove(L, -2);
  lua_insert(L, -1 - count);
  lua_call(L, count, 1);
  if (lua_isstring(L, -1) != 0) throw std::invalid_argument(lua_tostring(L, -1));
}

Chart chart_option(lua_State* L, const Options& options, const char* key) {
  const std::string given = options.get<std::string>(key).value_or(name_of(kCharts[0]));
  std::vector<std::string> known;
  for (const Chart chart : kCharts) {
    known.emplace_back(name_of(chart));
    if (given == known.back()) return chart;
  }
  throw_with_hint(L, UnknownName(key, given, known));
}

char separator_option(const Options& options) {
  const std::string separator = options.get<std::string>("separator").value_or(",");
  if (separator.size() != 1)
    throw std::invalid_argument(R"(separator: expected one character, as ";", got ")" + separator +
                                "\"");
  return separator[0];
}

std::string scene_name(lua_State* L) {
  const StackGuard guard(L);
  if (lua_getglobal(L, "arg") != LUA_TTABLE || lua_rawgeti(L, -1, -1) != LUA_TSTRING)
    return "terminal";
  return lua_rawgeti(L, -2, 0) == LUA_TSTRING ? lua_tostring(L, -1) : "terminal";
}

void throw_with_hint(lua_State* L, const UnknownName& unknown) {
  const StackGuard guard(L);
  lua_createtable(L, 0, static_cast<int>(unknown.known.size()));
  for (const std::string& name : unknown.known) {
    lua_pushboolean(L, 1);
    lua_setfield(L, -2, name.c_str());
  }
  const std::string hint = did_you_mean(L, unknown.name, lua_gettop(L));
  throw std::invalid_argument(hint.empty() ? unknown.what() : unknown.short_message() + hint);
}

}  // namespace rotor::script
