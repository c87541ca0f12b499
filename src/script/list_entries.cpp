// Many rotations at once, and tables of numbers in files.
#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "output/csv_reader.hpp"
#include "output/list_output.hpp"
#include "script/binding.hpp"
#include "script/options.hpp"
#include "script/output_options.hpp"
#include "script/progress.hpp"
#include "script/show.hpp"

namespace rotor::script {
namespace {

// The columns of rotations; those that have times begin with t, unless it is named elsewhere.
RotationColumns rotation_columns(lua_State* L, const Options& options, bool timed) {
  const auto standard = RotationColumns::standard();
  const Names given =
      options.get<Names>("columns").value_or(Names{{standard.begin(), standard.end()}});
  std::vector<std::string> names = given.list;
  if (timed && std::find(names.begin(), names.end(), "t") == names.end())
    names.insert(names.begin(), "t");
  return columns_of<RotationColumns>(L, names, timed);
}

constexpr const char* kTable = "rotation.table(rotations, {columns=, times=})";
Results table_entry(lua_State* L) {
  const auto rotations = argument<std::vector<Rotation>>(L, 1);
  const Options options(L, 2, kTable);
  const auto times = options.get<std::vector<double>>("times");
  const RotationColumns columns = rotation_columns(L, options, times.has_value());
  print(L, table(rotations, columns, precision(), times.value_or(std::vector<double>{})));
  return {0};
}

constexpr const char* kCsv = "rotation.csv(file, rotations, {columns=, times=})";
Results csv(lua_State* L) {
  const std::string file = file_argument(L, 1);
  const auto rotations = argument<std::vector<Rotation>>(L, 2);
  const Options options(L, 3, kCsv);
  const auto times = options.get<std::vector<double>>("times");
  const RotationColumns columns = rotation_columns(L, options, times.has_value());
  const bool with_json =
      write_csv(rotations, columns, file, scene_name(L), times.value_or(std::vector<double>{}));
  print_written(L, file, rotations.size(), with_json);
  return {0};
}

constexpr const char* kReadRotations =
    "rotation.read_csv(file, {face=, columns=, separator=}) -> table";
Results read_rotations(lua_State* L) {
  const std::string file = file_argument(L, 1);
  const Options options(L, 2, kReadRotations);
  const std::string face = options.get<std::string>("face").value_or("");
  const Names names = options.get<Names>("columns").value_or(Names{});
  const CsvTable table = read_csv(file, watching(0, 1), separator_option(options));
  try {
    Convert<std::vector<Rotation>>::push(L, rotations_of(table, face, names.list));
  } catch (const UnknownName& unknown) {
    throw_with_hint(L, unknown);
  }
  return {1};
}

constexpr const char* kReadColumns = "read_csv(file, {separator=}) -> table";
Results read_columns(lua_State* L) {
  refuse_more_arguments(L, 2);
  const std::string file = file_argument(L, 1);
  const Options options(L, 2, kReadColumns);
  const CsvTable table = read_csv(file, watching(0, 1), separator_option(options));
  lua_createtable(L, 0, static_cast<int>(table.columns.size()));
  for (const CsvColumn& column : table.columns) {
    Convert<std::string>::push(L, column.name);
    std::visit(
        [&](const auto& list) { Convert<std::remove_cvref_t<decltype(list)>>::push(L, list); },
        column.values);
    lua_rawset(L, -3);
  }
  push_module(L, "rotor.csv_columns");
  lua_setmetatable(L, -2);
  return {1};
}

// The names of the columns in the table at `index`, in the order of the alphabet.
std::vector<std::string> names_in(lua_State* L, int index) {
  const StackGuard guard(L);
  std::vector<std::string> names;
  for (lua_pushnil(L); lua_next(L, index) != 0; lua_pop(L, 1)) {
    if (lua_type(L, -2) != LUA_TSTRING)
      throw std::invalid_argument("expected columns by name, as {t = {0, 1}}, got the key " +
                                  describe(L, -2));
    names.push_back(Convert<std::string>::get(L, lua_gettop(L) - 1));
  }
  std::sort(names.begin(), names.end());
  return names;
}

// Adds a column for each component of the values, which have `get`.
template <class T, class Get>
void add_components(lua_State* L, int index, const std::string& name, const char* components,
                    Get get, std::vector<CsvColumn>& columns) {
  const auto list = Convert<std::vector<T>>::get(L, index);
  for (int i = 0; components[i] != '\0'; ++i) {
    std::vector<double> values;
    values.reserve(list.size());
    for (const T& value : list) values.push_back(get(value, i));
    columns.push_back({name + "_" + components[i], std::move(values)});
  }
}

// The list at `index` as columns; its first item says of what kind they all are.
void add_columns(lua_State* L, int index, const std::string& name,
                 std::vector<CsvColumn>& columns) {
  const StackGuard guard(L);
  if (!lua_istable(L, index)) throw Mismatch(L, index, "a list");
  const int type = lua_rawgeti(L, index, 1);
  if (type == LUA_TNUMBER || type == LUA_TNIL) {
    columns.push_back({name, Convert<std::vector<double>>::get(L, index)});
  } else if (type == LUA_TSTRING) {
    columns.push_back({name, Convert<std::vector<std::string>>::get(L, index)});
  } else if (test_user_value<Quaternion>(L, -1) != nullptr) {
    constexpr auto kGet = [](const Quaternion& q, int i) {
      return i == 0 ? q.w() : q.vec()(i - 1);
    };
    add_components<Quaternion>(L, index, name, "wxyz", kGet, columns);
  } else if (type == LUA_TTABLE || test_user_value<Vector>(L, -1) != nullptr) {
    constexpr auto kGet = [](const Vector& v, int i) { return v(i); };
    add_components<Vector>(L, index, name, "xyz", kGet, columns);
  } else {
    throw Mismatch(L, -1, "numbers, strings, vecs or quaternions");
  }
}

constexpr const char* kWrite = "write_csv(file, data, {columns=})";
Results write_columns(lua_State* L) {
  const std::string file = file_argument(L, 1);
  if (!lua_istable(L, 2)) throw_bad_argument(L, 2, Mismatch(L, 2, "a table of lists by name"));
  const Options options(L, 3, kWrite);
  const std::vector<std::string> there = names_in(L, 2);
  const Names names = options.get<Names>("columns").value_or(Names{there});
  std::vector<CsvColumn> columns;
  for (const std::string& name : names.list) {
    if (!std::binary_search(there.begin(), there.end(), name))
      throw_with_hint(L, UnknownName("column", name, there));
    lua_getfield(L, 2, name.c_str());
    try {
      add_columns(L, lua_gettop(L), name, columns);
    } catch (const Mismatch& mismatch) {
      throw std::invalid_argument("'" + name + "': " + mismatch.what());
    }
    lua_pop(L, 1);
  }
  print_written(L, file, write_csv(file, columns), false);
  return {0};
}

constexpr Entry kFunctions[] = {
    {"read_csv", bound<read_columns>, kReadColumns,
     "The columns of a CSV file with a header row, by name: data.t[1], data[\"angle_rad\"][1]. A "
     "column is a list of numbers where each field is one (nan, inf, -inf; an empty field is nan), "
     "else a list of strings. separator: one character, as \";\" or \"\\t\" "
     "(default \",\"). A decimal comma is not read. data.p is the list of vecs (quaternions) of "
     "the "
     "columns p_x, p_y, p_z (and p_w).",
     "data = read_csv \"log.csv\""},
    {"write_csv", bound<write_columns>, kWrite,
     "Writes columns of one length as CSV: data is a table of lists by name, of numbers, strings, "
     "vecs (columns name_x, name_y, name_z) or quaternions. columns: which, in which order "
     "(default: all, by the alphabet). The numbers read back as the same; strings that look like "
     "numbers read back as numbers.",
     R"(write_csv("/dev/null", {t = {0, 1}, x = {0.5, 0.25}}, {columns = {"t", "x"}}) --> )"},
};

constexpr Entry kStatics[] = {
    {"table", bound<table_entry>, kTable,
     "Prints a list of rotations. columns: quantities or components, as named for run:csv, but for "
     "omega and rates (default angle, axis). times: one for each, the column t. Digits are left "
     "out that do not fit into 80 columns; with 6 left, columns that do not fit stand below.",
     "rotation.table{rotation.identity} --> "},
    {"csv", bound<csv>, kCsv,
     "Writes a list of rotations as CSV, and what the columns mean as FILE.json. columns and "
     "times: as for rotation.table; read_csv(file).t reads the times back.",
     "rotation.csv(\"/dev/null\", {rotation.identity}) --> "},
    {"read_csv", bound<read_rotations>, kReadRotations,
     "The rotations of a CSV file, one a row. They are read from the first of these faces that has "
     "all its columns there: axis_angle (angle_rad, axis_x, ...: keeps all), euler_vector, "
     "quaternion, mrp, matrix, gibbs, euler_zyx and the other sequences (modified_gibbs alone does "
     "not tell a rotation, shadow_mrp not the identity). face: "
     "this one. columns: the names that its columns have in the file, in its order (a "
     "quaternion's: scalar first). A row that is no rotation is an error with its line. separator: "
     "as for read_csv.",
     "list = rotation.read_csv(\"log.csv\", {face = \"quaternion\", columns = {\"qw\", \"qx\", "
     "\"qy\", \"qz\"}})"},
};

constexpr Group kGroups[] = {
    {"", Kind::kFunction, kFunctions},
    {"rotation", Kind::kFunction, kStatics},
};

}  // namespace

std::span<const Group> list_groups() { return kGroups; }

}  // namespace rotor::script
