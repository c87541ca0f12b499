// Lists of rotations as tables for people and as CSV files, and back from CSV.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "output/columns.hpp"
#include "output/csv_reader.hpp"

namespace rotor {

/// An aligned table for people: the number i of each rotation, unless its time t is the first
/// column, and columns of at most `digits` significant digits. `times`, where t is a column, are as
/// many as the rotations, else std::invalid_argument is thrown.
std::string table(std::span<const Rotation> rotations, const RotationColumns& columns, int digits,
                  std::span<const double> times = {});

/// Writes FILE, a row for each rotation, and FILE.json as write_provenance does (with its answer).
/// `times` as for table. Throws std::system_error if a file cannot be written.
bool write_csv(std::span<const Rotation> rotations, const RotationColumns& columns,
               const std::filesystem::path& file, const std::string& scene,
               std::span<const double> times = {});

/// The faces from which rotations are read, what keeps most of a rotation first: "axis_angle" (the
/// angle as it is, before the axis), "euler_vector", "quaternion", ...
std::vector<std::string> face_names();

/// The rotations of a face's columns, one a row. If `face` is empty it is the first of face_names
/// all of whose columns are there, under the names that write_csv gives them (units may be left
/// out). `names` are those of the face's columns in the file, in its order, where they are others.
/// Throws UnknownName for a face or column that is not there, std::invalid_argument where no face
/// is complete, and with the line where a row is no rotation of that face.
std::vector<Rotation> rotations_of(const CsvTable& table, const std::string& face = "",
                                   std::span<const std::string> names = {});

}  // namespace rotor
