#include "output/canvas.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <sstream>
#include <stdexcept>

#include "catch.hpp"

namespace rotor {
namespace {

using Values = std::vector<double>;
using Lines = std::vector<std::string>;
using All = std::vector<Series>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kPi = 3.14159265358979323846;

Values steps(double from, double to, int points) {
  Values x;
  for (int i = 0; i < points; ++i) x.push_back(from + (to - from) * i / (points - 1));
  return x;
}

Values of(const Values& x, const std::function<double(double)>& f) {
  Values y;
  for (double t : x) y.push_back(f(t));
  return y;
}

Lines lines(const std::string& picture) {
  Lines lines;
  std::istringstream in(picture);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// The rows between title and axis, from the top, without labels and axis.
Lines rows(const std::string& picture) {
  Lines rows;
  for (const std::string& line : lines(picture)) {
    const std::size_t axis = line.find('|');
    if (line.find("+--") != std::string::npos) break;
    if (axis != std::string::npos) rows.push_back(line.substr(axis + 1));
  }
  return rows;
}

TEST_CASE("plot: one series, literally") {
  const Values x = steps(0, 2 * kPi, 200);
  CHECK('\n' + plot(x, All{{"sin t", of(x, [](double t) { return std::sin(t); })}},
                    {.width = 46, .height = 10, .title = "A sine", .x_label = "t"}) ==
        R"(
                       A sine
sin t
 1.0 |       .----.
     |     .'      '-.
 0.5 |   .'           '.
     | .'              '.
 0.0 |'                  '.                 .-
     |                     '.              .'
-0.5 |                      '.           .'
     |                        '-.      .'
-1.0 |                           '----'
     +------+-----+------+-----+-----+-----+--
      0     1     2      3     4     5     6
                         t
)");
}

TEST_CASE("plot: several series, literally") {
  const Values x = steps(0, 10, 50);
  CHECK('\n' + plot(x,
                    All{{"ramp", x},
                        {"step", of(x, [](double t) { return t < 6 ? 2 : 8; })},
                        {"same", of(x, [](double t) { return t < 6 ? 2 : 8; })}},
                    {.width = 46, .height = 12, .title = "", .x_label = "t", .y_label = "m"}) ==
        R"(
m
10 |                                       ***
   |                                   ****
 8 |                         o+o+o++o*+o+o+o+o
   |                         o ****
 6 |                       **+*
   |                   ****  o
 4 |               ****      o
   |           ****         +
 2 |+o+o+o++o*+o+o+o+o+o+o+o+
   |   ****
 0 |***
   +--------+-------+--------+-------+-------+
    0       2       4        6       8      10
                        t
* ramp   + step   o same
)");
}

TEST_CASE("plot: logarithmic axes, literally") {
  CHECK('\n' +
            plot(Values{1e2, 1e3, 3e3, 1e4, 1e6},
                 All{{"fourth", {1e-1, kNaN, 1e-4, kNaN, 0}},
                     {"eighth", {kNaN, 1, kNaN, 1e-8, kNaN}}},
                 {.width = 46, .height = 11, .x_label = "calls", .log_x = true, .log_y = true}) ==
        R"(
1e+00 |          +
1e-01 |*
1e-02 |
1e-03 |
1e-04 |              *
1e-05 |
1e-06 |
1e-07 |
1e-08 |                   +
      +-------------------+------------------+
     1e+02              1e+04            1e+06
                        calls
* fourth   + eighth
)");
}

TEST_CASE("plot: a power law is a straight line where both axes are logarithmic") {
  // y = x^-2 over whole decades is the line -2 u over their logarithms u, of labels three
  // characters shorter.
  const Values u = steps(-2, 2, 200);
  const Values x = of(u, [](double e) { return std::pow(10, e); });
  const Lines power = rows(plot(x, All{{"", of(x, [](double t) { return 1 / (t * t); })}},
                                {.height = 17, .log_x = true, .log_y = true}));
  const Lines line =
      rows(plot(u, All{{"", of(u, [](double e) { return -2 * e; })}}, {.width = 77, .height = 17}));
  CHECK(power == line);
}

TEST_CASE("plot: marks are in the cells of the curve, labels at their values") {
  // Of two series, so that the marks are whole cells; the second is out of the way of the first.
  struct Ends {
    double low, high;
  };
  for (const Ends ends :
       {Ends{0, 70}, {-1e-3, 2e-3}, {1, 1 + 1e-12}, {1e9, 1e9 + 7}, {-3e200, 5e200}}) {
    const double low = ends.low;
    const double high = ends.high;
    CAPTURE(low, high);
    const Values x = steps(low, high, 1000);
    const std::string picture =
        plot(x, All{{"ramp", x}, {"low", of(x, [&](double) { return low; })}});
    CAPTURE(picture);
    std::size_t columns = 0;
    for (const std::string& row : rows(picture)) columns = std::max(columns, row.size());
    double last_label = kNaN;
    double row_size = kNaN;  // from two labels and the rows between them
    int since_label = 0;
    for (int pass = 0; pass < 2; ++pass) {
      for (const std::string& line : lines(picture)) {
        const std::size_t axis = line.find('|');
        if (axis == std::string::npos) continue;
        ++since_label;
        if (line.find_first_not_of(' ') == axis) continue;
        const double label = std::stod(line);
        if (pass == 0 && !std::isnan(last_label)) row_size = (last_label - label) / since_label;
        last_label = label;
        since_label = 0;
        const std::string marks = line.substr(axis + 1);
        for (std::size_t c = 0; pass == 1 && c < marks.size(); ++c) {
          if (marks[c] != '*') continue;
          // The row of a mark is that of the ramp in the middle of the column. Labels and sizes of
          // rows are doubles: off by an ulp of `high` each.
          const double y =
              low + (high - low) * static_cast<double>(c) / static_cast<double>(columns - 1);
          const double ulp = std::numeric_limits<double>::epsilon() * std::abs(high);
          REQUIRE(std::abs(y - label) <= row_size * (0.5 + 1e-9) + 4 * ulp);
        }
      }
    }
    REQUIRE(row_size > 0);
    REQUIRE(std::count(picture.begin(), picture.end(), '*') >= static_cast<int>(columns) - 2);
  }
}

TEST_CASE("plot: whatever the data, it fits, is ASCII, and has no blanks at line ends") {
  constexpr std::uint64_t kSeed = 5;
  std::mt19937_64 random(kSeed);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int trial = 0; trial < 1000; ++trial) {
    CAPTURE(kSeed, trial);
    PlotOptions options{.width = 40 + trial % 60, .height = 5 + trial % 30};
    if (trial % 2 == 0) options.title = std::string(static_cast<std::size_t>(trial % 120), 'T');
    if (trial % 3 == 0) options.x_label = options.y_label = options.title;
    const std::size_t points = 1 + random() % 300;
    Values x;
    for (std::size_t i = 0; i < points; ++i)
      x.push_back(uniform(-1, 1) * std::pow(10, uniform(-3, 3)));
    std::sort(x.begin(), x.end());
    All series(1 + random() % 10);
    const double size = std::pow(10, uniform(-320, 305));
    for (Series& one : series) {
      one.name = std::string(random() % 50, 'n');
      for (std::size_t i = 0; i < points; ++i)
        one.y.push_back(random() % 10 == 0 ? kNaN : size * uniform(-1000, 1000));
    }
    series[0].y[0] = size;
    const std::string picture = plot(x, series, options);
    CAPTURE(picture);
    REQUIRE(picture.back() == '\n');
    REQUIRE(std::all_of(picture.begin(), picture.end(),
                        [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); }));
    REQUIRE(rows(picture).size() <= static_cast<std::size_t>(options.height));
    for (const std::string& line : lines(picture)) {
      REQUIRE(line.size() <= static_cast<std::size_t>(options.width));
      REQUIRE((line.empty() || line.back() != ' '));
    }
  }
}

TEST_CASE("plot: a constant is a straight line at its value") {
  for (const double value : {3.0, -3.0, 0.0}) {
    const Values x = steps(0, 1, 10);
    const std::string picture = plot(x, All{{"", Values(10, value)}});
    CAPTURE(picture);
    for (const std::string& line : lines(picture)) {
      const std::size_t axis = line.find('|');
      if (axis == std::string::npos || axis + 1 == line.size()) continue;
      CHECK(std::stod(line) == value);
      CHECK(line.substr(axis + 1) == std::string(80 - axis - 1, '-'));
    }
    CHECK(picture.find("|--") != std::string::npos);
  }
}

TEST_CASE("plot: x may run either way") {
  const Values x = steps(0, 5, 100);
  const Values y = of(x, [](double t) { return t * std::sin(t); });
  CHECK(plot(x, All{{"", y}}) ==
        plot(Values(x.rbegin(), x.rend()), All{{"", Values(y.rbegin(), y.rend())}}));
}

TEST_CASE("plot: nan and infinities are gaps") {
  const Values x = steps(0, 73, 74);  // a column each, beside labels of four characters
  Values y(74, 0.25);
  for (std::size_t i = 20; i < 30; ++i) y[i] = i % 2 == 0 ? kNaN : kInfinity;
  y[25] = 0.25;
  y[73] = 0.75;
  const std::string picture = plot(x, All{{"", y}}, {.width = 79});
  CAPTURE(picture);
  bool found = false;
  for (const std::string& row : rows(picture)) {
    if (row.size() < 20 || row[10] == ' ') continue;
    found = true;
    CHECK(row[19] != ' ');
    CHECK(row.substr(20, 10) == "     *    ");
    CHECK(row[30] != ' ');
  }
  CHECK(found);
}

TEST_CASE("plot: a gap inside a column is not bridged") {
  const Values x = steps(-1, 1, 2001);
  const Values pole = of(x, [](double t) { return std::abs(t) < 1e-9 ? kNaN : t < 0 ? -1 : 1; });
  const Lines drawn = rows(plot(x, All{{"", pole}}));
  CHECK_FALSE(drawn.front().empty());
  CHECK_FALSE(drawn.back().empty());
  for (std::size_t i = 1; i + 1 < drawn.size(); ++i) CHECK(drawn[i].empty());
}

TEST_CASE("plot: one point, the smallest and the largest doubles") {
  const auto stars = [](const std::string& picture) {
    return std::count(picture.begin(), picture.end(), '*');
  };
  constexpr double kLargest = std::numeric_limits<double>::max();
  for (const double x : {0.0, 5e-324, 1.0, -kLargest})
    for (const double y : {0.0, 5e-324, -1.0, kLargest})
      CHECK(stars(plot(Values{x}, All{{"", {y}}})) == 1);
  CHECK_FALSE(plot(Values{-kLargest, kLargest}, All{{"", {-kLargest, kLargest}}}).empty());
  CHECK_FALSE(plot(Values{0, 5e-324}, All{{"", {0, 5e-324}}}).empty());
}

TEST_CASE("plot: names in UTF-8 count by characters") {
  const std::string picture =
      plot(Values{0, 1}, All{{"θ", {0, 1}}, {"ω", {1, 0}}}, {.width = 30, .y_label = "φ"});
  CHECK(picture.starts_with("φ\n"));
  CHECK(picture.ends_with("\n* θ   + ω\n"));
}

TEST_CASE("plot: a long legend goes on in the next line") {
  All series;
  for (int i = 0; i < 5; ++i) series.push_back({"series " + std::to_string(i), {0, 1.0 * i}});
  CHECK(plot(Values{0, 1}, series, {.width = 40})
            .ends_with("\n* series 0   + series 1   o series 2\nx series 3   # series 4\n"));
}

TEST_CASE("plot: what cannot be drawn is said") {
  const auto said = [](const Values& x, const All& series, const PlotOptions& options = {}) {
    try {
      plot(x, series, options);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  CHECK(said({}, {{"a", {}}}) == "plot: no finite value to draw");
  CHECK(said({1}, {}) == "plot: no series to draw");
  CHECK(said({1, 2}, {{"a", {kNaN, kInfinity}}}) == "plot: no finite value to draw");
  CHECK(said({1, 2}, {{"a", {1}}}) == "plot: x has 2 values, series \"a\" has 1");
  CHECK(said({1, kNaN}, {{"a", {1, 2}}}) == "plot: x must be finite, point 2 is nan");
  CHECK(said({1, 3, 2, 4}, {{"a", {1, 2, 3, 4}}}) ==
        "plot: x must be monotone, point 3 turns back from 3.0 to 2.0");
  CHECK(said({4, 2, 3, 1}, {{"a", {1, 2, 3, 4}}}) ==
        "plot: x must be monotone, point 3 turns back from 2.0 to 3.0");
  CHECK(said({1, 2}, {{"a", {0, -1}}}, {.log_y = true}) ==
        "plot: no finite positive value to draw");
  CHECK(said({1, 0}, {{"a", {1, 1}}}, {.log_x = true}) ==
        "plot: x must be positive on a logarithmic axis, point 2 is 0.0");
  CHECK(said({1}, All(11, {"a", {1}})) == "plot: at most 10 series, got 11");
  CHECK(said({0, 1}, {{"a", {0, 1}}}, {.height = 4}) == "plot: height must be at least 5, got 4");
  CHECK(said({0, 1}, {{"a", {0, 1}}}, {.width = 14}) ==
        "plot: width must be at least 15 with these labels, got 14");
  CHECK(said({0, 1}, {{"a", {0, 1}}}, {.width = -1}) ==
        "plot: width must be at least 15 with these labels, got -1");
  CHECK(said({0, 1}, {{"a", {0, 1}}}, {.width = 15}) == "nothing");
}

}  // namespace
}  // namespace rotor
