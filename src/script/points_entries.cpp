// run:strobe, run:section, and points.
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "dynamics/recurrence.hpp"
#include "dynamics/section.hpp"
#include "dynamics/strobe.hpp"
#include "output/run_output.hpp"
#include "rotation/text.hpp"
#include "script/binding.hpp"
#include "script/options.hpp"
#include "script/output_options.hpp"
#include "script/progress.hpp"
#include "script/show.hpp"

namespace rotor::script {
namespace {

Observer watching(const RunPoints& points) {
  return script::watching(points.run->t0(), points.run->t1());
}

Results strobe_entry(lua_State* L) {
  const SharedRun& run = argument<SharedRun>(L, 1);
  const auto period = argument<double>(L, 2);
  refuse_more_arguments(L, 2);
  Convert<SharedPoints>::push(
      L, std::make_shared<const RunPoints>(RunPoints{run, strobe_times(*run, period), period}));
  return {1};
}

// The function of a state at `index`, as a function of t.
std::function<double(double)> scripted_function(lua_State* L, int index, const SharedRun& run) {
  return [L, index, run](double t) {
    luaL_checkstack(L, 4, "section");
    lua_pushvalue(L, index);
    Convert<RunState>::push(L, {run, run->attitude(t)});
    lua_call(L, 1, 1);
    if (lua_type(L, -1) != LUA_TNUMBER) {
      throw std::invalid_argument("f must return a number, got " + describe(L, -1) +
                                  " at t = " + shown(t));
    }
    const double value = lua_tonumber(L, -1);
    lua_pop(L, 1);
    return value;
  };
}

// normal . X - offset, X the chart: of G = M/M0 and of the MRP n sin(theta/4)/cos(theta/4) times
// what is below.
struct PlaneFunction {
  std::function<double(double)> value;
  std::function<double(double)> below = nullptr;
};
PlaneFunction plane_function(lua_State* L, const Options& options, const SharedRun& run) {
  const Vector normal = *options.get<Vector>("plane");
  const double length = norm(normal);
  if (!(length > 0 && std::isfinite(length))) {
    throw std::invalid_argument("plane: a finite normal other than 0 is expected, got " +
                                shown(normal));
  }
  const double offset = options.get<double>("offset").value_or(0);
  if (!std::isfinite(offset))
    throw std::invalid_argument("offset: expected a finite number, got " + shown(offset));
  const Chart chart = chart_option(L, options, "chart");
  if (chart == Chart::kRotation) {
    throw std::invalid_argument("chart: \"rotation\" has no coordinates for a plane");
  }
  const Observer watch = script::watching(run->t0(), run->t1());
  if (chart == Chart::kGibbs) {
    return {[=](double t) {
              const Quaternion q = run->attitude(t).quaternion;
              return normal.dot(q.vec()) - offset * q.w();
            },
            [=](double t) { return run->attitude(t).quaternion.w(); }};
  }
  if (chart == Chart::kMrp) {
    return {[=](double t) {
              const State state = (*run)(t, watch);
              return normal.dot(state.axis) * std::sin(state.angle / 4) -
                     offset * std::cos(state.angle / 4);
            },
            [=](double t) { return std::cos((*run)(t, watch).angle / 4); }};
  }
  return {[=](double t) {
    return normal.dot(coordinates(chart, chart_state(*run, t, chart, watch))) - offset;
  }};
}

constexpr const char* kSection =
    "run:section{f=, plane=, offset=, chart=, direction=, n=} -> points";
Results section_entry(lua_State* L) {
  const SharedRun& run = argument<SharedRun>(L, 1);
  const Options options(L, 2, kSection);
  if (options.has("f") == options.has("plane")) {
    throw std::invalid_argument("give one of f, a function of a state, and plane, a normal");
  }
  for (const char* key : {"offset", "chart"}) {
    if (options.has("f") && options.has(key)) {
      throw std::invalid_argument(std::string(key) + " belongs to plane, not to f");
    }
  }
  PlaneFunction f;
  if (options.has("f")) {
    options.push("f");
    if (!lua_isfunction(L, -1)) {
      throw std::invalid_argument("f: expected a function of a state, got " + describe(L, -1));
    }
    f = {scripted_function(L, lua_gettop(L), run)};
  } else {
    f = plane_function(L, options, run);
  }
  const auto direction = static_cast<Direction>(options.word("direction", {"both", "up", "down"}));
  const auto n = options.get<std::size_t>("n");
  Convert<SharedPoints>::push(
      L, std::make_shared<const RunPoints>(RunPoints{
             run,
             section(*run, f.value, direction, n, script::watching(run->t0(), run->t1()), f.below),
             std::nullopt}));
  return {1};
}

Results numbered_point(lua_State* L) {
  const SharedPoints& points = argument<SharedPoints>(L, 1);
  const auto index = argument<double>(L, 2);
  if (index >= 1 && index <= static_cast<double>(points->times.size()) &&
      index == std::floor(index)) {
    const double t = points->times[static_cast<std::size_t>(index) - 1];
    Convert<RunState>::push(L, {points->run, points->run->attitude(t)});
  } else {
    lua_pushnil(L);
  }
  return {1};
}

std::size_t size_of_points(const SharedPoints& points) { return points->times.size(); }
Results length_of_points(lua_State* L) {
  Convert<std::size_t>::push(L, size_of_points(argument<SharedPoints>(L, 1)));
  return {1};
}

constexpr const char* kCsv = "points:csv(file, {columns=})";
Results csv(lua_State* L) {
  const SharedPoints& points = argument<SharedPoints>(L, 1);
  const std::string file = file_argument(L, 2);
  const Options options(L, 3, kCsv);
  const auto columns = columns_option<StateColumns>(L, options);
  const bool with_json =
      write_csv(*points->run, points->times, columns, file, scene_name(L), watching(*points));
  print_written(L, file, points->times.size(), with_json);
  return {0};
}

constexpr const char* kTable = "points:table(what)";
Results table_entry(lua_State* L) {
  const SharedPoints& points = argument<SharedPoints>(L, 1);
  std::vector<std::string> names = argument<Names>(L, 2).list;
  refuse_more_arguments(L, 2);
  names.insert(names.begin(), "t");
  print(L, table(*points->run, points->times, columns_of<StateColumns>(L, names), precision(),
                 watching(*points)));
  return {0};
}

constexpr const char* kPlot = "points:plot(x, y, {title=, width=, height=, file=})";
Results plot_entry(lua_State* L) {
  const SharedPoints& points = argument<SharedPoints>(L, 1);
  const std::vector<std::string> names{argument<std::string>(L, 2), argument<std::string>(L, 3)};
  const Options options(L, 4, kPlot);
  show(L, options,
       points_picture(*points->run, points->times, columns_of<StateColumns>(L, names),
                      look_option(options), watching(*points)));
  return {0};
}

constexpr const char* kSphere = "points:sphere{of=, point=, from=, width=}";
Results sphere_entry(lua_State* L) {
  const SharedPoints& points = argument<SharedPoints>(L, 1);
  Options(L, 2, kSphere).word("of", sphere_quantities());
  draw_on_sphere(L, points->run, points->times, false);
  return {0};
}

constexpr const char* kReturnTimes = "points:return_times(distance, {norm=}) -> table, table";
Results return_times_entry(lua_State* L) {
  const SharedPoints& points = argument<SharedPoints>(L, 1);
  const auto distance = argument<double>(L, 2);
  const Options options(L, 3, kReturnTimes);
  const Chart norm = chart_option(L, options, "norm");
  std::vector<std::size_t> gaps = return_times(
      recurrence_points(*points->run, points->times, norm, watching(*points)), distance);
  std::sort(gaps.begin(), gaps.end());
  std::vector<std::size_t> different;
  std::vector<std::size_t> counts;
  for (const std::size_t gap : gaps) {
    if (different.empty() || different.back() != gap) {
      different.push_back(gap);
      counts.push_back(0);
    }
    ++counts.back();
  }
  Convert<std::vector<std::size_t>>::push(L, different);
  Convert<std::vector<std::size_t>>::push(L, counts);
  return {2};
}

std::vector<double> times(const SharedPoints& points) { return points->times; }
std::optional<double> period(const SharedPoints& points) { return points->period; }

// The circle of a strobe whose omega has that period, else null.
const StrobeCircle* circle_of(const SharedPoints& points) {
  if (!points->period) return nullptr;
  if (!points->circle)
    points->circle = strobe_circle(*points->run, points->times, watching(*points));
  return points->circle->closes ? &*points->circle : nullptr;
}
std::optional<Vector> axis(const SharedPoints& points) {
  const StrobeCircle* const circle = circle_of(points);
  return circle == nullptr || circle->axis.hasNaN() ? std::nullopt : std::optional(circle->axis);
}
std::optional<double> rotation_number(const SharedPoints& points) {
  const StrobeCircle* const circle = circle_of(points);
  return circle == nullptr ? std::nullopt : std::optional(circle->rotation_number);
}
std::optional<double> rotation_number_error(const SharedPoints& points) {
  const StrobeCircle* const circle = circle_of(points);
  return circle == nullptr ? std::nullopt : std::optional(circle->error);
}
std::optional<Closing> closing_of(const SharedPoints& points) {
  const StrobeCircle* const circle = circle_of(points);
  if (circle == nullptr) return std::nullopt;
  return closing(*points->run, points->times, *points->period, *circle);
}
std::optional<std::size_t> orbit_period(const SharedPoints& points) {
  const auto found = closing_of(points);
  return found && found->orbit ? std::optional(found->orbit->quaternion) : std::nullopt;
}
std::optional<std::size_t> attitude_period(const SharedPoints& points) {
  const auto found = closing_of(points);
  return found && found->orbit ? std::optional(found->orbit->attitude) : std::nullopt;
}
Results plane(lua_State* L) {
  const SharedPoints& points = argument<SharedPoints>(L, 1);
  if (points->times.empty()) throw std::invalid_argument("there are no points");
  const Plane found = plane_of_m(*points->run, points->times, watching(*points));
  lua_createtable(L, 0, 2);
  Convert<Vector>::push(L, found.normal);
  lua_setfield(L, -2, "normal");
  Convert<double>::push(L, found.off);
  lua_setfield(L, -2, "off");
  return {1};
}

std::string periods(std::size_t count) { return count == 1 ? "T" : std::to_string(count) + " T"; }
// "3 T = 25.132741228718345".
std::string periods(std::size_t count, double period) {
  return periods(count) + " = " + shown(static_cast<double>(count) * period);
}

// Whether the motion under an omega that repeats is periodic, in lines.
std::string text_of_closing(const RunPoints& points, const StrobeCircle& circle) {
  const std::string line = "\n        ";
  const std::size_t n = points.times.size();
  const auto found = closing(*points.run, points.times, *points.period, circle);
  if (!found) return line + "two points do not tell whether omega repeats";
  const std::string seen = line + "if omega goes on as in these " + std::to_string(n) + " points";
  if (found->orbit) {
    return line + "periodic: the attitude repeats after " +
           periods(found->orbit->attitude, *points.period) + line +
           "the quaternion, and E modulo 4 pi, after " +
           periods(found->orbit->quaternion, *points.period) + (found->omega_known ? "" : seen);
  }
  if (found->most == 0) return line + "too inexact to tell a period";
  const NearReturn nearest = nearest_return(circle, n - 1);
  return line + "no multiple of T, to " + std::to_string(found->most) + ", is a period; after " +
         periods(nearest.periods) + " off by " + rotor::text(nearest.angle, 2) + " rad";
}

std::string text_of_points(const SharedPoints& points) {
  const std::size_t n = points->times.size();
  std::string result =
      "points  " + std::to_string(n) +
      (points->period ? "  strobe with period " + shown(*points->period) : "  section");
  if (n > 0) {
    result += "  t " + rotor::text(points->times.front(), 8) + " .. " +
              rotor::text(points->times.back(), 8);
  }
  if (!points->period) return result;
  if (const StrobeCircle* const circle = circle_of(points)) {
    result += "\n        rotation number " + shown(circle->rotation_number) + " +- " +
              rotor::text(circle->error, 2);
    if (!circle->axis.hasNaN()) result += "\n        about " + shown(circle->axis);
    result += text_of_closing(*points, *circle);
  } else {
    result += "\n        omega does not repeat with this period: off the circle by " +
              rotor::text(points->circle->off, 2);
  }
  return result;
}

#define ROTOR_COS "function(t) return cos(pi*t), sin(pi*t), 0 end"
#define ROTOR_CLOSED                                                               \
  "evolve{omega = spin.turning{vector = {4, 0, 0}, about = {0, 0, 1}, rate = 3}, " \
  "to = 9}:strobe(2*pi/3)"
#define ROTOR_STROBE "evolve{omega = " ROTOR_COS ", to = 40}:strobe(2)"

constexpr Entry kMethods[] = {
    {"strobe", bound<strobe_entry>, "run:strobe(T) -> points",
     "The motion at t0, t0 + T, t0 + 2 T ...: the stroboscopic map. Where omega has the period T "
     "the points lie on a great circle of the unit quaternions and go on along it by "
     "points.rotation_number turns.",
     "#" ROTOR_STROBE " --> 21"},
    {"section", bound<section_entry>, kSection,
     "Where the motion comes through a surface (Poincare section), to the rounding of t: the zeros "
     "of f, a function of a state, or of plane . X - offset, plane a normal and X the "
     "\"euler_vector\" (default), \"modified_gibbs\", \"gibbs\" or \"mrp\" (chart=). direction: "
     "\"up\", \"down\" or \"both\" (default), as the motion goes. It is looked at n times, or so "
     "often that the body turns by less than 0.8 rad in between, and where it comes near to the "
     "surface and goes back: where it only touches it, nothing is seen.",
     "evolve{omega = {0, 0, 1}, to = 10}:section{f = function(s) return s.angle - 2 end}.times[1] "
     "--> 2.0"},
};

constexpr Entry kPointsFields[] = {
    {"times", bound<times>, "points.times -> table", "The times, a new list.",
     "#" ROTOR_STROBE ".times --> 21"},
    {"period", bound<period>, "points.period -> number",
     "The period of a strobe; nil of a section.", ROTOR_STROBE ".period --> 2.0"},
    {"rotation_number", bound<rotation_number>, "points.rotation_number -> number",
     "Of a strobe: by how many turns, in [0, 1), its points go on along their circle each period "
     "(the points of the quaternions, of E and of M; attitudes go on by twice that), about the "
     "axis. nil where omega does not repeat with the period, as far as the error of the run tells.",
     ROTOR_STROBE ".rotation_number < 1 --> true"},
    {"rotation_number_error", bound<rotation_number_error>,
     "points.rotation_number_error -> number", "What that may be wrong by.",
     ROTOR_STROBE ".rotation_number_error < 1e-10 --> true"},
    {"axis", bound<axis>, "points.axis -> vec",
     "The axis of what the motion does in a period, on the side of omega at the start; nil where "
     "there is none, or no rotation number.",
     "norm(" ROTOR_STROBE ".axis) > 0.99 --> true"},
    {"orbit_period", bound<orbit_period>, "points.orbit_period -> number",
     "Of a strobe: in how many periods T the quaternion repeats, from any start, and E too unless "
     "its angle goes through a multiple of 2 pi. nil where the rotation number is no fraction up "
     "to "
     "/1000, or so far as one found by chance has a probability of 1e-6; and where omega is not "
     "known to repeat, by its model or by three points or more.",
     ROTOR_CLOSED ".orbit_period --> 3"},
    {"attitude_period", bound<attitude_period>, "points.attitude_period -> number",
     "In how many the attitude does: as many, or half of that.",
     ROTOR_CLOSED ".attitude_period --> 3"},
    {"plane", bound<plane>, "points.plane -> table",
     "The plane through 0 that is nearest to the points of M: .normal, unit, and .off, the "
     "greatest "
     "distance of a point. That of a strobe is exact.",
     ROTOR_STROBE ".plane.off < 1e-10 --> true"},
    {"[i]", bound<numbered_point>, "points[i] -> state",
     "The state at the point i; nil past the "
     "last.",
     ROTOR_STROBE "[2].t --> 2.0"},
};

constexpr Entry kPointsMethods[] = {
    {"csv", bound<csv>, kCsv,
     "Writes the states at the points as CSV, with the columns of run:csv, and where they come "
     "from as FILE.json.",
     ROTOR_STROBE ":csv(\"/dev/null\") --> "},
    {"table", bound<table_entry>, kTable,
     "Prints quantities or components of the states at the points, as named for run:csv.",
     ROTOR_STROBE ":table(\"angle\") --> "},
    {"plot", bound<plot_entry>, kPlot,
     "Draws one component over another, as \"euler_vector_x\" and \"euler_vector_y\", in one scale "
     "for both: * a point, or . : - = + * # % @ the more points in a cell. file: as for run:plot.",
     ROTOR_STROBE ":plot(\"euler_vector_x\", \"euler_vector_y\") --> "},
    {"sphere", bound<sphere_entry>, kSphere,
     "Draws the axis at each point as a dot on the unit sphere, or what of and point name for "
     "run:sphere; from and width as for draw_sphere.",
     ROTOR_STROBE ":sphere{width = 30} --> "},
    {"return_times", bound<return_times_entry>, kReturnTimes,
     "In how many points the motion comes back within a distance of the first one: the different "
     "numbers, and how often each. On a circle there are three at most, the greatest the sum of "
     "the "
     "others. norm: as for run:recurrence, \"euler_vector\" (default) |E - E1|, or \"rotation\", "
     "the angle between the "
     "attitudes.",
     "#" ROTOR_STROBE ":return_times(1) <= 3 --> true"},
};

constexpr Entry kPointsOperators[] = {
    {"__len", bound<length_of_points>, "#points -> number", "How many there are.",
     "#" ROTOR_STROBE " --> 21"},
    {"__tostring", bound<text_of_points>, "tostring(points) -> string",
     "The text under which the terminal shows it.", "#tostring(" ROTOR_STROBE ") > 0 --> true"},
};

constexpr Group kGroups[] = {
    {"run", Kind::kMethod, kMethods},
    {"points", Kind::kField, kPointsFields},
    {"points", Kind::kMethod, kPointsMethods},
    {"points", Kind::kOperator, kPointsOperators},
};

}  // namespace

std::span<const Group> points_groups() { return kGroups; }

}  // namespace rotor::script
