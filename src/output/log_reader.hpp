// Logs of gyroscopes, from tables of numbers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "output/csv_reader.hpp"
#include "spin/samples.hpp"

namespace rotor {

/// What the columns of a log are, and how its numbers become rad/s.
struct LogFormat {
  /// Those of t and the three components; none: as the headers say.
  std::vector<std::string> columns;
  /// "rad/s" or "deg/s"; else what the headers say, else "rad/s".
  std::optional<std::string> unit;
  /// "s", "ms", "us" or "ns"; else what the header says, else "s".
  std::optional<std::string> time_unit;
  Vector bias = Vector::Zero();   // subtracted, in the unit of the log
  Vector scale = Vector::Ones();  // a factor after that, of each component
};

/// The rows of the table as they are, (value - bias) scale in rad/s. A header tells a unit in
/// brackets, "x (deg/s)", or after an underscore, "t_ms". Without names, t is the one column called
/// t, time or timestamp, and omega the three called x, y, z, alone or after gyro, gyr, g,
/// gyroscope, w, omega, angular_velocity or angular_rate. Throws UnknownName, and
/// std::invalid_argument where the columns are not plain from the headers, a unit is unknown or is
/// not what a header says, bias or scale are not finite, or columns are no numbers or not of one
/// length.
Samples samples_of(const CsvTable& table, const LogFormat& format = {});

}  // namespace rotor
