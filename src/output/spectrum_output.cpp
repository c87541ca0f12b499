#include "output/spectrum_output.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "output/csv.hpp"
#include "output/provenance.hpp"
#include "output/table.hpp"
#include "rotation/text.hpp"

namespace rotor {

Signal signal_of(const StateColumns& columns) {
  const std::vector<Column>& list = columns.list();
  if (list.size() != 1) {
    throw std::invalid_argument("of: expected one column, got " + std::to_string(list.size()) +
                                "; take one of " + listed(columns.headers()));
  }
  const Column& column = list.front();
  const std::string suffix = column.header.substr(column.name.size());
  return {column.name, suffix.empty() ? "" : suffix.substr(1)};
}

std::vector<double> samples(const Run& run, const StateColumns& column,
                            std::span<const double> times, const Observer& observer) {
  std::vector<double> values;
  values.reserve(times.size());
  visit_times(times, observer, [&](double t) {
    StateRow row(run, t);
    column.values(row, values);
    if (!std::isfinite(values.back())) {
      throw std::invalid_argument(column.list().front().name + " is " + text(values.back()) +
                                  " at t = " + text(t) +
                                  "; expected finite numbers (run.notes may say why)");
    }
  });
  return values;
}

std::string SignalSpectrum::unit() const {
  return (signal.unit.empty() ? std::string("1") : signal.unit + "^2") + "/(cycle/t)";
}

double SignalSpectrum::reach() const {
  const std::vector<double>& density = spectrum.density;
  double rest = 1e-4 * std::accumulate(density.begin(), density.end(), 0.0);
  std::size_t last = density.size() - 1;
  while (last > 0 && (rest -= density[last]) >= 0) --last;
  return std::min(1.25 * spectrum.frequency[last], spectrum.frequency.back());
}

std::vector<std::string> window_names() { return {"hann", "none", "blackman_harris", "flat_top"}; }
std::vector<std::string> detrend_names() { return {"mean", "none", "linear"}; }

Picture picture(const SignalSpectrum& of, double from, double to, PlotOptions look) {
  constexpr double kLowest = 1e-20;
  std::vector<double> x;
  Series series;
  double highest = 0;
  for (std::size_t k = 0; k < of.spectrum.frequency.size(); ++k) {
    const double f = of.spectrum.frequency[k];
    if (!(f >= from && f <= to)) continue;
    x.push_back(f);
    series.y.push_back(of.spectrum.density[k]);
    highest = std::max(highest, of.spectrum.density[k]);
  }
  if (x.empty()) {
    throw std::invalid_argument("no frequency from " + text(from) + " to " + text(to) +
                                "; they go from 0.0 to " + text(of.spectrum.frequency.back()));
  }
  if (highest == 0) {
    throw std::invalid_argument(
        "the density is zero everywhere, which a logarithmic axis has no "
        "place for: is the signal constant?");
  }
  for (double& y : series.y) {
    if (y < kLowest * highest) y = std::numeric_limits<double>::quiet_NaN();
  }
  look.log_y = true;
  if (look.y_label.empty()) look.y_label = of.signal.name + ", " + of.unit();
  if (look.x_label.empty()) look.x_label = "frequency, cycles per unit of t";
  return {std::move(x), {std::move(series)}, look};
}

bool write_csv(const SignalSpectrum& of, const std::filesystem::path& file,
               const std::string& scene) {
  const std::vector<Column> columns = {
      {"frequency", "frequency", "frequency, cycles per unit of t", false},
      {"density", "density",
       "one-sided power spectral density of " + of.signal.name + ", " + of.unit(), false}};
  CsvWriter writer(file, std::vector<std::string>{columns[0].header, columns[1].header});
  for (std::size_t k = 0; k < of.spectrum.frequency.size(); ++k)
    writer.row(std::vector{of.spectrum.frequency[k], of.spectrum.density[k]});
  writer.commit();
  return write_provenance(
      file, columns, writer.rows(), scene,
      "without a window the sum of the densities times their distance is the mean square",
      {{"of", of.signal.name},
       {"samples", of.samples},
       {"every", of.spectrum.every},
       {"window", window_names()[static_cast<std::size_t>(of.options.window)]},
       {"detrend", detrend_names()[static_cast<std::size_t>(of.options.detrend)]}});
}

NamedFrequencies named(const Signal& signal, std::size_t asked, Frequencies found,
                       const std::optional<FloquetFrequencies>& basis) {
  NamedFrequencies result = {signal, asked, std::move(found), basis, {}};
  for (const Line& line : result.found.lines) {
    result.names.push_back(basis ? combination(*basis, line.frequency, 4 * line.error)
                                 : std::nullopt);
  }
  return result;
}

std::string NamedFrequencies::note() const {
  if (found.lines.size() >= asked) return "";
  const std::string count = found.lines.empty() ? "none" : std::to_string(found.lines.size());
  return count + " of the " + std::to_string(asked) +
         " asked for: " + (found.lines.empty() ? "nothing" : "no other") +
         " stands out, with an amplitude above " + text(found.least_amplitude, 2) +
         " and\ntwo cycles over the run from the next and from 0";
}

std::string table(const NamedFrequencies& of, int digits) {
  constexpr int kFrequencyDigits = 12;
  constexpr int kOtherDigits = 6;
  std::string result = "frequencies of " + of.signal.name + ", cycles per unit of t";
  if (of.basis) {
    const int most = std::min(digits, kFrequencyDigits);
    result += (of.basis->drive > 0 ? "\ndrive " + text(of.basis->drive, most) + "  " : "\n") +
              "f_F " + text(of.basis->floquet, most);
    if (const auto ratio = commensurate(*of.basis)) {
      const std::string over =
          ratio->denominator == 1 ? "" : "/" + std::to_string(ratio->denominator);
      result += " = " + std::to_string(ratio->numerator) + over + " drive, commensurate";
    }
  }
  const std::string amplitude = "amplitude" + (of.signal.unit.empty() ? "" : "_" + of.signal.unit);
  std::vector<std::string> header = {"frequency", "error", amplitude, "phase_rad"};
  if (of.basis) header.emplace_back("name");
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < of.found.lines.size(); ++i) {
    const Line& line = of.found.lines[i];
    auto& row = rows.emplace_back();
    row = {text(line.frequency, std::min(digits, kFrequencyDigits)), text(line.error, 2),
           text(line.amplitude, std::min(digits, kOtherDigits)),
           text(line.phase, std::min(digits, kOtherDigits))};
    if (of.basis) row.push_back(of.names[i] ? of.names[i]->name() : "");
  }
  if (!rows.empty()) {
    const std::string lines = table(header, rows);
    result += "\n" + lines.substr(0, lines.size() - 1);
  }
  if (!of.basis) result += "\nno names: the period of omega is not known, period = may give it";
  const std::string note = of.note();
  return note.empty() ? result : result + "\n" + note;
}

}  // namespace rotor
