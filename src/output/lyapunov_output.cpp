#include "output/lyapunov_output.hpp"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "output/csv.hpp"
#include "output/provenance.hpp"

namespace rotor {
namespace {

constexpr std::array kNames = {"largest", "middle", "least"};

// The exponent times t is the logarithm of a stretch, computed from numbers around 1: a few of
// their roundings are 0, which a logarithmic axis leaves out.
constexpr double kRounding = 1e-15;

}  // namespace

bool write_csv(const LyapunovSpectrum& spectrum, const std::filesystem::path& file,
               const std::string& scene, const std::string& chart, const std::string& method) {
  std::vector<Column> columns = {{"t", "t", "time", false}};
  std::vector<std::string> headers = {"t"};
  for (const char* name : kNames) {
    columns.push_back(
        {name, name, std::string(name) + " exponent from the start to t, per unit of t", false});
    headers.emplace_back(name);
  }
  CsvWriter writer(file, headers);
  for (std::size_t i = 0; i < spectrum.times.size(); ++i) {
    const Vector& exponents = spectrum.history[i];
    writer.row(std::array{spectrum.times[i], exponents.x(), exponents.y(), exponents.z()});
  }
  writer.commit();
  return write_provenance(file, columns, writer.rows(), scene,
                          "finite-time Lyapunov exponents of the motion as the chart sees it",
                          {{"chart", chart}, {"method", method}, {"bridged", spectrum.bridged}});
}

Picture picture(const LyapunovSpectrum& spectrum, double t0, PlotOptions look) {
  const std::size_t n = spectrum.times.size();
  std::vector<double> elapsed(n);
  std::vector<Series> series;
  series.reserve(kNames.size());
  for (const char* name : kNames) series.push_back({name, std::vector<double>(n)});
  for (std::size_t i = 0; i < n; ++i) {
    elapsed[i] = std::abs(spectrum.times[i] - t0);
    for (std::size_t k = 0; k < 3; ++k) {
      const double size = std::abs(spectrum.history[i](static_cast<Eigen::Index>(k)));
      series[k].y[i] = size * elapsed[i] > kRounding ? size : 0;
    }
  }
  look.log_x = true;
  look.log_y = true;
  look.x_label = t0 == 0 ? "t" : "t - t0";
  look.y_label = "|exponent|";
  return {std::move(elapsed), std::move(series), look};
}

}  // namespace rotor
