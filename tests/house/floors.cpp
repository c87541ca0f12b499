#include "house/floors.hpp"

#include <regex>
#include <set>
#include <sstream>

namespace rotor::house {
namespace {

std::string folder_of(const std::string& path) { return path.substr(0, path.find('/')); }

/// The folders that may include an outside header; for the others of the world there is no rule.
const std::set<std::string>* permitted(const std::string& header) {
  static const std::set<std::string> lua{"script", "app"}, app{"app"};
  static const std::regex lua_header("(lua5\\.4/)?(lua|luaconf|lualib|lauxlib)\\.h(pp)?");
  if (std::regex_match(header, lua_header)) return &lua;
  if (header.rfind("readline/", 0) == 0) return &app;
  return nullptr;
}

std::string outside_fault(const std::string& folder, const std::string& header) {
  const auto* folders = permitted(header);
  if (folders && !folders->contains(folder)) return "is not for this floor";
  // The standard headers of C++ have neither a folder nor an extension.
  const bool std_or_eigen =
      header.rfind("Eigen/", 0) == 0 || header.find_first_of("/.") == std::string::npos;
  if (folder == "rotation" && !std_or_eigen) return "is neither Eigen nor std";
  return "";
}

std::string inside_fault(const std::string& folder, const std::string& header,
                         const Floors& floors) {
  const auto from = floors.find(folder), to = floors.find(folder_of(header));
  if (header.find('/') == std::string::npos || to == floors.end())
    return "does not name its floor, as in \"rotation/rotation.hpp\"";
  if (from == floors.end()) return "is included from a folder that is no floor";
  if (to->second > from->second)
    return "is on floor " + std::to_string(to->second) + ", above floor " +
           std::to_string(from->second);
  return "";
}

}  // namespace

Floors floors_of(const std::string& readme) {
  static const std::regex row(R"(^\| *(\d+) *\| *`(?:src/)?(\w+)/` *\|.*)");
  Floors floors;
  std::istringstream lines(readme);
  for (std::string line; std::getline(lines, line);)
    if (std::smatch m; std::regex_match(line, m, row)) floors[m[2]] = std::stoi(m[1]);
  return floors;
}

std::vector<std::string> include_faults(const std::string& path, const std::string& text,
                                        const Floors& floors) {
  static const std::regex include(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)");
  std::vector<std::string> faults;
  std::istringstream lines(text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    std::smatch m;
    if (!std::regex_match(line, m, include)) continue;
    const std::string fault = m[1] == "<" ? outside_fault(folder_of(path), m[2])
                                          : inside_fault(folder_of(path), m[2], floors);
    if (!fault.empty())
      faults.push_back(path + ":" + std::to_string(number) + ": " + m[2].str() + " " + fault);
  }
  return faults;
}

}  // namespace rotor::house
