#include "output/csv.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>
#include <stdexcept>

#include <vector>

#include "catch.hpp"
#include "temporary.hpp"

namespace rotor {
namespace {

using Names = std::vector<std::string>;
using Values = std::vector<double>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST_CASE("CSV: a small file, literally") {
  TemporaryDirectory here;
  CsvWriter csv(here.path / "run.csv", Names{"t", "angle_rad", "axis_x"});
  csv.row(Values{0, 0.1, -1});
  csv.row(Values{-0.0, 1.0 / 3, 1e-300});
  csv.row(Values{kNaN, kInfinity, -kInfinity});
  csv.row(Values{std::copysign(kNaN, -1), 5e-324, -2.2250738585072014e-308});
  CHECK(csv.rows() == 4);
  CHECK_FALSE(std::filesystem::exists(here.path / "run.csv"));
  csv.commit();
  CHECK(content_of(here.path / "run.csv") ==
        "t,angle_rad,axis_x\n"
        "0,0.1,-1\n"
        "-0,0.3333333333333333,1e-300\n"
        "nan,inf,-inf\n"
        "nan,5e-324,-2.2250738585072014e-308\n");
}

TEST_CASE("CSV: names that need quotes have them") {
  TemporaryDirectory here;
  CsvWriter csv(here.path / "run.csv", Names{"a b", "a,b", "\"a\"", "a\nb", "a\rb", ""});
  csv.commit();
  CHECK(content_of(here.path / "run.csv") == "a b,\"a,b\",\"\"\"a\"\"\",\"a\nb\",\"a\rb\",\"\"\n");
}

TEST_CASE("CSV: every double reads back as itself, through a buffer many times full") {
  TemporaryDirectory here;
  constexpr std::uint64_t kSeed = 20240501;
  CAPTURE(kSeed);
  std::mt19937_64 random(kSeed);
  std::vector<Values> rows(40000, Values(3));
  CsvWriter csv(here.path / "run.csv", Names{"a", "b", "c"});
  for (Values& row : rows) {
    for (double& x : row) x = std::bit_cast<double>(random());
    csv.row(row);
  }
  csv.commit();
  const std::string text = content_of(here.path / "run.csv");
  const char* at = text.c_str() + std::string("a,b,c\n").size();
  std::size_t different = 0;
  for (const Values& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      char* end = nullptr;
      const double x = std::strtod(at, &end);
      const bool same = std::isnan(row[i]) ? std::isnan(x)
                                           : std::bit_cast<std::uint64_t>(x) ==
                                                 std::bit_cast<std::uint64_t>(row[i]);
      if (!same || *end != (i + 1 < row.size() ? ',' : '\n')) ++different;
      at = end + 1;
    }
  }
  CHECK(different == 0);
  CHECK(at == text.c_str() + text.size());
}

TEST_CASE("CSV: a header longer than the buffer") {
  TemporaryDirectory here;
  const std::string name(100000, 'n');
  const std::string other(100000, 'o');
  CsvWriter csv(here.path / "run.csv", Names{name, other});
  csv.row(Values{1, 2});
  csv.row(Values{3, 4});
  csv.commit();
  CHECK(content_of(here.path / "run.csv") == name + "," + other + "\n1,2\n3,4\n");
}

TEST_CASE("CSV: misuse is said") {
  TemporaryDirectory here;
  const std::string file = (here.path / "run.csv").string();
  CHECK_THROWS_WITH(CsvWriter(file, Names{}), file + ": a CSV file needs at least one column");
  CHECK_THROWS_WITH(CsvWriter(file, Names{"a", "b", "a"}),
                    file + ": two columns have the name 'a'");
  CsvWriter csv(file, Names{"a", "b"});
  CHECK_THROWS_WITH(csv.row(Values{1, 2, 3}),
                    file + ": a row has 3 values, the header has 2 names");
  CHECK(csv.rows() == 0);
  csv.commit();
  CHECK_THROWS_AS(csv.row(Values{1, 2}), std::logic_error);
  CHECK_THROWS_AS(csv.commit(), std::logic_error);
  CHECK(content_of(file) == "a,b\n");
}

TEST_CASE("CSV: numbers and words, cell by cell") {
  TemporaryDirectory here;
  CsvWriter csv(here.path / "run.csv", Names{"x", "name"});
  csv.cell(0.5);
  csv.cell(std::string("a,b"));
  csv.end_row();
  csv.cell(kNaN);
  CHECK_THROWS_AS(csv.end_row(), std::invalid_argument);
}

TEST_CASE("CSV: a full device fails, at the latest in commit") {
  CsvWriter csv("/dev/full", Names{"a"});
  csv.row(Values{1});
  CHECK_THROWS_WITH(csv.commit(), "/dev/full: No space left on device");
  CHECK_THROWS_AS(csv.commit(), std::logic_error);
}

TEST_CASE("CSV: without commit there is no file") {
  TemporaryDirectory here;
  {
    CsvWriter csv(here.path / "run.csv", Names{"a"});
    for (int i = 0; i < 100000; ++i) csv.row(Values{0.5});
    CHECK(here.entries() == 1);
  }
  CHECK(here.entries() == 0);
}

}  // namespace
}  // namespace rotor
