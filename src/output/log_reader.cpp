#include "output/log_reader.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string_view>

#include "output/columns.hpp"
#include "rotation/text.hpp"

namespace rotor {
namespace {

using Names = std::vector<std::string>;

// A number in this unit times `times` over `over` is one in the first unit.
struct Unit {
  const char* name;
  double times;
  double over;
  std::array<std::string_view, 5> spellings;  // in headers
};
constexpr Unit kRates[] = {
    {"rad/s", 1, 1, {"rad/s", "rad/sec", "rad_s", "rads"}},
    {"deg/s", std::numbers::pi / 180, 1, {"deg/s", "deg/sec", "deg_s", "dps", "\u00b0/s"}},
};
constexpr Unit kTimes[] = {
    {"s", 1, 1, {"s", "sec", "seconds"}},
    {"ms", 1, 1e3, {"ms"}},
    {"us", 1, 1e6, {"us", "\u00b5s", "\u03bcs"}},
    {"ns", 1, 1e9, {"ns"}},
};

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

// A header without its unit, small letters and digits only; and the unit as it stands there.
struct Header {
  std::string name;
  std::string unit;
};

bool is_spelling(std::span<const Unit> units, std::string_view word) {
  return !word.empty() && std::any_of(units.begin(), units.end(), [&](const Unit& unit) {
    return std::find(unit.spellings.begin(), unit.spellings.end(), word) != unit.spellings.end();
  });
}

Header header_of(const std::string& column) {
  std::string name = lower(column);
  std::string unit;
  const auto bracket = name.find_first_of("([");
  if (bracket != name.npos && std::string_view(")]").find(name.back()) != std::string_view::npos) {
    unit = name.substr(bracket + 1, name.size() - bracket - 2);
    name.resize(bracket);
  } else {
    for (auto at = name.find('_'); at != name.npos && unit.empty(); at = name.find('_', at + 1)) {
      const std::string rest = name.substr(at + 1);
      if (!is_spelling(kRates, rest) && !is_spelling(kTimes, rest)) continue;
      unit = rest;
      name.resize(at);
    }
  }
  std::erase_if(name, [](unsigned char c) { return std::isalnum(c) == 0; });
  return {name, unit};
}

std::string names_of(std::span<const Unit> units) {
  Names names;
  for (const Unit& unit : units) names.emplace_back(unit.name);
  return listed(names, "\"");
}

const Unit& unit_named(std::span<const Unit> units, const std::string& option,
                       const std::string& name) {
  for (const Unit& unit : units)
    if (name == unit.name) return unit;
  throw std::invalid_argument(option + ": expected one of " + names_of(units) + ", got \"" + name +
                              "\"");
}

[[noreturn]] void refuse_unit(std::span<const Unit> units, const std::string& option,
                              const std::string& column) {
  throw std::invalid_argument("the unit of '" + column + "' is not known; give " + option +
                              ", one of " + names_of(units));
}
[[noreturn]] void refuse_two_units(const std::string& column, const Unit& unit,
                                   const std::string& other, const Unit& unit_of_other) {
  throw std::invalid_argument("'" + column + "' is in " + unit.name + ", but " + other + " says " +
                              unit_of_other.name);
}

// The unit of all these columns: what is given, which no header may contradict, else what the
// headers say, else the first.
const Unit& unit_of(std::span<const Unit> units, const std::string& option,
                    const std::optional<std::string>& given, std::span<const std::string> columns) {
  const Unit* found = given ? &unit_named(units, option, *given) : nullptr;
  std::string said = given ? "the option " + option : "";
  for (const std::string& column : columns) {
    const std::string word = header_of(column).unit;
    if (word.empty()) continue;
    const auto unit = std::find_if(units.begin(), units.end(), [&](const Unit& one) {
      return is_spelling(std::span(&one, 1), word);
    });
    if (unit == units.end()) {
      if (given) continue;
      refuse_unit(units, option, column);
    }
    if (found != nullptr && found != &*unit) {
      refuse_two_units(column, *unit, said, *found);
    }
    found = &*unit;
    if (said.empty()) said = "'" + column + "'";
  }
  return found == nullptr ? units.front() : *found;
}

// The columns whose header, without its unit, is `name`.
Names called(const CsvTable& table, const std::string& name) {
  Names found;
  for (const CsvColumn& column : table.columns)
    if (header_of(column.name).name == name) found.push_back(column.name);
  return found;
}

// t, x, y and z where there is one way to read the headers.
Names guessed_columns(const CsvTable& table) {
  Names times;
  for (const char* name : {"t", "time", "timestamp"}) {
    const Names found = called(table, name);
    times.insert(times.end(), found.begin(), found.end());
  }
  std::vector<Names> rates;
  for (const std::string prefix :
       {"", "gyro", "gyr", "g", "gyroscope", "w", "omega", "angularvelocity", "angularrate"}) {
    const Names x = called(table, prefix + "x");
    const Names y = called(table, prefix + "y");
    const Names z = called(table, prefix + "z");
    if (x.size() == 1 && y.size() == 1 && z.size() == 1) rates.push_back({x[0], y[0], z[0]});
  }
  if (times.size() == 1 && rates.size() == 1)
    return {times[0], rates[0][0], rates[0][1], rates[0][2]};
  Names headers;
  for (const CsvColumn& column : table.columns) headers.push_back(column.name);
  throw std::invalid_argument(
      "which columns are t and omega is not plain from " +
      (headers.empty() ? "no columns" : listed(headers, "'")) +
      R"(; name them: columns = {t = "...", x = "...", y = "...", z = "..."})");
}

Samples converted(const CsvTable& table, const LogFormat& format) {
  const Names names = format.columns.empty() ? guessed_columns(table) : format.columns;
  if (names.size() != 4) {
    throw std::invalid_argument("columns: expected four names, of t, x, y and z, got " +
                                std::to_string(names.size()));
  }
  std::array<const std::vector<double>*, 4> columns{};
  for (std::size_t c = 0; c < 4; ++c) {
    columns[c] = &table.numbers(table.column(names[c]));
    if (columns[c]->size() != columns[0]->size()) {
      throw std::invalid_argument("expected columns of one length, got " +
                                  std::to_string(columns[0]->size()) + " values in '" + names[0] +
                                  "' and " + std::to_string(columns[c]->size()) + " in '" +
                                  names[c] + "'");
    }
  }
  const Unit& time = unit_of(kTimes, "time_unit", format.time_unit, std::span(names).first(1));
  const Unit& rate = unit_of(kRates, "unit", format.unit, std::span(names).subspan(1));
  Samples samples{table.file, std::vector<Sample>(columns[0]->size())};
  for (std::size_t i = 0; i < samples.rows.size(); ++i) {
    const Vector raw((*columns[1])[i], (*columns[2])[i], (*columns[3])[i]);
    samples.rows[i] = {(*columns[0])[i] * time.times / time.over,
                       (raw - format.bias).cwiseProduct(format.scale) * rate.times / rate.over,
                       i + 1, table.lines.empty() ? 0 : table.lines[i]};
  }
  return samples;
}

}  // namespace

Samples samples_of(const CsvTable& table, const LogFormat& format) {
  for (const auto& [name, value] : {std::pair{"bias", format.bias}, {"scale", format.scale}}) {
    if (!value.allFinite()) {
      throw std::invalid_argument(std::string(name) + ": expected finite numbers, got " +
                                  text(value));
    }
  }
  return converted(table, format);
}

}  // namespace rotor
