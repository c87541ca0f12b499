// Reference tables: CSV files beside the tests, made by a script beside them.
#pragma once

#include <array>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "rotation/rotation.hpp"

namespace rotor::reference {

/// One line of a table, read in order: hex floats, and words.
class Row {
 public:
  explicit Row(const std::string& line) : line_(line) {}

  std::string word() {
    std::string field;
    if (!std::getline(line_, field, ',')) throw std::runtime_error("reference table: short row");
    return field;
  }
  double number() { return double(wide()); }
  Vector vector() {
    const double x = number(), y = number();
    return {x, y, number()};
  }
  Quaternion quaternion() {
    const double w = number();
    const Vector v = vector();
    return {w, v.x(), v.y(), v.z()};
  }
  /// Numbers in two parts, value.hi and value.lo.
  template <class Exact, std::size_t N>
  void read(std::array<Exact, N>& values) {
    for (Exact& value : values) {
      value.hi = number();
      value.lo = wide();
    }
  }

 private:
  Extended wide() { return std::strtold(word().c_str(), nullptr); }

  std::istringstream line_;
};

/// The rows of a table, by its path from the folder of the tests, without its header.
inline std::vector<Row> table(const std::string& path) {
  std::ifstream file(ROTOR_SOURCE_DIR "/tests/" + path);
  std::vector<Row> rows;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) rows.emplace_back(line);
  if (rows.empty()) throw std::runtime_error("reference table " + path + ": missing or empty");
  return rows;
}

}  // namespace rotor::reference
