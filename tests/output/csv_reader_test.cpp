#include "output/csv_reader.hpp"

#include <bit>
#include <clocale>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <system_error>

#include "catch.hpp"
#include "output/columns.hpp"
#include "output/file.hpp"
#include "temporary.hpp"

namespace rotor {
namespace {

using Numbers = std::vector<double>;
using Words = std::vector<std::string>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

class File {
 public:
  explicit File(std::string_view content) { write_file(path(), content); }
  std::filesystem::path path() const { return here_.path / "data.csv"; }
  CsvTable read() const { return read_csv(path()); }
  std::string error(const std::string& what) const { return path().string() + ": " + what; }

 private:
  TemporaryDirectory here_;
};

Numbers numbers(const CsvTable& table, const std::string& name) {
  return table.numbers(table.column(name));
}
Words words(const CsvTable& table, const std::string& name) {
  return std::get<Words>(table.column(name).values);
}

TEST_CASE("CSV in: names, numbers and words") {
  const File file("t, angle_rad ,who\n0,1.5,a\n 1 ,\t-2e-3,\" b \"\n");
  const CsvTable table = file.read();
  CHECK(numbers(table, "t") == Numbers{0, 1});
  CHECK(numbers(table, "angle_rad") == Numbers{1.5, -2e-3});
  CHECK(words(table, "who") == Words{"a", " b "});
  CHECK(table.lines == std::vector<std::size_t>{2, 3});
  CHECK_THROWS_WITH(table.column("x"), "unknown column 'x'; there are t, angle_rad, who");
  CHECK_THROWS_WITH(numbers(table, "who"),
                    file.error("line 2: 'who': expected a number, got \"a\""));
}

TEST_CASE("CSV in: line ends, byte order mark and blank lines at the end do not matter") {
  for (const char* content : {"a,b\n1,2\n", "a,b\n1,2", "a,b\r\n1,2\r\n", "a,b\r\n1,2",
                              "\xEF\xBB\xBF"
                              "a,b\n1,2\n\n\r\n",
                              "\"a\",\"b\"\r\n\"1\",\"2\"\r\n", "\"a\",b\n1,\"2\""}) {
    INFO(content);
    const CsvTable table = File(content).read();
    CHECK(table.columns.size() == 2);
    CHECK(numbers(table, "a") == Numbers{1});
    CHECK(numbers(table, "b") == Numbers{2});
  }
}

TEST_CASE("CSV in: quotes hold separators, line ends and quotes") {
  const CsvTable table =
      File("\"a,\"\"b\"\"\",c\n\"1\n2\",\"\"\"\"\nx,\"\"\n\"\",5\" pipe\n").read();
  CHECK(words(table, "a,\"b\"") == Words{"1\n2", "x", ""});
  CHECK(words(table, "c") == Words{"\"", "", "5\" pipe"});
  CHECK(table.lines == std::vector<std::size_t>{2, 4, 5});
}

TEST_CASE("CSV in: what is a number") {
  const CsvTable table =
      File("x,y,z,w\nnan,NaN,0x1,\ninf,+1,1,\n-inf,,2,\nInfinity,-0,3,\n").read();
  const Numbers x = numbers(table, "x");
  CHECK(std::isnan(x[0]));
  CHECK(Numbers(x.begin() + 1, x.end()) == Numbers{kInfinity, -kInfinity, kInfinity});
  const Numbers y = numbers(table, "y");
  CHECK((std::isnan(y[0]) && std::isnan(y[2]) && y[1] == 1 && std::signbit(y[3])));
  CHECK(words(table, "z") == Words{"0x1", "1", "2", "3"});
  CHECK(words(table, "w") == Words{"", "", "", ""});
  CHECK(words(File("a\n+-1\n").read(), "a") == Words{"+-1"});
  CHECK(numbers(File("a,b\n").read(), "b").empty());
}

TEST_CASE("CSV in: what is no table is said, with the line") {
  const auto refuses = [](std::string_view content, const std::string& message) {
    const File file(content);
    CAPTURE(content);
    CHECK_THROWS_WITH(file.read(), file.error(message));
  };
  using namespace std::string_view_literals;
  refuses("", "expected a header row of names, got an empty file");
  refuses("\xEF\xBB\xBF\r\n\n", "expected a header row of names, got an empty file");
  refuses("\na\n1\n", "line 1: expected a header row of names, got a blank line");
  refuses("0.5,1\n2,3\n", "line 1: expected a header row of names, got '0.5'");
  refuses("a,b, a\n", "line 1: two columns have the name 'a'");
  refuses("a,b\n1,2\n3\n", "line 3: expected 2 fields, as the header has, got 1");
  refuses("a,b\n1,2,\n", "line 2: expected 2 fields, as the header has, got 3");
  refuses("a,b\n1,2\n\n3,4\n", "line 3: expected 2 fields, as the header has, got 1");
  refuses("a,b\r1,2\r", "line 1: expected lines that end in LF or CRLF, got a CR alone");
  refuses("a\n\"1\n\n2\n", "line 2: a quote that is not closed");
  refuses("a\n\"1\"\"", "line 2: a quote that is not closed");
  refuses("a\n\"", "line 2: a quote that is not closed");
  refuses("a\n\"1\n\"2\n", "line 3: text after a closing quote");
  refuses("a\n1\n1e400\n", "line 3: 'a' is 1e400, out of the range of doubles");
  refuses("a\n1\n\0"sv,
          "line 3: expected text, got a NUL byte: this is a binary file, or one in UTF-16");
  CHECK_THROWS_AS(read_csv("/dev/zero"), std::invalid_argument);
  CHECK_THROWS_WITH(read_csv("/no/such.csv"), "/no/such.csv: No such file or directory");
  CHECK_THROWS_WITH(read_csv("/"), "/: Is a directory");
}

TEST_CASE("CSV in: another separator, and a header that seems to have one") {
  CHECK(numbers(read_csv(File("a;b,c\n1;2\n").path(), {}, ';'), "b,c") == Numbers{2});
  CHECK(words(read_csv(File("a\t\"b\"\n\"1\t2\"\t3\n").path(), {}, '\t'), "a") == Words{"1\t2"});
  const auto message = [](const File& file, char separator) -> std::string {
    try {
      read_csv(file.path(), {}, separator);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  const File semicolons("time;x;y\n1,5;2;3\n");
  CHECK(message(semicolons, ',') ==
        semicolons.error("line 1: one column, 'time;x;y': separated by ';'? give separator = "
                         "\";\""));
  CHECK(message(semicolons, '\t') == message(semicolons, ','));
  CHECK(message(semicolons, ';').empty());
  CHECK(message(File("t\tx\n0\t1\n"), ',')
            .ends_with("'t\tx': separated by '\\t'? give separator = "
                       "\"\\t\""));
  CHECK(message(File("t,x\n0,1\n"), ';').ends_with("give separator = \",\""));
  CHECK(message(File("\"a;b\"\n1\n"), ',').empty());
  for (const char bad : {'"', '\n', '\r'})
    CHECK(message(semicolons, bad) == "separator: expected no quote and no line end");
}

TEST_CASE("CSV: a column whose name has a separator in it reads back") {
  TemporaryDirectory here;
  for (const char* name : {"a;b", "a\tb", "a,b"}) {
    const std::vector<CsvColumn> columns = {{name, Numbers{1}}};
    write_csv(here.path / "data.csv", columns);
    CHECK(numbers(read_csv(here.path / "data.csv"), name) == Numbers{1});
  }
}

TEST_CASE("CSV in: an observer stops the reading") {
  const File file("a\n1\n");
  int calls = 0;
  for (int stop = 1; stop <= 3; ++stop) {
    calls = 0;
    CHECK_THROWS_AS(read_csv(file.path(), [&](double) { return ++calls < stop; }), Interrupted);
  }
}

TEST_CASE("CSV: what is written reads back bit for bit, whatever the locale") {
  constexpr std::uint64_t kSeed = 20240522;
  CAPTURE(kSeed);
  std::mt19937_64 random(kSeed);
  Numbers x = {5e-324, -0.0, kInfinity, -kInfinity, 1.7e308, 2.2250738585072014e-308, 0.1};
  Words names;
  while (x.size() < 20000) {
    const double next = std::bit_cast<double>(random());
    if (!std::isnan(next)) x.push_back(next);
  }
  x.push_back(std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < x.size(); ++i)
    names.push_back(i % 3 == 0 ? "" : i % 3 == 1 ? "a, \"b\"\r\nc" : "  \xCF\x89 ");
  TemporaryDirectory here;
  const auto file = here.path / "data.csv";
  // Decimal commas, where the machine has such a locale.
  std::setlocale(LC_ALL, "de_DE.UTF-8");
  const std::vector<CsvColumn> columns = {{"x", x}, {"name", names}};
  CHECK(write_csv(file, columns) == x.size());
  const CsvTable table = read_csv(file);
  std::setlocale(LC_ALL, "C");
  const Numbers back = numbers(table, "x");
  REQUIRE(back.size() == x.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const bool same = std::bit_cast<std::uint64_t>(x[i]) == std::bit_cast<std::uint64_t>(back[i]);
    if (!same && !(std::isnan(x[i]) && std::isnan(back[i]))) ++different;
  }
  CHECK(different == 0);
  CHECK(words(table, "name") == names);
}

TEST_CASE("CSV: columns that make no table are not written") {
  TemporaryDirectory here;
  const auto file = here.path / "data.csv";
  const std::vector<CsvColumn> ragged = {{"t", Numbers{1, 2}}, {"x", Words{"a"}}};
  CHECK_THROWS_WITH(write_csv(file, ragged),
                    "expected columns of one length, got 2 values in 't' and 1 in 'x'");
  CHECK_THROWS_WITH(write_csv(file, {}), file.string() + ": a CSV file needs at least one column");
  const std::vector<CsvColumn> one = {{"t", Numbers{1}}};
  CHECK_THROWS_WITH(write_csv("/dev/full", one), "/dev/full: No space left on device");
  CHECK(here.entries() == 0);
}

}  // namespace
}  // namespace rotor
