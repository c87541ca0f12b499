// What may be wrong with a log, said by row.
#include "spin/samples.hpp"

#include <limits>

#include "refusal.hpp"

using namespace rotor;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Rows of a file with a header line; omega is (x, 0, 0).
Samples log_of(const std::vector<std::pair<double, double>>& rows) {
  Samples samples{"gyro.csv", {}};
  for (const auto& [t, x] : rows) {
    const std::size_t row = samples.rows.size() + 1;
    samples.rows.push_back({t, {x, 0, 0}, row, row + 1});
  }
  return samples;
}

std::vector<std::pair<double, double>> rows_of(const Samples& samples) {
  std::vector<std::pair<double, double>> rows;
  for (const Sample& sample : samples.rows) rows.emplace_back(sample.t, sample.omega.x());
  return rows;
}
using Rows = std::vector<std::pair<double, double>>;

}  // namespace

TEST_CASE("a clean log stays as it is") {
  const Samples log = log_of({{-1, 1}, {0, -0.0}, {5e-324, 3}, {1e300, 1e300}});
  CHECK(rows_of(cleaned(log)) == rows_of(log));
}

TEST_CASE("missing numbers are listed by row, or left out") {
  const Samples log =
      log_of({{0, 1}, {1, kNaN}, {kNaN, 1}, {2, 3}, {3, kInfinity}, {kInfinity, 0}, {4, 1}});
  refused([&] { cleaned(log); },
          {"gyro.csv: 4 rows", "row 2 (line 3) t = 1.0, omega (nan, 0.0, 0.0)", "row 3 (line 4)",
           "row 5 (line 6)", "; ...", "missing = \"skip\""});
  CHECK(refusal([&] { cleaned(log); }).find("row 6") == std::string::npos);
  CHECK(rows_of(cleaned(log, {.skip_missing = true})) == Rows{{0, 1}, {2, 3}, {4, 1}});
  CHECK(cleaned(log, {.skip_missing = true}).rows[1].row == 4);
}

TEST_CASE("times that go back are listed by row, or sorted") {
  const Samples log = log_of({{0, 1}, {2, 2}, {1, 3}, {3, 4}, {-1, 5}});
  refused([&] { cleaned(log); }, {"goes back 2 times", "row 3 (line 4) t = 1.0 after 2.0",
                                  "row 5 (line 6)", "order = \"sort\""});
  const Samples sorted = cleaned(log, {.sort = true});
  CHECK(rows_of(sorted) == Rows{{-1, 5}, {0, 1}, {1, 3}, {2, 2}, {3, 4}});
  CHECK(sorted.rows[0].row == 5);
  CHECK(sorted.rows[0].line == 6);
}

TEST_CASE("rows of one time are listed, or made one") {
  using enum Cleaning::Duplicates;
  const Samples log = log_of({{0, 1}, {1, 2}, {1, 4}, {1, 9}, {2, 0}, {2, 1}});
  refused([&] { cleaned(log); },
          {"3 rows with the time of another", "row 3 (line 4) t = 1.0 as row 2",
           "row 6 (line 7) t = 2.0 as row 5", "duplicates = \"first\""});
  CHECK(rows_of(cleaned(log, {.duplicates = kFirst})) == Rows{{0, 1}, {1, 2}, {2, 0}});
  CHECK(rows_of(cleaned(log, {.duplicates = kMean})) == Rows{{0, 1}, {1, 5}, {2, 0.5}});
  // After sorting, those that are apart too: the first of the log comes first.
  const Samples apart = log_of({{0, 1}, {1, 2}, {0, 3}});
  refused([&] { cleaned(apart); }, {"goes back 1 time:", "1 row with the time of another"});
  refused([&] { cleaned(apart, {.sort = true}); }, {"gyro.csv: 1 row with the time of another"});
  CHECK(rows_of(cleaned(apart, {.sort = true, .duplicates = kFirst})) == Rows{{0, 1}, {1, 2}});
  CHECK(rows_of(cleaned(log_of({{0.0, 1}, {-0.0, 3}, {1, 0}}), {.duplicates = kMean})) ==
        Rows{{0, 2}, {1, 0}});
}

TEST_CASE("fewer than two rows are no log") {
  refused([] { cleaned(log_of({})); }, {"at least two rows, got 0"});
  refused([] { cleaned(log_of({{1, 1}})); }, {"at least two rows, got 1"});
  refused([] { cleaned(log_of({{1, 1}, {2, kNaN}}), {.skip_missing = true}); }, {"got 1"});
  refused([] { cleaned(Samples{}); }, {"expected"});
}

TEST_CASE("gaps are intervals longer than so many usual ones") {
  const Samples log = log_of({{0, 0}, {1, 0}, {2, 0}, {5, 0}, {6, 0}, {7, 0}, {107, 0}});
  CHECK(usual_interval(log) == 1);
  const std::vector<Gap> three = gaps(log, 10);
  REQUIRE(three.size() == 1);
  CHECK(three[0].row == 6);
  CHECK(three[0].line == 7);
  CHECK(three[0].from == 7);
  CHECK(three[0].to == 107);
  CHECK(gaps(log, 2).size() == 2);
  CHECK(gaps(log, 3).size() == 1);  // as long is not longer
  CHECK(gaps(log, kInfinity).empty());
  CHECK(gaps(log_of({{0, 0}, {1, 0}}), 1).empty());
  for (const double bad : {0.0, 0.99, -1.0, kNaN})
    refused([&] { gaps(log, bad); }, {"gap:", "1 or more"});
  CHECK(
      report_of(three, log, 10) ==
      "gyro.csv: 1 interval longer than 10.0 times the usual 1.0: after row 6 (line 7), t = 7.0 .. "
      "107.0");
  CHECK(report_of({}, log, 10).empty());
}
