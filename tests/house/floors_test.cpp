#include <filesystem>
#include <fstream>
#include <iterator>

#include "catch.hpp"
#include "house/floors.hpp"

namespace fs = std::filesystem;
using namespace rotor::house;

namespace {

const fs::path kSource = fs::path(ROTOR_SOURCE_DIR) / "src";

std::string read(const fs::path& path) {
  std::ifstream file(path);
  REQUIRE(file);
  return {std::istreambuf_iterator<char>(file), {}};
}

bool is_cpp(const fs::path& path) {
  return path.extension() == ".cpp" || path.extension() == ".hpp";
}

/// Every C++ file of src/ with its text, by its path relative to src/.
std::map<std::string, std::string> sources() {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(kSource))
    if (is_cpp(entry.path()))
      files[entry.path().lexically_relative(kSource).generic_string()] = read(entry.path());
  return files;
}

}  // namespace

TEST_CASE("every #include of src/ obeys the floor table") {
  const Floors floors = floors_of(read(kSource / "README.md"));
  std::vector<std::string> faults;
  for (const auto& [path, text] : sources())
    for (const auto& fault : include_faults(path, text, floors)) faults.push_back(fault);
  CHECK(faults == std::vector<std::string>{});
}

TEST_CASE(
    "every folder of src/ is a floor of the table, and the floors are numbered 0, 1, 2, ...") {
  const Floors floors = floors_of(read(kSource / "README.md"));
  for (const auto& entry : fs::directory_iterator(kSource))
    if (entry.is_directory()) {
      CAPTURE(entry.path());
      CHECK(floors.contains(entry.path().filename().string()));
    }
  std::vector<bool> taken(floors.size());
  for (const auto& [folder, floor] : floors) {
    CAPTURE(folder, floor);
    taken.at(static_cast<std::size_t>(floor)) = true;
  }
  CHECK(taken == std::vector<bool>(floors.size(), true));
}

TEST_CASE("one file alone includes readline") {
  std::vector<std::string> users;
  for (const auto& [path, text] : sources())
    if (text.find("#include <readline/") != std::string::npos) users.push_back(path);
  CAPTURE(users);
  CHECK(users.size() == 1);
}

TEST_CASE("the floor table is read as it is written") {
  const Floors floors = floors_of(
      "| floor | folder | holds |\n|---|---|---|\n| 0 | `cellar/` | wine |\n| 1 | `hall/` | a "
      "`bell/` |\n");
  CHECK(floors == Floors{{"cellar", 0}, {"hall", 1}});
}

TEST_CASE("the include rules find what breaks them") {
  const Floors floors{{"rotation", 0}, {"spin", 1}, {"script", 6}, {"app", 7}};
  const auto faults = [&](const std::string& path, const std::string& line) {
    return include_faults(path, "#pragma once\n" + line + "\n", floors);
  };
  const auto good = [&](const std::string& path, const std::string& line) {
    CAPTURE(path, line);
    CHECK(faults(path, line) == std::vector<std::string>{});
  };
  const auto bad = [&](const std::string& path, const std::string& line) {
    CAPTURE(path, line);
    CHECK(faults(path, line).size() == 1);
  };
  good("spin/spin.hpp", "#include \"rotation/rotation.hpp\"");
  good("spin/spin.hpp", "#include \"spin/jet.hpp\"");
  good("spin/spin.hpp", "#include <unistd.h>");
  good("rotation/chart.cpp", "#include <Eigen/Core>");
  good("rotation/chart.cpp", "#include <vector>");
  good("script/state.cpp", "#include <lua.hpp>");
  good("app/reader.cpp", "#include <readline/readline.h>");
  good("spin/spin.hpp", "// #include \"app/main.hpp\" would be wrong");

  bad("rotation/chart.cpp", "#include \"spin/jet.hpp\"");
  bad("spin/spin.hpp", "  #  include \"app/help.hpp\"  // upwards");
  bad("spin/spin.hpp", "#include \"jet.hpp\"");
  bad("spin/spin.hpp", "#include \"attic/jet.hpp\"");
  bad("attic/dust.cpp", "#include \"spin/jet.hpp\"");
  bad("spin/spin.hpp", "#include <lua.hpp>");
  bad("spin/spin.hpp", "#include <lua5.4/lauxlib.h>");
  bad("script/state.cpp", "#include <readline/history.h>");
  bad("rotation/chart.cpp", "#include <unistd.h>");
  bad("rotation/chart.cpp", "#include <boost/numeric/odeint.hpp>");
  CHECK(faults("rotation/chart.cpp", "#include \"spin/jet.hpp\"").front() ==
        "rotation/chart.cpp:2: spin/jet.hpp is on floor 1, above floor 0");
}
