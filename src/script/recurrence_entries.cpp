// run:recurrence and recurrence.
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "dynamics/pair_distances.hpp"
#include "dynamics/recurrence.hpp"
#include "output/recurrence_output.hpp"
#include "output/table.hpp"
#include "rotation/text.hpp"
#include "script/binding.hpp"
#include "script/options.hpp"
#include "script/output_options.hpp"
#include "script/progress.hpp"
#include "script/show.hpp"

namespace rotor::script {
namespace {

constexpr const char* kRecurrence =
    "run:recurrence{threshold=, rate=, norm=, n=, every=, times=, t=, theiler=, lmin=, vmin=} -> "
    "recurrence";
Results recurrence_entry(lua_State* L) {
  const SharedRun& run = argument<SharedRun>(L, 1);
  const Options given(L, 2, kRecurrence);
  const auto threshold = given.get<double>("threshold");
  const auto rate = given.get<double>("rate");
  if (threshold.has_value() == rate.has_value())
    throw std::invalid_argument("give one of threshold and rate, as {threshold = 0.1}");
  RecurrenceOptions options;
  options.theiler = given.get<std::size_t>("theiler").value_or(options.theiler);
  options.least_diagonal = given.get<std::size_t>("lmin").value_or(options.least_diagonal);
  options.least_vertical = given.get<std::size_t>("vmin").value_or(options.least_vertical);
  const auto norm = chart_option(L, given, "norm");
  std::vector<double> times = times_option(given, *run);
  PointSequence points = recurrence_points(*run, times, norm, watching(run->t0(), run->t1()));
  const double distance =
      threshold ? *threshold : threshold_of_rate(points, *rate, options.theiler, watching(0, 1));
  Recurrence matrix = recurrence(std::move(points), distance, options, watching(0, 1));
  Convert<SharedRecurrence>::push(L, std::make_shared<const RunRecurrence>(
                                         RunRecurrence{std::move(times), norm, std::move(matrix)}));
  return {1};
}

const RecurrenceMeasures& measures(const SharedRecurrence& r) { return r->matrix.measures; }
std::size_t points(const SharedRecurrence& r) { return r->times.size(); }
std::size_t pairs(const SharedRecurrence& r) { return measures(r).pairs; }
double threshold(const SharedRecurrence& r) { return r->matrix.threshold; }
double rate(const SharedRecurrence& r) { return measures(r).rate; }
double det(const SharedRecurrence& r) { return measures(r).determinism; }
double mean_length(const SharedRecurrence& r) { return measures(r).mean_diagonal; }
std::size_t max_length(const SharedRecurrence& r) { return measures(r).max_diagonal; }
double entropy(const SharedRecurrence& r) { return measures(r).entropy; }
double divergence(const SharedRecurrence& r) { return measures(r).divergence; }
double laminarity(const SharedRecurrence& r) { return measures(r).laminarity; }
double trapping_time(const SharedRecurrence& r) { return measures(r).trapping_time; }
std::size_t max_vertical(const SharedRecurrence& r) { return measures(r).max_vertical; }

constexpr const char* kLags = "recurrence:lags{least=} -> table";
Results lags(lua_State* L) {
  const SharedRecurrence& r = argument<SharedRecurrence>(L, 1);
  const Options given(L, 2, kLags);
  const std::optional<double> every = even_spacing(r->times);
  if (!every) throw std::invalid_argument("lags need evenly spaced times");
  const auto list = recurrent_lags(r->matrix, given.get<double>("least").value_or(0.01));
  lua_createtable(L, static_cast<int>(list.size()), 0);
  lua_Integer count = 0;
  for (const RecurrentLag& one : list) {
    lua_createtable(L, 0, 2);
    lua_pushnumber(L, one.lag * *every);
    lua_setfield(L, -2, "lag");
    lua_pushnumber(L, one.share);
    lua_setfield(L, -2, "share");
    lua_rawseti(L, -2, ++count);
  }
  return {1};
}

constexpr const char* kPlot = "recurrence:plot{title=, width=, height=, file=}";
Results plot_entry(lua_State* L) {
  const SharedRecurrence& r = argument<SharedRecurrence>(L, 1);
  const Options given(L, 2, kPlot);
  const PlotOptions look = look_option(given);
  const auto file = given.get<std::string>("file");
  if (!file || !say_drawn(L, *file, draw(points_picture(*r, look, watching(0, 1)), *file)))
    print(L, plot(*r, look, watching(0, 1)));
  return {0};
}

Results csv(lua_State* L) {
  const SharedRecurrence& r = argument<SharedRecurrence>(L, 1);
  const std::string file = file_argument(L, 2);
  refuse_more_arguments(L, 2);
  const bool with_json = write_csv(*r, file, scene_name(L), name_of(r->norm), watching(0, 1));
  print_written(L, file, pairs(r), with_json);
  return {0};
}

std::string text_of_recurrence(const SharedRecurrence& r) {
  const RecurrenceOptions& options = r->matrix.options;
  const std::optional<double> every = even_spacing(r->times);
  const std::string diagonals = "diagonals of " + std::to_string(options.least_diagonal);
  const std::string verticals = "vertical lines of " + std::to_string(options.least_vertical);
  const auto whole = [](std::size_t n) { return std::to_string(n); };
  const std::vector<std::vector<std::string>> rows = {
      {"RR", rotor::text(rate(r), 6), ".rate", "share of the pairs that recur"},
      {"DET", rotor::text(det(r), 6), ".det", "in " + diagonals + " or more"},
      {"L", rotor::text(mean_length(r), 6), ".mean_length", "mean of their lengths"},
      {"L_max", whole(max_length(r)), ".max_length", "the longest"},
      {"DIV", rotor::text(divergence(r), 6), ".divergence", "1/L_max"},
      {"ENTR", rotor::text(entropy(r), 6), ".entropy", "entropy of their lengths, nat"},
      {"LAM", rotor::text(laminarity(r), 6), ".laminarity", "in " + verticals + " or more"},
      {"TT", rotor::text(trapping_time(r), 6), ".trapping_time", "mean of their lengths"},
      {"V_max", whole(max_vertical(r)), ".max_vertical", "the longest"},
  };
  const std::vector<std::string> header = {"measure", "value", "field",
                                           "meaning (lengths in points)"};
  const std::vector<Align> alignment = {Align::kLeft, Align::kLeft, Align::kLeft, Align::kLeft};
  std::string result = "recurrence  " + whole(points(r)) + " points, t " +
                       rotor::text(r->times.front(), 8) + " .. " + rotor::text(r->times.back(), 8) +
                       (every ? ", every " + rotor::text(*every, 6) : "") + "\n            " +
                       name_of(r->norm) + " within " + rotor::text(threshold(r), 6) + ": " +
                       whole(pairs(r)) + " pairs" +
                       (options.theiler > 1 ? ", theiler " + whole(options.theiler) : "") + "\n" +
                       rotor::table(header, rows, alignment);
  result.pop_back();
  return result;
}

#define ROTOR_RECURRENCE                                                                         \
  "evolve{omega = {0, 0, 1}, to = 20*pi}:recurrence{threshold = 1e-6, norm = \"rotation\", n = " \
  "201}"

constexpr Entry kMethods[] = {
    {"recurrence", bound<recurrence_entry>, kRecurrence,
     "Which pairs of states (at times as for run:sample) are within a threshold of one another, or "
     "within that at which a share rate of all pairs is, and what the recurrence plot measures. "
     "norm: \"euler_vector\" (default), \"modified_gibbs\", \"gibbs\", \"mrp\", in which it is the "
     "length of the difference, or \"rotation\", the angle between attitudes, rad. theiler: pairs "
     "nearer than that many points are left out (default 1: none but i = j). lmin, vmin: points of "
     "a diagonal and of a vertical line at least (default 2).",
     ROTOR_RECURRENCE ".pairs --> 910"},
};

constexpr Entry kRecurrenceMethods[] = {
    {"lags", bound<lags>, kLags,
     "The lines of the plot along its diagonal: lags at which the share of recurrent pairs is "
     "greatest between two dips to half of it, and at least `least` (default 0.01), as a list of "
     "{lag =, share =}. A lag is known to less than the spacing of times, which must be even. "
     "Diagonals of fewer than 1/least points are left out.",
     "#" ROTOR_RECURRENCE ":lags() --> 5"},
    {"plot", bound<plot_entry>, kPlot,
     "Draws the recurrence plot, t across and up, square: in each cell a mark by the share of its "
     "pairs that recur. file: its points by gnuplot, as for run:plot.",
     ROTOR_RECURRENCE ":plot{height = 11} --> "},
    {"csv", bound<csv>, "recurrence:csv(file)",
     "Writes the recurrent pairs as CSV: the numbers i < j of their points, from 1, and their "
     "times; and where they come from as FILE.json.",
     ROTOR_RECURRENCE ":csv(\"/dev/null\") --> "},
};

constexpr Entry kFields[] = {
    {"points", bound<points>, "recurrence.points -> integer", "The number of states compared.",
     ROTOR_RECURRENCE ".points --> 201"},
    {"pairs", bound<pairs>, "recurrence.pairs -> integer",
     "The number of recurrent pairs i < j, outside the Theiler window.",
     ROTOR_RECURRENCE ".pairs --> 910"},
    {"threshold", bound<threshold>, "recurrence.threshold -> number",
     "The distance within which a pair recurs.", ROTOR_RECURRENCE ".threshold --> 1e-06"},
    {"rate", bound<rate>, "recurrence.rate -> number",
     "RR, the share of the pairs outside the Theiler window that recur. This and what follows as "
     "in "
     "Marwan, Romano, Thiel, Kurths, Physics Reports 438 (2007).",
     ROTOR_RECURRENCE ".rate < 0.05 --> true"},
    {"det", bound<det>, "recurrence.det -> number",
     "DET, the share of the recurrent pairs on diagonals of lmin points or more; nan without "
     "pairs.",
     ROTOR_RECURRENCE ".det > 0.99 --> true"},
    {"mean_length", bound<mean_length>, "recurrence.mean_length -> number",
     "L, the mean length of these diagonals in points; nan without them.",
     ROTOR_RECURRENCE ".mean_length --> 101.0"},
    {"max_length", bound<max_length>, "recurrence.max_length -> integer",
     "L_max, the length of the longest of them; 0 without them.",
     ROTOR_RECURRENCE ".max_length --> 181"},
    {"entropy", bound<entropy>, "recurrence.entropy -> number",
     "ENTR, the Shannon entropy of their lengths, by the natural logarithm.",
     "floor(" ROTOR_RECURRENCE ".entropy*1000) --> 2197"},
    {"divergence", bound<divergence>, "recurrence.divergence -> number", "DIV = 1/L_max.",
     "1/" ROTOR_RECURRENCE ".divergence --> 181.0"},
    {"laminarity", bound<laminarity>, "recurrence.laminarity -> number",
     "LAM, the share of the recurrent pairs on vertical lines of vmin points or more; nan without "
     "pairs.",
     ROTOR_RECURRENCE ".laminarity --> 0.0"},
    {"trapping_time", bound<trapping_time>, "recurrence.trapping_time -> number",
     "TT, the mean length of these lines in points; nan without them.",
     "tostring(" ROTOR_RECURRENCE ".trapping_time):find \"nan\" ~= nil --> true"},
    {"max_vertical", bound<max_vertical>, "recurrence.max_vertical -> integer",
     "V_max, the length of the longest of them; 0 without them.",
     ROTOR_RECURRENCE ".max_vertical --> 0"},
};

constexpr Entry kOperators[] = {
    {"__tostring", bound<text_of_recurrence>, "tostring(recurrence) -> string",
     "The text under which the terminal shows it.", "#tostring(" ROTOR_RECURRENCE ") > 0 --> true"},
};

constexpr Group kGroups[] = {
    {"run", Kind::kMethod, kMethods},
    {"recurrence", Kind::kMethod, kRecurrenceMethods},
    {"recurrence", Kind::kField, kFields},
    {"recurrence", Kind::kOperator, kOperators},
};

}  // namespace

std::span<const Group> recurrence_groups() { return kGroups; }

}  // namespace rotor::script
