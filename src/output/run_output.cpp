#include "output/run_output.hpp"

#include <numbers>
#include <stdexcept>
#include <utility>
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

Picture picture(const Run& run, std::span<const double> times, const StateColumns& columns,
                const PlotOptions& look, const Observer& observer) {
  Picture picture{{times.begin(), times.end()}, {}, look};
  for (const Column& column : columns.list()) {
    picture.series.push_back({column.header, {}});
    if (column.wraps) picture.series.back().jump = std::numbers::pi;
  }
  std::vector<double> values;
  visit_times(times, observer, [&](double t) {
    values.clear();
    StateRow row(run, t);
    columns.values(row, values);
    for (std::size_t i = 0; i < values.size(); ++i) picture.series[i].y.push_back(values[i]);
  });
  if (look.x_label.empty()) picture.look.x_label = "t";
  return picture;
}

Picture points_picture(const Run& run, std::span<const double> times, const StateColumns& columns,
                       const PlotOptions& look, const Observer& observer) {
  Picture over_time = picture(run, times, columns, look, observer);
  if (over_time.series.size() != 2) {
    throw std::invalid_argument("expected two components, as \"euler_vector_x\", got " +
                                listed(columns.headers()));
  }
  Picture result{std::move(over_time.series[0].y), {}, look, true};
  result.look.x_label = over_time.series[0].name;
  result.look.y_label = over_time.series[1].name;
  result.series.push_back(std::move(over_time.series[1]));
  return result;
}

}  // namespace rotor
