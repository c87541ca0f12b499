// What of states and rotations is written and drawn: columns of files and tables, curves of plots.
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "output/quantity.hpp"

namespace rotor {

/// "a, b", each between quotes if there are any.
std::string listed(const std::vector<std::string>& names, const std::string& quote = "");

/// A name that is not there, and those that may be meant, for a hint.
struct UnknownName : std::invalid_argument {
  /// "unknown column 'axes'; there are t, angle, ...": `kind`, `name`, `known`, then `more`.
  UnknownName(const std::string& kind, const std::string& name, std::vector<std::string> known,
              const std::string& more = "");
  /// "unknown column 'axes'".
  std::string short_message() const { return "unknown " + kind + " '" + name + "'"; }

  std::string kind;
  std::string name;
  std::vector<std::string> known;
};

/// One column: "angle_rad", "axis_x", "quaternion_w", ...
struct Column {
  std::string name;    // as scripts call it: angle, axis_x
  std::string header;  // with its unit: angle_rad, axis_x
  std::string meaning;
  bool wraps;  // at -pi and pi
};

/// A choice of columns. Names are of a quantity ("axis": all its components) or of one component
/// ("axis_x"; the header, as "angle_rad", will do).
class Columns {
 public:
  const std::vector<Column>& list() const { return columns_; }
  std::vector<std::string> headers() const;

 protected:
  /// A component of a quantity. Those of one quantity stand together and are computed together.
  struct Part {
    const Quantity* quantity;
    std::size_t component;
  };
  /// Throws UnknownName, and std::invalid_argument where there are no names.
  Columns(std::span<const std::string> names, bool (*is_known)(const Quantity&));

  std::vector<Column> columns_;
  std::vector<Part> parts_;
};

/// Columns of the states of a run.
class StateColumns : public Columns {
 public:
  explicit StateColumns(std::span<const std::string> names);
  /// Appends one value a column.
  void values(StateRow& row, std::vector<double>& out) const;
  /// t, angle, axis, euler_vector, quaternion.
  static std::span<const std::string> standard();
};

/// Columns of rotations that are in no run: without omega and the rates, and without t unless they
/// are `timed`.
class RotationColumns : public Columns {
 public:
  explicit RotationColumns(std::span<const std::string> names, bool timed = false);
  /// Appends one value a column; t is the time `t`.
  void values(const Rotation& r, double t, std::vector<double>& out) const;
  /// angle, axis.
  static std::span<const std::string> standard();
};

}  // namespace rotor
