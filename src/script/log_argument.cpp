#include "script/log_argument.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "output/csv_reader.hpp"
#include "output/log_reader.hpp"
#include "script/binding.hpp"
#include "script/output_options.hpp"
#include "script/progress.hpp"

namespace rotor::script {
namespace {

// A list of rows {t, x, y, z}.
CsvTable table_of_rows(lua_State* L, int index) {
  const auto rows = Convert<std::vector<std::vector<double>>>::get(L, index);
  std::array<std::vector<double>, 4> columns;
  for (auto& column : columns) column.reserve(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].size() != 4) {
      throw Mismatch("item " + std::to_string(i + 1) + ": expected {t, x, y, z}, got a list of " +
                     std::to_string(rows[i].size()));
    }
    for (std::size_t c = 0; c < 4; ++c) columns[c].push_back(rows[i][c]);
  }
  CsvTable table;
  const std::array names = {"t", "x", "y", "z"};
  for (std::size_t c = 0; c < 4; ++c) table.columns.push_back({names[c], std::move(columns[c])});
  return table;
}

// Lists of numbers by name; what is no such list is no column.
CsvTable table_of_columns(lua_State* L, int index) {
  CsvTable table;
  for (lua_pushnil(L); lua_next(L, index) != 0; lua_pop(L, 1)) {
    const StackGuard guard(L);
    if (lua_type(L, -2) != LUA_TSTRING || !lua_istable(L, -1)) continue;
    const int list = lua_gettop(L);
    if (lua_rawgeti(L, list, 1) != LUA_TNUMBER) continue;
    const std::string name = lua_tostring(L, list - 1);
    try {
      table.columns.push_back({name, Convert<std::vector<double>>::get(L, list)});
    } catch (const Mismatch& mismatch) {
      throw Mismatch("'" + name + "': " + mismatch.what());
    }
  }
  std::sort(table.columns.begin(), table.columns.end(),
            [](const CsvColumn& a, const CsvColumn& b) { return a.name < b.name; });
  return table;
}

CsvTable table_argument(lua_State* L, int index, const Options& options) {
  if (lua_type(L, index) == LUA_TSTRING) {
    return read_csv(file_argument(L, index), watching(0, 1), separator_option(options));
  }
  try {
    if (!lua_istable(L, index)) {
      throw Mismatch(
          L, index, "a file name, rows {{t, x, y, z}, ...} or columns {t = {...}, x = {...}, ...}");
    }
    return lua_rawlen(L, index) > 0 ? table_of_rows(L, index) : table_of_columns(L, index);
  } catch (const Mismatch& mismatch) {
    throw_bad_argument(L, index, mismatch);
  }
}

// The option columns, {"Time (s)", ...} or {t = "Time (s)", x = ...}: four names, or none.
std::vector<std::string> columns_of_log(lua_State* L, const Options& options) {
  const StackGuard guard(L);
  options.push("columns");
  if (lua_isnil(L, -1)) return {};
  if (!lua_istable(L, -1) || lua_rawlen(L, -1) > 0) return options.get<Names>("columns")->list;
  const Options names(L, lua_gettop(L), "columns{t=, x=, y=, z=}");
  std::vector<std::string> list;
  list.reserve(4);
  for (const char* key : {"t", "x", "y", "z"}) {
    const auto name = names.get<std::string>(key);
    if (!name) throw std::invalid_argument(std::string("columns: ") + key + " is missing");
    list.push_back(*name);
  }
  return list;
}

// A number for each component, or one for all.
Vector scale_option(lua_State* L, const Options& options) {
  const StackGuard guard(L);
  options.push("scale");
  if (lua_type(L, -1) == LUA_TNUMBER) return Vector::Constant(lua_tonumber(L, -1));
  return options.get<Vector>("scale").value_or(Vector::Ones());
}

LogFormat format_option(lua_State* L, const Options& options) {
  LogFormat format;
  format.columns = columns_of_log(L, options);
  format.unit = options.get<std::string>("unit");
  format.time_unit = options.get<std::string>("time_unit");
  format.bias = options.get<Vector>("bias").value_or(format.bias);
  format.scale = scale_option(L, options);
  return format;
}

Cleaning cleaning_option(const Options& options) {
  using enum Cleaning::Duplicates;
  return {.skip_missing = options.word("missing", {"error", "skip"}) == 1,
          .sort = options.word("order", {"error", "sort"}) == 1,
          .duplicates = std::array{kRefuse, kFirst,
                                   kMean}[options.word("duplicates", {"error", "first", "mean"})]};
}

}  // namespace

Samples log_argument(lua_State* L, int index, const Options& options) {
  const LogFormat format = format_option(L, options);
  const Cleaning cleaning = cleaning_option(options);
  try {
    return cleaned(samples_of(table_argument(L, index, options), format), cleaning);
  } catch (const UnknownName& unknown) {
    throw_with_hint(L, unknown);
  }
}

}  // namespace rotor::script
