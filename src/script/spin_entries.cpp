// The module spin: angular velocities as values.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "output/csv_reader.hpp"
#include "output/list_output.hpp"
#include "rotation/text.hpp"
#include "script/binding.hpp"
#include "script/interrupt.hpp"
#include "script/log_argument.hpp"
#include "script/options.hpp"
#include "script/output_options.hpp"
#include "script/progress.hpp"
#include "script/scripted_omega.hpp"
#include "spin/attitude_spin.hpp"
#include "spin/models.hpp"
#include "spin/sampled.hpp"

namespace rotor::script {
namespace {

constexpr const char* kDriver = "a function of t, a vec, {x, y, z}, a spline or a spin";

// Anything that evolve takes as omega.
AngularVelocity driver(lua_State* L, int index) {
  try {
    return scripted_omega(L, index);
  } catch (const Mismatch&) {
    throw Mismatch(L, index, kDriver);
  }
}
AngularVelocity driver_argument(lua_State* L, int index) {
  try {
    return driver(L, index);
  } catch (const Mismatch& mismatch) {
    throw_bad_argument(L, index, mismatch);
  }
}

template <class Model, class... A>
Results push_spin(lua_State* L, A&&... arguments) {
  Convert<AngularVelocity>::push(L, {std::make_shared<const Model>(std::forward<A>(arguments)...)});
  return {1};
}

template <class T>
T required(const Options& options, const char* key, const char* expected) {
  const auto value = options.get<T>(key);
  if (!value)
    throw std::invalid_argument(std::string(key) + ": expected " + expected + ", got nothing");
  return *value;
}

constexpr const char* kTurning = "spin.turning{vector=, about=, rate=} -> spin";
Results turning(lua_State* L) {
  const Options options(L, 1, kTurning);
  return push_spin<TurningSpin>(L, required<Vector>(options, "vector", "omega at t = 0"),
                                required<Vector>(options, "about", "the axis of the turning frame"),
                                required<double>(options, "rate", "the rate of the turning frame"));
}

Results along(lua_State* L) {
  const auto direction = argument<Vector>(L, 1);
  refuse_more_arguments(L, 2);
  if (lua_type(L, 2) == LUA_TFUNCTION)
    return push_spin<AlongSpin>(L, direction, scripted_scalar(L, 2));
  if (lua_type(L, 2) != LUA_TNUMBER)
    throw_bad_argument(L, 2, Mismatch(L, 2, "a number or a function of t"));
  const double rate = lua_tonumber(L, 2);
  if (!std::isfinite(rate))
    throw std::invalid_argument("s: expected a finite number, got " + rotor::text(rate));
  const AlongSpin model(direction, {[rate](double) { return rate; }, {}, rotor::text(rate)});
  return push_spin<ConstantSpin>(L, model.value(0));
}

Results periodic(lua_State* L) {
  const auto period = argument<double>(L, 1);
  refuse_more_arguments(L, 2);
  return push_spin<PeriodicSpin>(L, period, driver_argument(L, 2));
}

constexpr const char* kPiecewise = "spin.piecewise{omega1, t1, omega2, t2, omega3} -> spin";
Results piecewise(lua_State* L) {
  refuse_more_arguments(L, 1);
  if (!lua_istable(L, 1)) throw_bad_argument(L, 1, Mismatch(L, 1, "a list of omegas and times"));
  const lua_Unsigned size = lua_rawlen(L, 1);
  require_list(L, 1, size);
  if (size % 2 == 0) {
    throw std::invalid_argument("expected one omega more than times, got " + std::to_string(size) +
                                " items; usage: " + kPiecewise);
  }
  std::vector<double> ends;
  std::vector<AngularVelocity> pieces;
  pieces.reserve(size / 2 + 1);
  ends.reserve(size / 2);
  for (lua_Unsigned i = 1; i <= size; ++i) {
    const StackGuard guard(L);
    lua_rawgeti(L, 1, static_cast<lua_Integer>(i));
    try {
      if (i % 2 == 1) {
        pieces.push_back(driver(L, lua_gettop(L)));
      } else {
        ends.push_back(Convert<double>::get(L, lua_gettop(L)));
      }
    } catch (const Mismatch& mismatch) {
      throw std::invalid_argument("item " + std::to_string(i) + ": " + mismatch.what() +
                                  "; usage: " + kPiecewise);
    }
  }
  return push_spin<PiecewiseSpin>(L, std::move(ends), std::move(pieces));
}

// The gaps of samples are kept with the value in Lua: both frames have them.
Results body(lua_State* L) {
  refuse_more_arguments(L, 1);
  Convert<AngularVelocity>::push(L, driver_argument(L, 1).in_body_frame());
  if (test_user_value<AngularVelocity>(L, 1) != nullptr) {
    lua_getiuservalue(L, 1, 1);
    lua_setiuservalue(L, -2, 1);
  }
  return {1};
}

// One line on stderr for gaps, or an error, as the option asks.
void report_gaps(lua_State* L, const Options& options, const std::string& report) {
  const std::size_t manner = options.word("gaps", {"warn", "error", "silent"});
  if (report.empty() || manner == 2) return;
  if (manner == 1) throw std::invalid_argument(report);
  warn(L, report);
}

void push_gaps(lua_State* L, const std::vector<Gap>& gaps) {
  lua_createtable(L, static_cast<int>(gaps.size()), 0);
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    lua_createtable(L, 0, 3);
    Convert<std::size_t>::push(L, gaps[i].row);
    lua_setfield(L, -2, "row");
    lua_pushnumber(L, gaps[i].from);
    lua_setfield(L, -2, "from");
    lua_pushnumber(L, gaps[i].to);
    lua_setfield(L, -2, "to");
    lua_rawseti(L, -2, static_cast<lua_Integer>(i + 1));
  }
}

constexpr const char* kSampled =
    "spin.sampled(log, {columns=, unit=, time_unit=, bias=, scale=, interpolation=, extrapolate=, "
    "missing=, order=, duplicates=, gap=, gaps=, separator=}) -> spin";
Results sampled(lua_State* L) {
  const Options options(L, 2, kSampled);
  const bool cubic = options.word("interpolation", {"linear", "cubic"}) == 1;
  const bool hold = options.get<bool>("extrapolate").value_or(false);
  const double gap = options.get<double>("gap").value_or(10);
  Samples samples = log_argument(L, 1, options);
  const std::vector<Gap> found = gaps(samples, gap);
  report_gaps(L, options, report_of(found, samples, gap));
  const std::size_t bytes = samples.rows.size() * 80;
  push_spin<SampledSpin>(L, std::move(samples),
                         cubic ? Interpolation::kCubic : Interpolation::kLinear, hold);
  push_gaps(L, found);
  lua_setiuservalue(L, -2, 1);
  tell_collector(L, bytes);
  return {1};
}

Spline spline_of_file(const std::string& file) {
  const CsvTable table = read_csv(file, watching(0, 1));
  return {table.numbers(table.column("t")), rotations_of(table), {}, stop_if_interrupted};
}
constexpr const char* kFromAttitudes = "spin.from_attitudes{times=, rotations=} -> spin";
Results from_attitudes(lua_State* L) {
  refuse_more_arguments(L, 1);
  if (const Spline* spline = test_user_value<Spline>(L, 1))
    return push_spin<AttitudeSpin>(L, *spline);
  if (lua_type(L, 1) == LUA_TSTRING) {
    try {
      return push_spin<AttitudeSpin>(L, spline_of_file(file_argument(L, 1)));
    } catch (const UnknownName& unknown) {
      throw_with_hint(L, unknown);
    }
  }
  if (!lua_istable(L, 1)) {
    throw_bad_argument(
        L, 1, Mismatch(L, 1, "{times = {...}, rotations = {...}}, a spline or a file name"));
  }
  const Options options(L, 1, kFromAttitudes);
  return push_spin<AttitudeSpin>(
      L, Spline(required<std::vector<double>>(options, "times", "a list of times"),
                required<std::vector<Rotation>>(options, "rotations", "a list of rotations"), {},
                stop_if_interrupted));
}

Vector value_at(const AngularVelocity& w, double t) { return w(t); }
std::string text_of(const AngularVelocity& w) { return "spin  " + w.description(); }
std::string description(const AngularVelocity& w) { return w.description(); }
std::string frame(const AngularVelocity& w) { return w.frame() == Frame::kBody ? "body" : "space"; }
// These are nil where there are no samples.
Results gaps_of(lua_State* L) {
  lua_getiuservalue(L, 1, 1);
  return {1};
}
Results times(lua_State* L) {
  const AngularVelocity& w = argument<AngularVelocity>(L, 1);
  if (const auto* samples = w.as<SampledSpin>()) {
    Convert<std::vector<double>>::push(L, samples->times());
  } else if (const auto* attitudes = w.as<AttitudeSpin>()) {
    Convert<std::vector<double>>::push(L, attitudes->spline().times());
  } else {
    lua_pushnil(L);
  }
  return {1};
}

#define ROTOR_ROWS "{{0, 0, 0, 1}, {1, 0, 0, 3}, {2, 0, 0, 2}}"

constexpr Entry kFunctions[] = {
    {"turning", bound<turning>, kTurning,
     "A vector that is constant in a frame which turns uniformly, as in coning: vector is omega at "
     "t = 0, about the axis of the frame (of any length but zero), rate its rate in radians per "
     "unit of t. Followed in closed form.",
     "spin.turning{vector = {1, 0, 0}, about = {0, 0, 1}, rate = 2}(0) --> vec(1.0, 0.0, 0.0)"},
    {"along", bound<along>, "spin.along(direction, s) -> spin",
     "Turns about a fixed direction (of any length but zero) at the rate s: a number, or a "
     "function of t that returns one, of any sign. One integral gives the motion.",
     "spin.along({0, 0, 2}, function(t) return t^2 end)(3) --> vec(0.0, 0.0, 9.0)"},
    {"periodic", bound<periodic>, "spin.periodic(T, omega) -> spin",
     "Repeats omega (anything that evolve takes) with the period T: it is asked for t from 0 to T "
     "only. One period is integrated, however long the motion (Floquet). Where omega(T) is not "
     "omega(0) it jumps there.",
     "spin.periodic(2, function(t) return t, 0, 0 end)(7) --> vec(1.0, 0.0, 0.0)"},
    {"piecewise", bound<piecewise>, kPiecewise,
     "One omega after the other, with the times between: omega1 until t1, then omega2 until t2, "
     "then omega3. Each is anything that evolve takes, and is asked for t itself; the times rise.",
     "spin.piecewise{{1, 0, 0}, 0.5, {0, 2, 0}}(3) --> vec(0.0, 2.0, 0.0)"},
    {"sampled", bound<sampled>, kSampled,
     "An angular velocity between samples, at any rising times. log: a CSV file, rows {{t, x, y, "
     "z}, ...} or columns {t = {...}, x = {...}, ...}, as read_csv gives them. columns: their "
     "names, {t = \"Time (s)\", x = \"Gyroscope X (deg/s)\", y = ..., z = ...} or a list of four "
     "(default: found where the headers leave no choice). unit: \"rad/s\" or \"deg/s\"; time_unit: "
     "\"s\", \"ms\", \"us\" or \"ns\" (default: what the headers say in brackets, else rad/s and "
     "s). bias: a vec that is subtracted, in the unit of the log; scale: a number or vec, the "
     "factor after that. interpolation: \"linear\" (default) or \"cubic\" (C2 spline, not a knot). "
     "Outside the samples omega is an error, unless extrapolate = true: then the values at the "
     "ends hold. Rows that are wrong are an error that lists them, unless missing = \"skip\", "
     "order = \"sort\" or duplicates = \"first\" or \"mean\" accepts them. Gaps, longer than gap "
     "(default 10) usual intervals, are reported on stderr, unless gaps = \"silent\" or "
     "\"error\". separator: of the file, as for read_csv. The log of a gyroscope is in the body "
     "frame: spin.body(spin.sampled(...)).",
     "spin.sampled(" ROTOR_ROWS ")(0.5) --> vec(0.0, 0.0, 2.0)"},
    {"from_attitudes", bound<from_attitudes>, kFromAttitudes,
     "The angular velocity of a log of attitudes, in the space frame: that of the C2 spline "
     "through them (rotation.spline). evolve{omega = w, from = rotations[1], t = {times[1], "
     "times[#times]}} goes through them all. The log may also be a spline, or a CSV file that has "
     "a column t and the columns of a face, as run:csv and rotation.csv write it.",
     "spin.from_attitudes{times = {0, 2}, rotations = {rotation.identity, rotation({0, 0, 1}, "
     "1)}}(1) --> vec(0.0, 0.0, 0.5)"},
    {"body", bound<body>, "spin.body(omega) -> spin",
     "The same function of t (anything that evolve takes) as an angular velocity given in the "
     "body frame, as a gyroscope measures it.",
     "spin.body{0, 0, 1} --> spin  (0.0, 0.0, 1.0), in the body frame"},
};

constexpr Entry kFields[] = {
    {"frame", bound<frame>, "w.frame -> string", R"("space" or "body": where omega is given.)",
     "spin.along({0, 0, 1}, 2).frame --> \"space\""},
    {"description", bound<description>, "w.description -> string", "What it is.",
     R"-(spin.along({0, 0, 1}, 2).description --> "(0.0, 0.0, 2.0)")-"},
    {"times", bound<times>, "w.times -> table",
     "The times of the samples, or of the attitudes, a new list each time; nil where there are "
     "none.",
     "#spin.sampled(" ROTOR_ROWS ").times --> 3"},
    {"gaps", bound<gaps_of>, "w.gaps -> table",
     "The gaps of samples, a list of {row, from, to}: the row before it and the times of its ends; "
     "nil where there are no samples.",
     "#spin.sampled(" ROTOR_ROWS ").gaps --> 0"},
};

constexpr Entry kOperators[] = {
    {"__call", bound<value_at>, "w(t) -> vec",
     "The angular velocity at t, radians per unit of t, in its frame.",
     "spin.body{0, 0, 1}(5) --> vec(0.0, 0.0, 1.0)"},
    {"__tostring", bound<text_of>, "tostring(w) -> string",
     "The text under which the terminal shows it.",
     "tostring(spin.body{0, 0, 1}) --> \"spin  (0.0, 0.0, 1.0), in the body frame\""},
};

constexpr Group kGroups[] = {
    {"spin", Kind::kFunction, kFunctions},
    {"spin", Kind::kField, kFields},
    {"spin", Kind::kOperator, kOperators},
};

}  // namespace

std::span<const Group> spin_groups() { return kGroups; }

}  // namespace rotor::script
