#include "output/list_output.hpp"

#include <algorithm>
#include <stdexcept>

#include "output/csv.hpp"
#include "output/provenance.hpp"
#include "output/table.hpp"

namespace rotor {
namespace {

constexpr const char* kAxisAngle = "axis_angle";

Rotation axis_angle_to_rotation(const Quantity::Values& v) { return {{v[1], v[2], v[3]}, v[0]}; }

struct Face {
  std::string name;
  std::vector<Column> columns;
  Rotation (*rotation)(const Quantity::Values&);
};

std::vector<Face> faces() {
  const std::vector<std::string> axis_angle = {"angle", "axis"};
  std::vector<Face> list = {
      {kAxisAngle, RotationColumns(axis_angle).list(), axis_angle_to_rotation}};
  for (const Quantity& quantity : quantities()) {
    const std::vector<std::string> name = {quantity.name};
    if (quantity.rotation != nullptr)
      list.push_back({quantity.name, RotationColumns(name).list(), quantity.rotation});
  }
  return list;
}

// The column of that name, with its unit or without.
const CsvColumn* find(const CsvTable& table, const Column& column) {
  const auto there = std::find_if(
      table.columns.begin(), table.columns.end(),
      [&](const CsvColumn& one) { return one.name == column.header || one.name == column.name; });
  return there == table.columns.end() ? nullptr : &*there;
}

std::vector<std::string> names_of(const CsvTable& table) {
  std::vector<std::string> names;
  for (const CsvColumn& column : table.columns) names.push_back(column.name);
  return names;
}

// An example: the columns of the file where there are four but for the time.
std::vector<std::string> quaternion_names(const CsvTable& table) {
  std::vector<std::string> names = names_of(table);
  std::erase_if(names, [](const std::string& name) { return name == "t" || name == "time"; });
  if (names.size() != 4) return {"q0", "q1", "q2", "q3"};
  std::stable_partition(names.begin(), names.end(), [](const std::string& name) {
    return name.ends_with('w') || name.ends_with('W');
  });
  return names;
}

Face face_of(const CsvTable& table, const std::string& name) {
  for (const Face& face : faces()) {
    if (name.empty() ? std::all_of(face.columns.begin(), face.columns.end(),
                                   [&](const Column& c) { return find(table, c) != nullptr; })
                     : face.name == name)
      return face;
  }
  if (!name.empty()) throw UnknownName("face", name, face_names());
  throw std::invalid_argument(table.file +
                              ": expected all columns of a face, as quaternion_w, quaternion_x, "
                              "quaternion_y, quaternion_z; there are " +
                              listed(names_of(table)) + "; name them, the scalar first: " +
                              "{face = \"quaternion\", columns = {" +
                              listed(quaternion_names(table), "\"") + "}}");
}

using Sources = std::vector<const std::vector<double>*>;

Sources sources_of(const CsvTable& table, const Face& face, std::span<const std::string> names) {
  if (!names.empty() && names.size() != face.columns.size())
    throw std::invalid_argument("columns: " + face.name + " has " +
                                std::to_string(face.columns.size()) + " components, got " +
                                std::to_string(names.size()) + " names");
  Sources sources;
  for (std::size_t c = 0; c < face.columns.size(); ++c) {
    const CsvColumn* own = names.empty() ? find(table, face.columns[c]) : nullptr;
    const std::string& name = names.empty() ? face.columns[c].header : names[c];
    sources.push_back(&table.numbers(own != nullptr ? *own : table.column(name)));
  }
  return sources;
}

// Calls `take` with the values of each rotation.
template <class Take>
void visit(std::span<const Rotation> rotations, const RotationColumns& columns,
           std::span<const double> times, Take take) {
  const auto& list = columns.list();
  const bool timed = std::any_of(list.begin(), list.end(), [](auto& c) { return c.name == "t"; });
  if (timed && times.size() != rotations.size())
    throw std::invalid_argument("times: expected one for each of the " +
                                std::to_string(rotations.size()) + " rotations, got " +
                                std::to_string(times.size()));
  std::vector<double> values;
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    values.clear();
    columns.values(rotations[i], timed ? times[i] : 0, values);
    take(values);
  }
}

}  // namespace

std::string table(std::span<const Rotation> rotations, const RotationColumns& columns, int digits,
                  std::span<const double> times) {
  std::vector<std::vector<double>> rows;
  visit(rotations, columns, times, [&](const auto& values) { rows.push_back(values); });
  return number_table(columns.headers(), rows, digits, columns.list().front().name != "t");
}

bool write_csv(std::span<const Rotation> rotations, const RotationColumns& columns,
               const std::filesystem::path& file, const std::string& scene,
               std::span<const double> times) {
  CsvWriter writer(file, columns.headers());
  visit(rotations, columns, times, [&](const auto& values) { writer.row(values); });
  writer.commit();
  return write_provenance(file, columns, rotations.size(), scene,
                          "active rotations; quaternion scalar first; angles in radians");
}

std::vector<std::string> face_names() {
  std::vector<std::string> names;
  for (const Face& face : faces()) names.push_back(face.name);
  return names;
}

std::vector<Rotation> rotations_of(const CsvTable& table, const std::string& face_name,
                                   std::span<const std::string> names) {
  if (face_name.empty() && !names.empty())
    throw std::invalid_argument("columns: say which face they are of, as face = \"quaternion\"");
  const Face face = face_of(table, face_name);
  const Sources sources = sources_of(table, face, names);
  std::vector<Rotation> rotations;
  rotations.reserve(table.lines.size());
  Quantity::Values values{};
  for (std::size_t row = 0; row < table.lines.size(); ++row) {
    for (std::size_t c = 0; c < sources.size(); ++c) values[c] = (*sources[c])[row];
    try {
      rotations.push_back(face.rotation(values));
    } catch (const std::invalid_argument& error) {
      table.refuse(row, error.what());
    }
  }
  return rotations;
}

}  // namespace rotor
