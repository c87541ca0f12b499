// What of a state is written and drawn: columns of CSV files and curves of plots, by name.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "motion/run.hpp"

namespace rotor {

/// One column: "angle_rad", "axis_x", "quaternion_w", ...
struct Column {
  std::string name;    // as scripts call it: angle, axis_x
  std::string header;  // with its unit: angle_rad, axis_x
  std::string meaning;
};

/// A choice of columns, and their values at a state of a run.
class Columns {
 public:
  /// Names are of a quantity ("axis": all its components) or of one component ("axis_x"; the
  /// header, as "angle_rad", will do). Throws std::invalid_argument for an unknown name, with the
  /// names there are.
  explicit Columns(std::span<const std::string> names);

  const std::vector<Column>& list() const { return columns_; }
  std::vector<std::string> headers() const;
  /// Appends one value a column.
  void values(const Run& run, const State& state, std::vector<double>& out) const;

  /// t, angle, axis, euler_vector, quaternion.
  static std::span<const std::string> standard();

 private:
  struct Part {
    std::size_t quantity;
    std::size_t component;
  };
  std::vector<Column> columns_;
  std::vector<Part> parts_;
};

}  // namespace rotor
