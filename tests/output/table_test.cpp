#include "output/table.hpp"

#include "catch.hpp"

namespace rotor {
namespace {

using Names = std::vector<std::string>;
using Rows = std::vector<std::vector<std::string>>;

TEST_CASE("table: numbers stand point below point, words to the left") {
  const Rows rows{{"dop853", "1312", "1.5e-16", "0.5"},
                  {"rk4", "8", "12.25", "nan"},
                  {"exact", "100", "-inf", ""},
                  {"a", "", "1e-300"}};
  CHECK(table(Names{"method", "calls", "error", "x"}, rows) ==
        "method  calls     error    x\n"
        "------  -----  --------  ---\n"
        "dop853   1312   1.5e-16  0.5\n"
        "rk4         8  12.25     nan\n"
        "exact     100      -inf\n"
        "a               1e-300\n");
}

TEST_CASE("table: alignment as asked") {
  const Rows rows{{"1", "ab", "x 1.5"}, {"100", "abc", "10.25"}};
  const std::vector<Align> alignment{Align::kLeft, Align::kRight, Align::kPoint};
  CHECK(table(Names{"n", "name", "point"}, rows, alignment) ==
        "n    name   point\n"
        "---  ----  ------\n"
        "1      ab  x 1.5\n"
        "100   abc   10.25\n");
}

TEST_CASE("table: what is counted is characters") {
  CHECK(table(Names{"θ", "ω in rad/s"}, Rows{{"1.5", "é"}, {"2.5", "€"}}) ==
        "  θ  ω in rad/s\n"
        "---  ----------\n"
        "1.5  é\n"
        "2.5  €\n");
}

TEST_CASE("table: empty things") {
  CHECK(table(Names{"a", "bc"}, Rows{}) == "a  bc\n-  --\n");
  CHECK(table(Names{"a"}, Rows{{}}) == "a\n-\n\n");
}

TEST_CASE("table: a row longer than the header is refused") {
  CHECK_THROWS_WITH(table(Names{"a"}, Rows{{"1"}, {"1", "2"}}),
                    "table: row 2 has 2 cells, the header has 1");
}

TEST_CASE("table: numbers lose the digits that do not fit, and keep six") {
  const std::vector<std::vector<double>> rows{{1.0 / 3, 2.0 / 3}, {12, -0.5}};
  CHECK(number_table({"a", "b"}, rows, 17) ==
        "                  a                    b\n"
        "-------------------  -------------------\n"
        " 0.3333333333333333   0.6666666666666666\n"
        "12.0                 -0.5\n");
  // Two columns of 9 and two blanks between: a sign, two digits before the point, six behind it.
  const std::string seven =
      "i          a          b\n"
      "-  ---------  ---------\n"
      "1   0.333333   0.666667\n"
      "2  12.0       -0.5\n";
  CHECK(number_table({"a", "b"}, rows, 17, true, 23) == seven);
  CHECK(number_table({"a", "b"}, rows, 17, true, 1) == seven);
  CHECK(number_table({"a"}, {}, 17, true) == "i  a\n-  -\n");
}

}  // namespace
}  // namespace rotor
