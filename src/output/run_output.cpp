#include "output/run_output.hpp"

#include <numbers>
#include <vector>

#include "output/csv.hpp"
#include "output/provenance.hpp"
#include "output/table.hpp"

namespace rotor {
namespace {

JsonObject provenance(const Run& run) {
  const Propagator& propagator = run.propagator();
  const Vector& axis = run.from().axis();
  return {{"omega", run.driver().description()},
          {"t", JsonArray{run.t0(), run.t1()}},
          {"from", JsonObject{{"axis", JsonArray{axis.x(), axis.y(), axis.z()}},
                              {"angle", run.from().angle()}}},
          {"method", propagator.method},
          {"why", propagator.why},
          {"accuracy_rad", propagator.accuracy > 0 ? Json(propagator.accuracy) : Json(nullptr)},
          {"error_estimate_rad", propagator.error_estimate},
          {"complete", run.complete()},
          {"omega_calls", propagator.cost.omega_calls},
          {"steps", propagator.cost.steps},
          {"rejected_steps", propagator.cost.rejected}};
}

}  // namespace

bool write_csv(const Run& run, std::span<const double> times, const StateColumns& columns,
               const std::filesystem::path& file, const std::string& scene,
               const Observer& observer) {
  CsvWriter writer(file, columns.headers());
  std::vector<double> values;
  visit_times(times, observer, [&](double t) {
    values.clear();
    StateRow row(run, t);
    columns.values(row, values);
    writer.row(values);
  });
  writer.commit();
  return write_provenance(file, columns, times.size(), scene,
                          "active rotations; omega in the space frame; quaternion scalar first; "
                          "angles in radians; angle and axis continuous in t",
                          provenance(run));
}

std::string table(const Run& run, std::span<const double> times, const StateColumns& columns,
                  int digits, const Observer& observer) {
  std::vector<std::vector<double>> rows;
  visit_times(times, observer, [&](double t) {
    StateRow row(run, t);
    columns.values(row, rows.emplace_back());
  });
  return number_table(columns.headers(), rows, digits);
}

std::string plot(const Run& run, std::span<const double> times, const StateColumns& columns,
                 PlotOptions options, const Observer& observer) {
  std::vector<Series> series;
  for (const Column& column : columns.list()) {
    series.push_back({column.header, {}});
    if (column.wraps) series.back().jump = std::numbers::pi;
  }
  std::vector<double> values;
  visit_times(times, observer, [&](double t) {
    values.clear();
    StateRow row(run, t);
    columns.values(row, values);
    for (std::size_t i = 0; i < values.size(); ++i) series[i].y.push_back(values[i]);
  });
  if (options.x_label.empty()) options.x_label = "t";
  return plot(times, series, options);
}

}  // namespace rotor
