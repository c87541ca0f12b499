// plot: lists of numbers as a picture.
#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "output/canvas.hpp"
#include "script/binding.hpp"
#include "script/options.hpp"
#include "script/output_options.hpp"

namespace rotor::script {
namespace {

// A list of numbers, or lists by name, in the order of the alphabet.
std::vector<Series> series_argument(lua_State* L, int index) {
  const StackGuard guard(L);
  if (!lua_istable(L, index) || lua_rawlen(L, index) > 0) {
    return {{"", argument<std::vector<double>>(L, index)}};
  }
  std::vector<Series> series;
  for (lua_pushnil(L); lua_next(L, index) != 0; lua_pop(L, 1)) {
    if (lua_type(L, -2) != LUA_TSTRING) {
      throw_bad_argument(L, index,
                         Mismatch("expected {name = list, ...}, got the key " + describe(L, -2)));
    }
    const std::string name = lua_tostring(L, -2);
    try {
      series.push_back({name, Convert<std::vector<double>>::get(L, lua_gettop(L))});
    } catch (const Mismatch& mismatch) {
      throw_bad_argument(L, index, Mismatch("'" + name + "': " + mismatch.what()));
    }
  }
  std::sort(series.begin(), series.end(),
            [](const Series& a, const Series& b) { return a.name < b.name; });
  return series;
}

constexpr const char* kPlot =
    "plot(x, y, {log=, title=, x_label=, y_label=, width=, height=, file=})";
Results plot_entry(lua_State* L) {
  const auto x = argument<std::vector<double>>(L, 1);
  const std::vector<Series> series = series_argument(L, 2);
  const Options options(L, 3, kPlot);
  PlotOptions look = look_option(options);
  look.x_label = options.get<std::string>("x_label").value_or("");
  look.y_label = options.get<std::string>("y_label").value_or("");
  const std::string log = options.get<std::string>("log").value_or("");
  if (!log.empty() && log != "x" && log != "y" && log != "xy") {
    throw std::invalid_argument(R"(log: expected "x", "y" or "xy", got ")" + log + "\"");
  }
  look.log_x = log.starts_with('x');
  look.log_y = log.ends_with('y');
  show(L, options, {x, series, look});
  return {0};
}

constexpr Entry kFunctions[] = {
    {"plot", bound<plot_entry>, kPlot,
     "Draws y over x: two lists of numbers of one length, x rising or falling; or several lists y "
     "by name, {name = list, ...}, each with its own mark. Values that are nan are gaps; one "
     "between gaps is a point. log: \"x\", \"y\" or \"xy\", which axes are logarithmic: x must be "
     "positive there, and other y are gaps. width and height: columns and rows (default 80 and "
     "20). file: a picture by gnuplot, as for run:plot.",
     "plot({1, 10, 100}, {1, 1e-4, 1e-8}, {log = \"xy\", height = 9}) --> "},
};

constexpr Group kGroups[] = {{"", Kind::kFunction, kFunctions}};

}  // namespace

std::span<const Group> plot_groups() { return kGroups; }

}  // namespace rotor::script
