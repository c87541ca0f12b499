#include "output/run_output.hpp"

#include <algorithm>
#include <vector>

#include "output/csv.hpp"
#include "output/file.hpp"
#include "output/json.hpp"
#include "output/table.hpp"

namespace rotor {
namespace {

Json provenance(const Run& run, std::size_t rows, const Columns& columns,
                const std::string& scene) {
  JsonArray list;
  for (const Column& column : columns.list()) {
    list.push_back(JsonObject{{"name", column.header}, {"meaning", column.meaning}});
  }
  const Propagator& propagator = run.propagator();
  const Vector& axis = run.from().axis();
  return JsonObject{
      {"program", "rotor " ROTOR_VERSION},
      {"scene", scene},
      {"rows", rows},
      {"columns", list},
      {"conventions",
       "active rotations; omega in the space frame; quaternion scalar first; angles in radians"},
      {"omega", run.driver().description()},
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

bool write_csv(const Run& run, std::span<const double> times, const Columns& columns,
               const std::filesystem::path& file, const std::string& scene,
               const Observer& observer) {
  CsvWriter writer(file, columns.headers());
  std::vector<double> values;
  visit_states(run, times, observer, [&](const State& state) {
    values.clear();
    columns.values(run, state, values);
    writer.row(values);
  });
  writer.commit();
  if (!std::filesystem::is_regular_file(file)) return false;
  std::filesystem::path json = file;
  json += ".json";
  write_file(json, provenance(run, times.size(), columns, scene).text() + "\n");
  return true;
}

std::string table(const Run& run, std::span<const double> times, const Columns& columns,
                  const std::function<std::string(double)>& number, const Observer& observer) {
  std::vector<std::vector<std::string>> rows;
  std::vector<double> values;
  visit_states(run, times, observer, [&](const State& state) {
    values.clear();
    columns.values(run, state, values);
    std::vector<std::string>& row = rows.emplace_back();
    for (const double value : values) row.push_back(number(value));
  });
  return table(columns.headers(), rows);
}

std::string plot(const Run& run, std::span<const double> times, const Columns& columns,
                 PlotOptions options, const Observer& observer) {
  std::vector<Series> series;
  for (const Column& column : columns.list()) series.push_back({column.header, {}});
  std::vector<double> values;
  visit_states(run, times, observer, [&](const State& state) {
    values.clear();
    columns.values(run, state, values);
    for (std::size_t i = 0; i < values.size(); ++i) series[i].y.push_back(values[i]);
  });
  if (options.x_label.empty()) options.x_label = "t";
  return plot(times, series, options);
}

}  // namespace rotor
