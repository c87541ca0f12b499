#include "output/trace.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "catch.hpp"

namespace rotor {
namespace {

using Points = std::vector<GridPoint>;

/// A curve from left to right: smooth if many points share a column, jagged if few do, with
/// vertical jumps.
Points random_curve(std::mt19937_64& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  Points points;
  const double pace = std::pow(10, uniform(-2, 1));
  const double reach = std::pow(10, uniform(-1, 1.3));
  double across = uniform(0, 5);
  double up = 50;
  while (across < 40) {
    points.push_back({across, up});
    if (uniform(0, 1) > 0.1) across += uniform(0, pace);
    up = std::clamp(up + uniform(-reach, reach), 0.0, 100.0);
  }
  return points;
}

/// The lowest and the highest place of the curve in a column, both edges included, by cutting every
/// piece.
std::pair<long double, long double> extent_in(const Points& points, int column) {
  long double low = INFINITY;
  long double high = -INFINITY;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const GridPoint& a = points[i == 0 ? 0 : i - 1];
    const GridPoint& b = points[i];
    const long double from = std::max<long double>(a.across, column);
    const long double to = std::min<long double>(b.across, column + 1);
    if (from > to) continue;
    for (const long double at : {from, to}) {
      const bool vertical = a.across == b.across;
      const long double share = vertical ? 0 : (at - a.across) / (b.across - a.across);
      const long double up = a.up + (b.up - a.up) * share;
      low = std::min({low, up, vertical ? b.up : up});
      high = std::max({high, up, vertical ? b.up : up});
    }
  }
  return {low, high};
}

TEST_CASE("trace: unbroken, and only where the curve is") {
  constexpr std::uint64_t kSeed = 7;
  std::mt19937_64 random(kSeed);
  for (int curve = 0; curve < 500; ++curve) {
    CAPTURE(kSeed, curve);
    const Points points = random_curve(random);
    const std::vector<Run> runs = trace(points);
    REQUIRE(runs.front().column == std::floor(points.front().across));
    REQUIRE(runs.back().column == std::floor(points.back().across));
    for (std::size_t i = 0; i < runs.size(); ++i) {
      CAPTURE(i, runs[i].bottom, runs[i].top);
      REQUIRE(runs[i].bottom <= runs[i].top);
      const auto [low, high] = extent_in(points, runs[i].column);
      // Rounding moves a place of size 100 by 1e-17 in long double; 1e-9 is far above.
      REQUIRE(runs[i].bottom >= std::floor(low - 1e-9L));
      REQUIRE(runs[i].top <= std::floor(high + 1e-9L));
      if (i == 0) continue;
      REQUIRE(runs[i].column == runs[i - 1].column + 1);
      REQUIRE(runs[i].bottom <= runs[i - 1].top + 1);
      REQUIRE(runs[i].top >= runs[i - 1].bottom - 1);
    }
  }
}

TEST_CASE("trace: extremes inside a column are shown") {
  constexpr std::uint64_t kSeed = 8;
  std::mt19937_64 random(kSeed);
  for (int curve = 0; curve < 500; ++curve) {
    CAPTURE(kSeed, curve);
    const Points points = random_curve(random);
    const auto higher = [](const GridPoint& a, const GridPoint& b) { return a.up < b.up; };
    const auto [low, high] = std::minmax_element(points.begin(), points.end(), higher);
    const std::vector<Run> runs = trace(points);
    const auto has = [&](const GridPoint& point) {
      return std::any_of(runs.begin(), runs.end(), [&](const Run& run) {
        return run.bottom <= point.up && point.up < run.top + 1;
      });
    };
    REQUIRE(has(*low));
    REQUIRE(has(*high));
  }
}

TEST_CASE("trace: small extremes are shown, too") {
  // Peaks inside columns 1 and 2, the second higher, and one on the edge of columns 1 and 2, each
  // aside from the middles; then upside down. The rows of the middles reach each other without the
  // peaks.
  for (const long double sign : {1.0L, -1.0L}) {
    CAPTURE(sign);
    const auto runs_of = [&](Points points) {
      for (GridPoint& point : points) point.up *= sign;
      return trace(points);
    };
    const auto reach = [&](const Run& run) { return sign > 0 ? run.top : -1 - run.bottom; };
    const std::vector<Run> inside = runs_of({{0.5L, 0.5L},
                                             {1.2L, 0.5L},
                                             {1.3L, 3.5L},
                                             {1.4L, 0.5L},
                                             {2.2L, 0.5L},
                                             {2.3L, 6.5L},
                                             {2.4L, 0.5L},
                                             {3.5L, 0.5L}});
    CHECK(reach(inside[1]) == 3);
    CHECK(reach(inside[2]) == 6);
    const std::vector<Run> edge =
        runs_of({{0.5L, 5.5L}, {1.9L, 9.5L}, {2.1L, 9.5L}, {3.5L, 5.5L}, {9.5L, 20.5L}});
    CHECK(reach(edge[1]) == 9);
    CHECK(reach(edge[2]) == 9);
    CHECK(reach(edge[0]) < 9);
    CHECK(reach(edge[3]) < 9);
  }
}

TEST_CASE("trace: a gentle line has one row in each column, that of its middle") {
  // Slopes up to one row a column: the rows of neighbouring middles touch without joining.
  for (const double slope : {-1.0, -0.7, -0.1, 0.0, 0.3, 0.99}) {
    CAPTURE(slope);
    Points points;
    for (int i = 0; i <= 400; ++i)
      points.push_back({0.1 * i + 0.25, 50.3 + slope * (0.1 * i + 0.25)});
    const std::vector<Run> runs = trace(points);
    for (std::size_t i = 1; i + 1 < runs.size(); ++i) {
      CAPTURE(i);
      REQUIRE(runs[i].bottom == std::floor(50.3 + slope * (runs[i].column + 0.5)));
      REQUIRE(runs[i].top == runs[i].bottom);
    }
  }
}

TEST_CASE("trace: a step is a vertical run in the column in which it happens") {
  for (const long double at : {3.2L, 3.5L, 3.8L}) {
    const Points points{{0.5L, 1.5L}, {at, 1.5L}, {at, 7.5L}, {6.5L, 7.5L}};
    const std::vector<Run> runs = trace(points);
    REQUIRE(runs.size() == 7);
    for (const int column : {0, 1, 2, 4, 5, 6}) {
      const Run& run = runs[static_cast<std::size_t>(column)];
      CHECK(run.bottom == (column < 3 ? 1 : 7));
      CHECK(run.top == (column < 3 ? 1 : 7));
    }
    // Where the middle of the column is on one level, that level's neighbour may hold the end of
    // the run.
    CHECK(runs[3].bottom <= 2);
    CHECK(runs[3].top >= 6);
  }
}

TEST_CASE("trace: one point, and a vertical line") {
  const std::vector<Run> point = trace(Points{{2.5L, 3.5L}});
  REQUIRE(point.size() == 1);
  CHECK((point[0].column == 2 && point[0].bottom == 3 && point[0].top == 3));
  const std::vector<Run> line = trace(Points{{2.1L, 5.5L}, {2.1L, 1.5L}});
  REQUIRE(line.size() == 1);
  CHECK((line[0].column == 2 && line[0].bottom == 1 && line[0].top == 5));
}

}  // namespace
}  // namespace rotor
