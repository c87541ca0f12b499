// Columns and units of logs.
#include "output/log_reader.hpp"

#include <numbers>

#include "../refusal.hpp"
#include "output/columns.hpp"

namespace rotor {
namespace {

using Names = std::vector<std::string>;

// Two rows under these headers: row i of column c is 10 c + i, both counted from 0.
CsvTable table_of(const Names& headers) {
  CsvTable table{"log.csv", {}, {2, 3}};
  for (std::size_t c = 0; c < headers.size(); ++c) {
    const double first = 10 * static_cast<double>(c);
    table.columns.push_back({headers[c], std::vector<double>{first, first + 1}});
  }
  return table;
}

// The columns that were taken, by their first values.
Vector taken(const CsvTable& table) { return samples_of(table).rows[0].omega; }

constexpr double kDegree = std::numbers::pi / 180;

TEST_CASE("columns are found where the headers leave no choice") {
  const Vector next(10, 20, 30);
  CHECK(taken(table_of({"t", "x", "y", "z"})) == next);
  CHECK(taken(table_of({"Time", "GYRO_X", "Gyro_Y", "gyro z"})) == next);
  CHECK(taken(table_of({"timestamp", "gx", "gy", "gz", "ax", "ay", "az"})) == next);
  CHECK(taken(table_of({"t", "omega_x", "omega_y", "omega_z", "axis_x", "axis_y"})) == next);
  CHECK(taken(table_of({"t_s", "w_x_rad_s", "w_y_rad_s", "w_z_rad_s"})) == next);
  CHECK(taken(table_of({"t", "wx (rad/s)", "wy (rad/s)", "wz (rad/s)"})) == next);
  CHECK(taken(table_of({"z", "y", "x", "t"})) == Vector(20, 10, 0));
  const Samples samples = samples_of(table_of({"t", "x", "y", "z"}));
  CHECK(samples.name == "log.csv");
  CHECK(samples.rows.size() == 2);
  CHECK(samples.rows[1].row == 2);
  CHECK(samples.rows[1].line == 3);
  CHECK(samples.rows[1].t == 1);
}

TEST_CASE("columns that are not plain must be named") {
  for (const Names& headers :
       {Names{"t", "x", "y"}, Names{"a", "x", "y", "z"}, Names{"t", "time", "x", "y", "z"},
        Names{"t", "x", "y", "z", "gx", "gy", "gz"},
        Names{"t", "x (deg/s)", "x (rad/s)", "y", "z"}}) {
    refused([&] { samples_of(table_of(headers)); },
            {"not plain from '" + headers[0] + "', '" + headers[1], "columns = {t = \"...\""});
  }
  refused([] { samples_of(table_of({})); }, {"no columns"});
  LogFormat format;
  format.columns = {"d", "c", "b", "a"};
  CHECK(samples_of(table_of({"a", "b", "c", "d"}), format).rows[0].omega == Vector(20, 10, 0));
  CHECK_THROWS_AS(samples_of(table_of({"a", "b", "c"}), format), UnknownName);
  format.columns = {"a", "b"};
  refused([&] { samples_of(table_of({"a", "b"}), format); }, {"four names", "got 2"});
}

TEST_CASE("the unit is what the headers say, or what is given, and never both") {
  const CsvTable degrees = table_of({"Time (ms)", "Gyr X (deg/s)", "Gyr Y (deg/s)", "Gyr Z [dps]"});
  const Samples samples = samples_of(degrees);
  CHECK(samples.rows[1].t == 1e-3);
  CHECK(samples.rows[0].omega == Vector(10, 20, 30) * kDegree);
  LogFormat format;
  format.unit = "rad/s";
  refused([&] { samples_of(degrees, format); },
          {"'Gyr X (deg/s)' is in deg/s", "option unit", "rad/s"});
  format.unit = "deg/s";
  format.time_unit = "s";
  refused([&] { samples_of(degrees, format); },
          {"'Time (ms)' is in ms", "option time_unit says s"});
  format.time_unit = "ns";
  const CsvTable plain = table_of({"t", "x", "y", "z"});
  CHECK(samples_of(plain, format).rows[1].t == 1e-9);
  CHECK(samples_of(plain, format).rows[0].omega == Vector(10, 20, 30) * kDegree);
  refused(
      [] {
        samples_of(table_of({"t", "x (deg/s)", "y (rad/s)", "z"}));
      },
      {"'y (rad/s)' is in rad/s, but 'x (deg/s)' says deg/s"});
  const CsvTable odd = table_of({"t", "x (rpm)", "y (rpm)", "z (rpm)"});
  refused([&] { samples_of(odd); }, {"unit of 'x (rpm)' is not known", "\"rad/s\", \"deg/s\""});
  format = {};
  format.unit = "rad/s";
  CHECK(samples_of(odd, format).rows[0].omega == Vector(10, 20, 30));
  format.unit = "rpm";
  refused([&] { samples_of(plain, format); }, {"unit: expected one of", "got \"rpm\""});
}

TEST_CASE("bias is subtracted in the unit of the log, the scale comes after it") {
  LogFormat format;
  format.unit = "deg/s";
  format.bias = {1, 2, 3};
  format.scale = {2, -1, 0.5};
  CHECK(samples_of(table_of({"t", "x", "y", "z"}), format).rows[0].omega ==
        Vector(18, -18, 13.5) * kDegree);
  format.scale.x() = std::numeric_limits<double>::infinity();
  refused([&] { samples_of(table_of({"t", "x", "y", "z"}), format); }, {"scale:", "inf"});
  format.bias.y() = std::numeric_limits<double>::quiet_NaN();
  refused([&] { samples_of(table_of({"t", "x", "y", "z"}), format); }, {"bias:", "nan"});
}

TEST_CASE("columns of words or of several lengths are no log") {
  CsvTable table = table_of({"t", "x", "y", "z"});
  table.columns[2].values = std::vector<std::string>{"1", "on"};
  refused([&] { samples_of(table); }, {"log.csv: line 3: 'y': expected a number, got \"on\""});
  table.columns[2].values = std::vector<double>{1};
  refused([&] { samples_of(table); }, {"2 values in 't' and 1 in 'y'"});
}

}  // namespace
}  // namespace rotor
