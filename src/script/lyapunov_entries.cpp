// run:lyapunov and lyapunov, run:average.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "dynamics/birkhoff.hpp"
#include "dynamics/lyapunov.hpp"
#include "dynamics/separation.hpp"
#include "dynamics/tangent.hpp"
#include "motion/times.hpp"
#include "output/columns.hpp"
#include "output/lyapunov_output.hpp"
#include "rotation/text.hpp"
#include "script/binding.hpp"
#include "script/options.hpp"
#include "script/output_options.hpp"
#include "script/progress.hpp"
#include "script/show.hpp"

namespace rotor::script {
namespace {

// The start of the other motion: a turn of 1 rad about an axis that is no other's.
double isometry_of(const Run& run, const std::vector<double>& times) {
  std::vector<double> all = {run.t0()};
  all.insert(all.end(), times.begin(), times.end());
  const Run other = run.with_start(run.from() * Rotation(Vector(1, 2, 3), 1));
  const SeparationChange change =
      greatest_separation_change(run, other, all, watching(run.t0(), run.t1()));
  return std::max(change.quaternion, change.rotation);
}

constexpr const char* kLyapunov = "run:lyapunov{chart=, method=, n=, every=, times=} -> lyapunov";
Results lyapunov_entry(lua_State* L) {
  const SharedRun& run = argument<SharedRun>(L, 1);
  const Options options(L, 2, kLyapunov);
  LyapunovResult result;
  result.chart = chart_option(L, options, "chart");
  result.method =
      options.word("method", {"exact", "qr"}) == 0 ? LyapunovMethod::kExact : LyapunovMethod::kQr;
  result.t0 = run->t0();
  const auto every = options.get<double>("every");
  if (every && *every > std::abs(run->t1() - run->t0())) {
    throw std::invalid_argument("every = " + text(*every) + " is longer than the run, " +
                                text(run->t0()) + " .. " + text(run->t1()));
  }
  const std::vector<double> times = times_option(options, *run);
  result.spectrum =
      lyapunov_spectrum(*run, times, result.chart, result.method, watching(run->t0(), run->t1()));
  result.isometry = isometry_of(*run, result.spectrum.times);
  Convert<LyapunovResult>::push(L, result);
  return {1};
}

constexpr const char* kDivergence = "run:divergence(t, {chart=}) -> number";
Results divergence_entry(lua_State* L) {
  const SharedRun& run = argument<SharedRun>(L, 1);
  const auto t = argument<double>(L, 2);
  const Options options(L, 3, kDivergence);
  const Chart chart = options.has("chart") ? chart_option(L, options, "chart") : Chart::kGibbs;
  const State state = chart_state(*run, t, chart, watching(run->t0(), run->t1()));
  const AngularVelocity& omega = run->driver();
  Convert<double>::push(L, rate_jacobian(chart, state, omega(t), omega.frame()).trace());
  return {1};
}

std::vector<double> list_of(const Vector& v) { return {v.x(), v.y(), v.z()}; }

std::string chart(const LyapunovResult& r) { return name_of(r.chart); }
std::string method(const LyapunovResult& r) {
  return r.method == LyapunovMethod::kExact ? "exact" : "qr";
}
std::vector<double> exponents(const LyapunovResult& r) {
  return list_of(r.spectrum.history.back());
}
std::vector<double> times(const LyapunovResult& r) { return r.spectrum.times; }
std::vector<std::vector<double>> history(const LyapunovResult& r) {
  std::vector<std::vector<double>> list;
  for (const Vector& v : r.spectrum.history) list.push_back(list_of(v));
  return list;
}
double weighted(const LyapunovResult& r) { return r.spectrum.local.weighted; }
double weighted_error(const LyapunovResult& r) { return r.spectrum.local.weighted_error; }
double isometry(const LyapunovResult& r) { return r.isometry; }
std::vector<double> singular(const LyapunovResult& r) { return r.spectrum.singular; }
std::size_t bridged(const LyapunovResult& r) { return r.spectrum.bridged; }

constexpr const char* kPlot = "lyapunov:plot{title=, width=, height=, file=}";
Results plot_entry(lua_State* L) {
  const LyapunovResult& r = argument<LyapunovResult>(L, 1);
  const Options options(L, 2, kPlot);
  PlotOptions look = look_option(options);
  if (look.title.empty()) {
    look.title =
        "finite-time Lyapunov exponents in the chart " + chart(r) + " (the true ones are 0)";
  }
  show(L, options, picture(r.spectrum, r.t0, look));
  return {0};
}

Results csv(lua_State* L) {
  const LyapunovResult& r = argument<LyapunovResult>(L, 1);
  const std::string file = file_argument(L, 2);
  refuse_more_arguments(L, 2);
  const bool with_json = write_csv(r.spectrum, file, scene_name(L), chart(r), method(r));
  print_written(L, file, r.spectrum.times.size(), with_json);
  return {0};
}

std::string text_of_lyapunov(const LyapunovResult& r) {
  const std::string indent = "\n          ";
  const LyapunovSpectrum& s = r.spectrum;
  const Vector& end = s.history.back();
  std::string result = "lyapunov  chart " + chart(r) + "  method " + method(r) + "  t " +
                       text(r.t0, 6) + " .. " + text(s.times.back(), 6) + indent +
                       std::to_string(s.times.size()) + (s.times.size() == 1 ? " time" : " times") +
                       ", at the last: ";
  result += end.hasNaN() ? "none, the chart is singular there"
                         : text(end.x(), 5) + ", " + text(end.y(), 5) + ", " + text(end.z(), 5);
  if (!std::isnan(s.local.weighted)) {
    result += indent + "weighted average of the largest: " + text(s.local.weighted, 2) + " +- " +
              text(s.local.weighted_error, 2);
  }
  if (!s.singular.empty()) {
    result += indent + "the chart is singular at t = " + text(s.singular.front(), 6) +
              (s.singular.size() == 1
                   ? ""
                   : " and " + std::to_string(s.singular.size() - 1) + " more (.singular)");
  }
  if (s.bridged > 0) {
    result += indent + "singularities of the chart, crossed by the closed form: " +
              std::to_string(s.bridged);
  }
  return result + indent + "two motions stay as far apart as they were, to " + text(r.isometry, 2) +
         ":" + indent + "the true exponents are 0, 0, 0 for every omega; the chart is measured";
}

// A column that has one number a state.
StateColumns one_column(lua_State* L, const std::string& name) {
  auto columns = columns_of<StateColumns>(L, std::vector<std::string>{name});
  if (columns.list().size() == 1) return columns;
  throw std::invalid_argument("of: expected one column, got '" + name + "', which has " +
                              std::to_string(columns.list().size()) + ", as " +
                              columns.list().front().name);
}

// f of the state at t, on top of the stack.
double called(lua_State* L, int f, const SharedRun& run, double t) {
  lua_pushvalue(L, f);
  Convert<RunState>::push(L, {run, run->attitude(t)});
  lua_call(L, 1, 1);
  if (lua_type(L, -1) != LUA_TNUMBER) {
    throw std::invalid_argument("of: expected a number from the function, got " + describe(L, -1) +
                                " at t = " + text(t));
  }
  const double value = lua_tonumber(L, -1);
  lua_pop(L, 1);
  return value;
}

constexpr const char* kAverage = "run:average{of=, n=, weighted=} -> number, number";
Results average_entry(lua_State* L) {
  const SharedRun& run = argument<SharedRun>(L, 1);
  const Options options(L, 2, kAverage);
  const std::size_t n = options.get<std::size_t>("n").value_or(10000);
  const bool is_weighted = options.get<bool>("weighted").value_or(true);
  options.push("of");
  const int of = lua_gettop(L);
  const Observer observer = watching(run->t0(), run->t1());
  std::vector<double> samples;
  if (lua_isfunction(L, of)) {
    visit_times(times_in(run->t0(), run->t1(), n), observer,
                [&](double t) { samples.push_back(called(L, of, run, t)); });
  } else if (lua_type(L, of) == LUA_TSTRING) {
    const StateColumns column = one_column(L, lua_tostring(L, of));
    visit_times(times_in(run->t0(), run->t1(), n), observer, [&](double t) {
      StateRow row(*run, t);
      column.values(row, samples);
    });
  } else {
    throw std::invalid_argument(
        "of: expected a column, as \"angle\", or a function of a state, got " + describe(L, of));
  }
  const Average average = birkhoff(samples);
  lua_pushnumber(L, is_weighted ? average.weighted : average.plain);
  lua_pushnumber(L, is_weighted ? average.weighted_error : average.plain_error);
  return {2};
}

#define ROTOR_RUN "evolve{omega = {0, 0, 1}, to = 5}"
#define ROTOR_LYAPUNOV ROTOR_RUN ":lyapunov{n = 11}"

constexpr Entry kMethods[] = {
    {"lyapunov", bound<lyapunov_entry>, kLyapunov,
     "The three Lyapunov exponents of the motion as a chart sees them, from the start to each of n "
     "times (default 1000; every, times: as run:sample). The attitudes' flow is an isometry: for "
     "every omega its exponents are 0. What a chart shows beside that is its own distortion, "
     "and falls as 1/t. chart: \"euler_vector\" (default), \"rotation\" (the error rotation: 0 at "
     "all times), \"modified_gibbs\", \"gibbs\", \"mrp\". method: \"exact\" (default), the "
     "singular "
     "values of the tangent map in closed form; \"qr\", the linearised equation d' = A d of the "
     "chart, made orthonormal on the way: the sums of log R_ii, which come to the same limits but "
     "differ from the singular values by O(1/t). Per unit of t.",
     ROTOR_RUN ":lyapunov{chart = \"rotation\"}.exponents[1] < 1e-15 --> true"},
    {"average", bound<average_entry>, kAverage,
     "The average over t of a column (of = \"angle\", as run:csv) or of a function of a state, "
     "from "
     "n equally spaced samples (default 10000), and its error, by the two halves. Weighted by "
     "exp(-1/(s (1 - s))), s from 0 to 1 along the way: of quasiperiodic motions that errs by less "
     "than any power of 1/n; weighted = false: the plain mean.",
     ROTOR_RUN ":average{of = \"t\", n = 11, weighted = false} --> 2.5"},
};

constexpr Entry kDivergences[] = {
    {"divergence", bound<divergence_entry>, kDivergence,
     "The divergence at t of the field by which the chart's coordinates move, per unit of t: of "
     "\"gibbs\" (default) 2 omega . G [P13], which is 2 tan(theta/2) dtheta/dt [P14]; of "
     "\"euler_vector\", \"modified_gibbs\", \"mrp\" the trace of the chart's Jacobian. It says "
     "what "
     "the chart does: with the density (1 + |G|^2)^-2 every motion keeps volumes. Both along a run "
     "are columns of run:csv, divergence and invariant_density.",
     "evolve{omega = {0, 0, 1}, to = 2}:divergence(0) --> 0.0"},
};

constexpr Entry kFields[] = {
    {"exponents", bound<exponents>, "lyapunov.exponents -> table",
     "Those at the last time, largest first; nan where the chart is singular there.",
     "#" ROTOR_LYAPUNOV ".exponents --> 3"},
    {"times", bound<times>, "lyapunov.times -> table", "The times, without the start.",
     "#" ROTOR_LYAPUNOV ".times --> 10"},
    {"history", bound<history>, "lyapunov.history -> table",
     "The exponents from the start to each of the times: lists of three.",
     "#" ROTOR_LYAPUNOV ".history --> 10"},
    {"weighted", bound<weighted>, "lyapunov.weighted -> number",
     "The largest exponent by a weighted average of local rates (as run:average): for a regular "
     "motion in a chart without singularities on the way many more digits of the true 0 than "
     ".exponents; nan for a single time.",
     ROTOR_LYAPUNOV ".weighted < 1 --> true"},
    {"weighted_error", bound<weighted_error>, "lyapunov.weighted_error -> number",
     "Its error: how far it and those of the two halves are apart.",
     ROTOR_LYAPUNOV ".weighted_error < 1 --> true"},
    {"isometry", bound<isometry>, "lyapunov.isometry -> number",
     "By how much the distance of two motions, of quaternions or of operators, changes on the way, "
     "at most: rounding.",
     ROTOR_LYAPUNOV ".isometry < 1e-13 --> true"},
    {"singular", bound<singular>, "lyapunov.singular -> table",
     "The times at which the chart is singular, to the run's error: no exponents there.",
     "#" ROTOR_LYAPUNOV ".singular --> 0"},
    {"bridged", bound<bridged>, "lyapunov.bridged -> integer",
     "How many times, at least, the chart is singular on the way, and the closed form goes across: "
     "of \"exact\" as far as the times tell, of \"qr\" also where it is nearly so.",
     ROTOR_LYAPUNOV ".bridged --> 0"},
    {"chart", bound<chart>, "lyapunov.chart -> string", "The chart.",
     ROTOR_LYAPUNOV ".chart --> \"euler_vector\""},
    {"method", bound<method>, "lyapunov.method -> string", "The method.",
     ROTOR_LYAPUNOV ".method --> \"exact\""},
};

constexpr Entry kLyapunovMethods[] = {
    {"plot", bound<plot_entry>, kPlot,
     "Draws |exponent| of the three over t since the start, on logarithmic axes (Figure 8). "
     "file: a picture by gnuplot, as for run:plot.",
     ROTOR_LYAPUNOV ":plot{height = 5} --> "},
    {"csv", bound<csv>, "lyapunov:csv(file)",
     "Writes t and the three exponents as CSV: t, largest, middle, least; and where they come from "
     "as FILE.json.",
     ROTOR_LYAPUNOV ":csv(\"/dev/null\") --> "},
};

constexpr Entry kOperators[] = {
    {"__tostring", bound<text_of_lyapunov>, "tostring(lyapunov) -> string",
     "The text under which the terminal shows it.", "#tostring(" ROTOR_LYAPUNOV ") > 0 --> true"},
};

constexpr Group kGroups[] = {
    {"run", Kind::kMethod, kMethods},          {"run", Kind::kMethod, kDivergences},
    {"lyapunov", Kind::kField, kFields},       {"lyapunov", Kind::kMethod, kLyapunovMethods},
    {"lyapunov", Kind::kOperator, kOperators},
};

}  // namespace

std::span<const Group> lyapunov_groups() { return kGroups; }

}  // namespace rotor::script
