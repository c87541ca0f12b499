#include "output/provenance.hpp"

#include "output/file.hpp"

namespace rotor {

bool write_provenance(const std::filesystem::path& file, const Columns& columns, std::size_t rows,
                      const std::string& scene, const std::string& conventions,
                      const JsonObject& more) {
  return write_provenance(file, columns.list(), rows, scene, conventions, more);
}

bool write_provenance(const std::filesystem::path& file, std::span<const Column> columns,
                      std::size_t rows, const std::string& scene, const std::string& conventions,
                      const JsonObject& more) {
  if (!std::filesystem::is_regular_file(file)) return false;
  JsonArray list;
  for (const Column& column : columns) {
    list.push_back(JsonObject{{"name", column.header}, {"meaning", column.meaning}});
  }
  JsonObject all = {{"program", "rotor " ROTOR_VERSION},
                    {"scene", scene},
                    {"rows", rows},
                    {"columns", list},
                    {"conventions", conventions}};
  all.insert(all.end(), more.begin(), more.end());
  std::filesystem::path json = file;
  json += ".json";
  write_file(json, Json(all).text() + "\n");
  return true;
}

}  // namespace rotor
