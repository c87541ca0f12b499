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

Face face_of(const CsvTable& table, const std::string& name) {
  for (const Face& face : faces()) {
    if (name.empty() ? std::all_of(face.columns.begin(), face.columns.end(),
                                   [&](const Column& c) { return find(table, c) != nullptr; })
                     : face.name == name)
      return face;
  }
  if (!name.empty()) throw UnknownName("face", name, face_names());
  std::string there;
  for (const CsvColumn& column : table.columns) there += (there.empty() ? "" : ", ") + column.name;
  throw std::invalid_argument(table.file +
                              ": expected all columns of a face, as quaternion_w, quaternion_x, "
                              "quaternion_y, quaternion_z; there are " +
                              there);
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

}  // namespace

std::string table(std::span<const Rotation> rotations, const RotationColumns& columns, int digits) {
  std::vector<std::vector<double>> rows;
  for (const Rotation& r : rotations) columns.values(r, rows.emplace_back());
  return number_table(columns.headers(), rows, digits, true);
}

bool write_csv(std::span<const Rotation> rotations, const RotationColumns& columns,
               const std::filesystem::path& file, const std::string& scene) {
  CsvWriter writer(file, columns.headers());
  std::vector<double> values;
  for (const Rotation& r : rotations) {
    values.clear();
    columns.values(r, values);
    writer.row(values);
  }
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
