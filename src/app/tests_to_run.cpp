#include "app/tests_to_run.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace rotor::app {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> lua_files(const fs::path& directory) {
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(directory)) {
    if (entry.is_regular_file() && entry.path().extension() == ".lua") {
      files.push_back(entry.path().string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::vector<std::string> tests_to_run(const std::vector<std::string>& paths) {
  std::vector<std::string> files;
  for (const std::string& path : paths) {
    if (!fs::exists(path)) throw std::runtime_error("--test: there is no '" + path + "'");
    if (!fs::is_directory(path)) {
      files.push_back(path);
      continue;
    }
    const std::vector<std::string> found = lua_files(path);
    files.insert(files.end(), found.begin(), found.end());
  }
  if (files.empty()) {
    throw std::runtime_error("--test: no file *.lua in '" + paths.front() +
                             (paths.size() > 1 ? "' and the others" : "'"));
  }
  return files;
}

}  // namespace rotor::app
