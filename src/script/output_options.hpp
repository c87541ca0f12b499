// What the functions that print, write and read tables share.
#pragma once

#include <cstddef>
#include <lua.hpp>
#include <string>
#include <vector>

#include "dynamics/chart.hpp"
#include "motion/run.hpp"
#include "output/columns.hpp"
#include "output/picture.hpp"
#include "script/options.hpp"

namespace rotor::script {

/// By Lua's own print, which a script may have put in its place; it ends the line itself.
void print(lua_State* L, const std::string& text);

/// "wrote FILE (7 rows) and FILE.json", printed.
void print_written(lua_State* L, const std::string& file, std::size_t rows, bool with_json);

/// Says what became of FILE: "wrote FILE, and what draws it: ...", printed, or, on stderr, that
/// there was no gnuplot. The answer is `drawn`.
bool say_drawn(lua_State* L, const std::string& file, bool drawn);

/// The argument at `index`, a file's name; throws std::invalid_argument if it is empty.
std::string file_argument(lua_State* L, int index);

/// A name, or a list of names.
struct Names {
  std::vector<std::string> list;
};
template <>
struct Convert<Names> {
  static Names get(lua_State* L, int index);
};

/// The options n, every and times, of which one may be given: n times from the start of the run to
/// its end, both included, or between the two of the option t; `otherwise` of them where there is
/// none.
std::vector<double> times_option(const Options& options, const Run& run,
                                 std::size_t otherwise = 1000);

/// The options title, width and height of a picture.
PlotOptions look_option(const Options& options);

/// What the option `file` names, drawn by gnuplot, and said; printed in characters where it is not
/// given, and where there is no gnuplot.
void show(lua_State* L, const Options& options, const Picture& picture);

/// Pushes the states of a run at times of it, as a list.
void push_states(lua_State* L, const SharedRun& run, const std::vector<double>& times);

/// What of a state run:sphere and points:sphere draw, the default first.
inline std::vector<std::string> sphere_quantities() { return {"axis", "omega", "body_omega"}; }
/// What run:sphere and points:sphere print: the states at the times, joined by lines or not, by the
/// options at index 2, whose keys are checked.
void draw_on_sphere(lua_State* L, const SharedRun& run, const std::vector<double>& times,
                    bool joined);
/// Calls a function of the module rotor.sphere with the `count` values on the top of the stack;
/// what it finds wrong is an std::invalid_argument.
void call_sphere(lua_State* L, const char* function, int count);

/// A chart by its name; "euler_vector" where there is none.
Chart chart_option(lua_State* L, const Options& options, const char* key);

/// The option separator, one character; a comma by default.
char separator_option(const Options& options);

/// The name of the script, from the table arg (which has the program before it), or "terminal".
std::string scene_name(lua_State* L);

/// As std::invalid_argument, with "did you mean" where there is one.
[[noreturn]] void throw_with_hint(lua_State* L, const UnknownName& unknown);

/// C(names, more), a choice of columns.
template <class C, class... More>
C columns_of(lua_State* L, const std::vector<std::string>& names, More... more) {
  try {
    return C(names, more...);
  } catch (const UnknownName& unknown) {
    throw_with_hint(L, unknown);
  }
}

/// The columns of the option, or the standard ones.
template <class C>
C columns_option(lua_State* L, const Options& options) {
  const auto names = options.get<Names>("columns");
  return names ? columns_of<C>(L, names->list) : C(C::standard());
}

}  // namespace rotor::script
