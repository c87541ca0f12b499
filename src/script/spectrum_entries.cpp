// run:spectrum, spectrum, run:frequencies.
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "motion/times.hpp"
#include "output/spectrum_output.hpp"
#include "rotation/text.hpp"
#include "script/binding.hpp"
#include "script/options.hpp"
#include "script/output_options.hpp"
#include "script/progress.hpp"
#include "script/show.hpp"

namespace rotor::script {
namespace {

SpectrumOptions spectrum_options(const Options& options) {
  return {static_cast<Window>(options.word("window", window_names())),
          static_cast<Detrend>(options.word("detrend", detrend_names()))};
}

StateColumns column_option(lua_State* L, const Options& options) {
  const auto name = options.get<std::string>("of");
  if (!name) throw std::invalid_argument("of: say of which column, as \"euler_vector_x\"");
  auto column = columns_of<StateColumns>(L, {*name});
  signal_of(column);
  return column;
}

// Times evenly spaced, and how far apart.
struct EvenTimes {
  std::vector<double> times;
  double every;
};
EvenTimes even_times(const Run& run, std::size_t n) {
  const double length = std::abs(run.t1() - run.t0());
  if (length == 0) throw std::invalid_argument("the run has no length, t = " + text(run.t0()));
  const auto gaps = static_cast<double>(std::max<std::size_t>(n, 2) - 1);
  return {times_in(run.t0(), run.t1(), n), length / gaps};
}

constexpr const char* kOfRun = "run:spectrum{of=, n=, every=, window=, detrend=} -> spectrum";
Results spectrum_of_run(lua_State* L) {
  const SharedRun& run = argument<SharedRun>(L, 1);
  const Options options(L, 2, kOfRun);
  const StateColumns column = column_option(L, options);
  const auto n = options.get<std::size_t>("n");
  const auto every = options.get<double>("every");
  if (n && every) throw std::invalid_argument("give one of n and every");
  const EvenTimes at = every ? EvenTimes{times_every(run->t0(), run->t1(), *every), *every}
                             : even_times(*run, n.value_or(samples_for(*run)));
  const SpectrumOptions how = spectrum_options(options);
  const auto y = samples(*run, column, at.times, watching(run->t0(), run->t1()));
  Convert<SignalSpectrum>::push(
      L, {signal_of(column), how, y.size(), power_spectral_density(y, at.every, how)});
  return {1};
}

constexpr const char* kOfList = "spectrum(list, {every=, window=, detrend=}) -> spectrum";
Results spectrum_of_list(lua_State* L) {
  const auto y = argument<std::vector<double>>(L, 1);
  const Options options(L, 2, kOfList);
  const SpectrumOptions how = spectrum_options(options);
  const double every = options.get<double>("every").value_or(1);
  Convert<SignalSpectrum>::push(L,
                                {{"y", "y"}, how, y.size(), power_spectral_density(y, every, how)});
  return {1};
}

const std::vector<double>& frequencies_of(const SignalSpectrum& s) { return s.spectrum.frequency; }
const std::vector<double>& density_of(const SignalSpectrum& s) { return s.spectrum.density; }
double every_of(const SignalSpectrum& s) { return s.spectrum.every; }
std::string of(const SignalSpectrum& s) { return s.signal.name; }
std::string unit_of(const SignalSpectrum& s) { return s.unit(); }
std::string window_of(const SignalSpectrum& s) {
  return window_names()[static_cast<std::size_t>(s.options.window)];
}
std::string detrend_of(const SignalSpectrum& s) {
  return detrend_names()[static_cast<std::size_t>(s.options.detrend)];
}

Results peaks_entry(lua_State* L) {
  const auto& s = argument<SignalSpectrum>(L, 1);
  const auto most = argument<std::optional<std::size_t>>(L, 2).value_or(10);
  refuse_more_arguments(L, 2);
  const std::vector<SpectrumPeak> peaks = s.spectrum.peaks(most);
  lua_createtable(L, static_cast<int>(peaks.size()), 0);
  for (std::size_t i = 0; i < peaks.size(); ++i) {
    lua_createtable(L, 0, 2);
    lua_pushnumber(L, peaks[i].frequency);
    lua_setfield(L, -2, "frequency");
    lua_pushnumber(L, peaks[i].density);
    lua_setfield(L, -2, "density");
    lua_rawseti(L, -2, static_cast<lua_Integer>(i + 1));
  }
  return {1};
}

constexpr const char* kPlot = "spectrum:plot{from=, to=, title=, width=, height=, file=}";
Results plot_entry(lua_State* L) {
  const auto& s = argument<SignalSpectrum>(L, 1);
  const Options options(L, 2, kPlot);
  const auto from = options.get<double>("from");
  const double all = from ? s.spectrum.frequency.back() : s.reach();
  show(L, options,
       picture(s, from.value_or(0), options.get<double>("to").value_or(all), look_option(options)));
  return {0};
}

Results csv_entry(lua_State* L) {
  const auto& s = argument<SignalSpectrum>(L, 1);
  const std::string file = file_argument(L, 2);
  refuse_more_arguments(L, 2);
  const bool with_json = write_csv(s, file, scene_name(L));
  print_written(L, file, s.spectrum.frequency.size(), with_json);
  return {0};
}

std::string text_of_spectrum(const SignalSpectrum& s) {
  std::string result = "spectrum  of " + s.signal.name + ", " + s.unit() + "  " +
                       std::to_string(s.samples) + " samples, every " + text(s.spectrum.every, 6) +
                       "\n          window " + window_of(s) + "  detrend " + detrend_of(s) +
                       "  frequencies 0 .. " + text(s.spectrum.frequency.back(), 6);
  std::string highest;
  for (const SpectrumPeak& peak : s.spectrum.peaks(3))
    highest += (highest.empty() ? "\n          highest peaks at " : ", ") + text(peak.frequency, 6);
  return result + highest;
}

constexpr const char* kFrequencies = "run:frequencies(n, {of=, period=, samples=}) -> frequencies";
Results frequencies_entry(lua_State* L) {
  const SharedRun& run = argument<SharedRun>(L, 1);
  const auto n = argument<std::size_t>(L, 2);
  const Options options(L, 3, kFrequencies);
  const StateColumns column = column_option(L, options);
  const auto period = options.get<double>("period");
  const auto basis =
      period ? std::optional(floquet_frequencies(*run, *period)) : floquet_frequencies(*run);
  const EvenTimes at =
      even_times(*run, options.get<std::size_t>("samples").value_or(samples_for(*run)));
  const auto y = samples(*run, column, at.times, watching(run->t0(), run->t1()));
  FrequencyOptions how;
  how.sample_error = run->propagator().error_estimate;
  how.observer = watching(0, static_cast<double>(n));
  Convert<NamedFrequencies>::push(
      L, named(signal_of(column), n, frequencies(y, at.every, n, how), basis));
  return {1};
}

void set_number(lua_State* L, const char* key, double value) {
  lua_pushnumber(L, value);
  lua_setfield(L, -2, key);
}

// frequencies[i].
Results line_entry(lua_State* L) {
  const auto& list = argument<NamedFrequencies>(L, 1);
  const lua_Integer i = lua_tointeger(L, 2);
  if (i < 1 || i > static_cast<lua_Integer>(list.found.lines.size())) {
    lua_pushnil(L);
    return {1};
  }
  const Line& line = list.found.lines[static_cast<std::size_t>(i - 1)];
  lua_createtable(L, 0, 9);
  set_number(L, "frequency", line.frequency);
  set_number(L, "amplitude", line.amplitude);
  set_number(L, "phase", line.phase);
  set_number(L, "error", line.error);
  set_number(L, "amplitude_error", line.amplitude_error);
  set_number(L, "phase_error", line.phase_error);
  if (const auto& name = list.names[static_cast<std::size_t>(i - 1)]) {
    Convert<std::string>::push(L, name->name());
    lua_setfield(L, -2, "name");
    set_number(L, "predicted", line.frequency - name->difference);
    set_number(L, "difference", name->difference);
  }
  return {1};
}

std::size_t size_of(lua_State* L) { return argument<NamedFrequencies>(L, 1).found.lines.size(); }
Results count_entry(lua_State* L) {
  Convert<std::size_t>::push(L, size_of(L));
  return {1};
}
double mean_of(const NamedFrequencies& f) { return f.found.mean; }
std::optional<double> drive_of(const NamedFrequencies& f) {
  return f.basis && f.basis->drive > 0 ? std::optional(f.basis->drive) : std::nullopt;
}
std::optional<double> floquet_of(const NamedFrequencies& f) {
  return f.basis ? std::optional(f.basis->floquet) : std::nullopt;
}
std::optional<std::string> note_of(const NamedFrequencies& f) {
  const std::string note = f.note();
  return note.empty() ? std::nullopt : std::optional(note);
}
std::string text_of_frequencies(const NamedFrequencies& f) { return table(f, precision()); }

#define ROTOR_P15 \
  "evolve{omega = spin.turning{vector = {1, 0, 0}, about = {0, 0, 1}, rate = 0.75}, to = 400}"
#define ROTOR_LIST "spectrum({1, 0, -1, 0, 1, 0, -1, 0}, {every = 0.5})"
#define ROTOR_FOUND ROTOR_P15 ":frequencies(2, {of = \"quaternion_w\"})"

constexpr Entry kFunctions[] = {
    {"spectrum", bound<spectrum_of_list>, kOfList,
     "The one-sided power spectral density of a list of numbers, every so much apart (default 1). "
     "window and detrend: see run:spectrum.",
     ROTOR_LIST ":peaks(1)[1].frequency --> 0.5"},
};

constexpr Entry kMethods[] = {
    {"spectrum", bound<spectrum_of_run>, kOfRun,
     "The one-sided power spectral density of a column of run:csv (as \"euler_vector_x\"), from n "
     "samples of the whole run, or one every so much; as many as the motion needs by default. "
     "window: \"hann\" (default), \"none\" (the integral is the mean square), \"blackman_harris\", "
     "\"flat_top\". detrend: \"mean\" (default) or \"linear\" is subtracted first, or \"none\".",
     ROTOR_P15 ":spectrum{of = \"quaternion_w\"}.window --> \"hann\""},
    {"frequencies", bound<frequencies_entry>, kFrequencies,
     "The n strongest lines of a column of run:csv, found as by NAFF and fitted together, or as "
     "many as stand out; far beyond the resolution of a spectrum. Each has a name where omega is "
     "constant, of spin.turning or spin.periodic, or its period is given: j drive + k f_F, f_F the "
     "Floquet frequency, which one period tells. samples: as many as the motion needs by default.",
     ROTOR_FOUND "[1].name --> \"f_F\""},
};

constexpr Entry kFields[] = {
    {"frequencies", bound<frequencies_of>, "spectrum.frequencies -> table",
     "0 to 1/(2 every), cycles per unit of t.", "#" ROTOR_LIST ".frequencies --> 5"},
    {"density", bound<density_of>, "spectrum.density -> table", "The density at each, in .unit.",
     ROTOR_LIST ".density[5] < 1e-30 --> true"},
    {"every", bound<every_of>, "spectrum.every -> number", "The distance of the samples.",
     ROTOR_LIST ".every --> 0.5"},
    {"of", bound<of>, "spectrum.of -> string", "The column; \"y\" of a list.",
     ROTOR_LIST ".of --> \"y\""},
    {"window", bound<window_of>, "spectrum.window -> string", "The window.",
     ROTOR_LIST ".window --> \"hann\""},
    {"detrend", bound<detrend_of>, "spectrum.detrend -> string", "What was subtracted first.",
     ROTOR_LIST ".detrend --> \"mean\""},
    {"unit", bound<unit_of>, "spectrum.unit -> string",
     "The unit of the density: that of the column, squared, per cycle per unit of t.",
     ROTOR_LIST ".unit --> \"y^2/(cycle/t)\""},
};

constexpr Entry kSpectrumMethods[] = {
    {"peaks", bound<peaks_entry>, "spectrum:peaks(n) -> table",
     "The n highest local maxima (default 10), highest first: {frequency=, density=}, each by a "
     "parabola through three logarithms.",
     "#" ROTOR_LIST ":peaks(3) --> 1"},
    {"plot", bound<plot_entry>, kPlot,
     "Draws the density over a logarithmic axis, between two frequencies: by default from 0 to "
     "where all but a ten-thousandth of the power is, and a quarter more. file: a picture by "
     "gnuplot, "
     "as for run:plot.",
     ROTOR_LIST ":plot{height = 5} --> "},
    {"csv", bound<csv_entry>, "spectrum:csv(file)",
     "Writes frequency and density as CSV, and what they are as FILE.json.",
     ROTOR_LIST ":csv(\"/dev/null\") --> "},
};

constexpr Entry kSpectrumOperators[] = {
    {"__tostring", bound<text_of_spectrum>, "tostring(spectrum) -> string",
     "The text under which the terminal shows it.", "#tostring(" ROTOR_LIST ") > 0 --> true"},
};

constexpr Entry kListFields[] = {
    {"[i]", bound<line_entry>, "frequencies[i] -> table",
     "Line i, the strongest first: amplitude cos(2 pi frequency s + phase), s the time since the "
     "start. .error .amplitude_error .phase_error; .name, with .predicted and .difference from it, "
     "where it is a combination of drive and f_F within four times its error.",
     ROTOR_FOUND "[1].name --> \"f_F\""},
    {"mean", bound<mean_of>, "frequencies.mean -> number", "The constant beside the lines.",
     "abs(" ROTOR_FOUND ".mean) < 1e-9 --> true"},
    {"drive", bound<drive_of>, "frequencies.drive -> number",
     "1/T of omega; nil where it has no known period.",
     "abs(" ROTOR_FOUND ".drive - 0.375/pi) < 1e-15 --> true"},
    {"floquet", bound<floquet_of>, "frequencies.floquet -> number",
     "f_F = beta/(2 pi T), beta half the angle of the motion of one period, and of those a whole "
     "drive apart the one that is strongest in the quaternion; nil where no period is known.",
     "abs(" ROTOR_FOUND ".floquet - 0.125/pi) < 1e-14 --> true"},
    {"note", bound<note_of>, "frequencies.note -> string",
     "Why there are fewer than asked for; nil where there are not.", ROTOR_FOUND ".note --> nil"},
};
constexpr Entry kListOperators[] = {
    {"__len", bound<count_entry>, "#frequencies -> number", "How many there are.",
     "#" ROTOR_FOUND " --> 2"},
    {"__tostring", bound<text_of_frequencies>, "tostring(frequencies) -> string",
     "The table under which the terminal shows it.", "#tostring(" ROTOR_FOUND ") > 0 --> true"},
};

constexpr Group kGroups[] = {
    {"", Kind::kFunction, kFunctions},
    {"run", Kind::kMethod, kMethods},
    {"spectrum", Kind::kField, kFields},
    {"spectrum", Kind::kMethod, kSpectrumMethods},
    {"spectrum", Kind::kOperator, kSpectrumOperators},
    {"frequencies", Kind::kField, kListFields},
    {"frequencies", Kind::kOperator, kListOperators},
};

}  // namespace

std::span<const Group> spectrum_groups() { return kGroups; }

}  // namespace rotor::script
