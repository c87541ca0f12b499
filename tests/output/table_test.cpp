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
  CHECK(number_table({"a"}, {}, 17, true) == "i  a\n-  -\n");
}

TEST_CASE("table: columns that do not fit stand in blocks below, each with the first column") {
  const std::vector<std::vector<double>> rows{{0, 1.0 / 3, 2.0 / 3, 7}, {0.5, 12, -0.5, 7}};
  // With 6 digits t, a and b take 3 + 2 + 9 + 2 + 9 = 25 and make two blocks. With 9 (two before
  // the point or a sign and a digit, the point, nine behind it) these take 17 and 17 + 2 + 3 = 22.
  CHECK(number_table({"t", "a", "b", "c"}, rows, 17, false, 22) ==
        "  t             a\n"
        "---  ------------\n"
        "0.0   0.333333333\n"
        "0.5  12.0\n"
        "\n"
        "  t             b    c\n"
        "---  ------------  ---\n"
        "0.0   0.666666667  7.0\n"
        "0.5  -0.5          7.0\n");
  // What is too wide stands beside the first column alone, with 6 digits.
  CHECK(number_table({"a", "b"}, {}, 17, true, 1) ==
        "i  a\n"
        "-  -\n"
        "\n"
        "i  b\n"
        "-  -\n");
  CHECK(number_table({"a"}, rows, 17, false, 1) == number_table({"a"}, rows, 17));
}

}  // namespace
}  // namespace rotor
