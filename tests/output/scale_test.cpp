#include "output/scale.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <set>

#include "catch.hpp"

namespace rotor {
namespace {

using Labels = std::vector<std::string>;

TEST_CASE("steps are 1, 2 and 5 times powers of ten") {
  const auto is = [](long double size, int digit, int exponent) {
    const Step step = step_from(size);
    return step.digit == digit && step.exponent == exponent;
  };
  CHECK(is(1, 1, 0));
  CHECK(is(1.01L, 2, 0));
  CHECK(is(2.1L, 5, 0));
  CHECK(is(5.1L, 1, 1));
  CHECK(is(0.001L, 1, -3));
  CHECK(is(0.3L, 5, -1));
  CHECK(is(4e-324L, 5, -324));
  CHECK(is(3e308L, 5, 308));
}

TEST_CASE("tick labels are exact decimals of one form") {
  CHECK(tick_labels({5, -1}, -2, 2) == Labels{"-1.0", "-0.5", "0.0", "0.5", "1.0"});
  CHECK(tick_labels({2, 0}, 0, 2) == Labels{"0", "2", "4"});
  CHECK(tick_labels({2, 3}, 0, 2) == Labels{"0", "2000", "4000"});
  CHECK(tick_labels({5, -2}, 1, 3) == Labels{"0.05", "0.10", "0.15"});
  CHECK(tick_labels({1, -5}, 1, 2) == Labels{"0.00001", "0.00002"});
  CHECK(tick_labels({5, -13}, 0, 3) == Labels{"0", "5e-13", "1.0e-12", "1.5e-12"});
  CHECK(tick_labels({1, 308}, -2, 1) == Labels{"-2e+308", "-1e+308", "0", "1e+308"});
  CHECK(tick_labels({2, -13}, 5000000000000, 5000000000001) ==
        Labels{"1.0000000000000", "1.0000000000002"});
  CHECK(tick_labels({1, 0}, 1000000000, 1000000001) == Labels{"1000000000", "1000000001"});
  CHECK(tick_labels({1, 7}, 1, 2) == Labels{"10000000", "20000000"});
  CHECK(tick_labels({1, 8}, 1, 2) == Labels{"1e+08", "2e+08"});
  CHECK(tick_labels({5, 0}, -2, 1, Spacing::kLogarithmic) ==
        Labels{"1e-10", "1e-05", "1e+00", "1e+05"});
  CHECK(tick_labels({1, 2}, -3, -3, Spacing::kLogarithmic) == Labels{"1e-300"});
}

/// Random extents of every size and place: wide and narrow, near and far from 0.
Extent random_extent(std::mt19937_64& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const double size = std::pow(10, uniform(-300, 290));
  const double centre = size * uniform(-1, 1) * std::pow(10, uniform(-2, 14));
  return drawable(centre - size, centre + size);
}

TEST_CASE("vertical scale: fits, fills, and its labels are the middles of their rows") {
  constexpr std::uint64_t kSeed = 11;
  std::mt19937_64 random(kSeed);
  for (int trial = 0; trial < 5000; ++trial) {
    const Extent extent = random_extent(random);
    const int height = 5 + trial % 60;
    CAPTURE(kSeed, trial, height, extent.low, extent.high);
    const VerticalScale scale = vertical_scale(extent, height);
    REQUIRE(scale.rows <= height);
    // The sizes of rows on offer are at most a factor 1.5 apart (a step over 3 and over 2), ends
    // take a row each.
    REQUIRE(scale.rows >= (height - 2) / 1.5 - 1);
    REQUIRE(scale.labels.size() >= 2);
    REQUIRE(scale.labels.size() == scale.tick_rows.size());
    REQUIRE(std::set<std::string>(scale.labels.begin(), scale.labels.end()).size() ==
            scale.labels.size());
    for (std::size_t i = 0; i < scale.labels.size(); ++i) {
      const long double up = scale.up(std::strtod(scale.labels[i].c_str(), nullptr));
      const int row = scale.tick_rows[i];
      // Half an ulp of the label as a double, against rows of at least 16 ulps / 60; a label beyond
      // the extent of double is not tested by its double.
      if (std::abs(extent.low) < 1e307L && std::abs(extent.high) < 1e307L)
        REQUIRE(std::abs(up - (row + 0.5L)) < 0.5L);
    }
    for (const long double end : {extent.low, extent.high}) {
      const long double up = scale.up(static_cast<double>(end));
      REQUIRE(up >= 0);
      REQUIRE(up < scale.rows);
    }
  }
}

TEST_CASE("vertical scale: powers of ten are the middles of their rows, and fill") {
  for (int low = -400; low <= 400; low += 37) {
    for (int decades = 1; decades <= 640; decades += 1 + decades / 8) {
      for (int height = 5; height < 40; ++height) {
        CAPTURE(low, decades, height);
        const Extent extent{static_cast<long double>(low), static_cast<long double>(low + decades)};
        const VerticalScale scale = vertical_scale(extent, height, Spacing::kLogarithmic);
        REQUIRE(scale.rows <= height);
        // As for numbers; of one to three decades each has the same rows, and one end's row more.
        REQUIRE(scale.rows >= (height - 2) / 1.5 - 1);
        REQUIRE(scale.labels.size() >= 2);
        for (std::size_t i = 0; i < scale.labels.size(); ++i) {
          REQUIRE(scale.labels[i].starts_with("1e"));
          const double exponent = std::stoi(scale.labels[i].substr(2));
          REQUIRE(std::abs(scale.up(exponent) - (scale.tick_rows[i] + 0.5L)) < 1e-9L);
        }
        REQUIRE(scale.up(low) >= 0);
        REQUIRE(scale.up(low + decades) < scale.rows);
      }
    }
  }
}

TEST_CASE("vertical scale: ordinary labels are exactly in the middle") {
  const VerticalScale scale = vertical_scale({-1, 1}, 20);
  for (std::size_t i = 0; i < scale.labels.size(); ++i)
    CHECK(static_cast<double>(scale.up(std::stod(scale.labels[i]))) ==
          Approx(scale.tick_rows[i] + 0.5).epsilon(1e-15));
}

TEST_CASE("vertical scale: an end between two rows stays inside") {
  // With rows of 1/4 each end is the edge between two rows.
  for (const double end : {-2.625, -0.125, 0.125, 2.625}) {
    for (const Extent extent : {Extent{end - 2.5L, end}, Extent{end, end + 2.5L}}) {
      for (int height = 5; height < 40; ++height) {
        const VerticalScale scale = vertical_scale(extent, height);
        CHECK(scale.up(static_cast<double>(extent.low)) >= 0);
        CHECK(scale.up(static_cast<double>(extent.high)) < scale.rows);
      }
    }
  }
}

TEST_CASE("what is drawable") {
  const auto extent = [](double low, double high) {
    const Extent e = drawable(low, high);
    return std::pair{static_cast<double>(e.low), static_cast<double>(e.high)};
  };
  CHECK(extent(1, 2) == std::pair{1.0, 2.0});
  CHECK(extent(3, 3) == std::pair{1.5, 4.5});
  CHECK(extent(-3, -3) == std::pair{-4.5, -1.5});
  CHECK(extent(0, 0) == std::pair{-1.0, 1.0});
  const auto decades = [](double low, double high) {
    const Extent e = drawable(low, high, Spacing::kLogarithmic);
    return std::pair{static_cast<double>(e.low), static_cast<double>(e.high)};
  };
  CHECK(decades(-3.1, 2.0) == std::pair{-4.0, 2.0});
  CHECK(decades(0.2, 0.3) == std::pair{0.0, 1.0});
  CHECK(decades(-2, -2) == std::pair{-3.0, -1.0});
  CHECK(extent(1, 1 + 3e-15).first < 0.5);
  CHECK(extent(1, 1 + 4e-15).first == 1);
  constexpr double kLargest = std::numeric_limits<double>::max();
  CHECK(drawable(-kLargest, kLargest).high - drawable(-kLargest, kLargest).low > kLargest);
  CHECK(drawable(5e-324, 5e-324).low < drawable(5e-324, 5e-324).high);
}

TEST_CASE("bottom axis: each label is about its tick, within half a column") {
  constexpr std::uint64_t kSeed = 12;
  std::mt19937_64 random(kSeed);
  for (int trial = 0; trial < 5000; ++trial) {
    const Extent extent = random_extent(random);
    const HorizontalScale scale{extent, 10 + trial % 100};
    const std::size_t margin = 2 + static_cast<std::size_t>(trial % 7);
    CAPTURE(kSeed, trial, extent.low, extent.high);
    const BottomAxis axis = bottom_axis(scale, margin);
    CAPTURE(axis.line, axis.labels);
    REQUIRE(axis.line.size() == static_cast<std::size_t>(scale.columns));
    REQUIRE(axis.labels.size() <= axis.line.size() + margin);
    std::size_t ticks = 0;
    for (std::size_t at = 0; at < axis.labels.size();) {
      const std::size_t start = axis.labels.find_first_not_of(' ', at);
      at = std::min(axis.labels.find(' ', start), axis.labels.size());
      const double value = std::strtod(axis.labels.c_str() + start, nullptr);
      const long double column =
          (value - extent.low) / (extent.high - extent.low) * (scale.columns - 1);
      // An ulp of the value beside 0.5: the extent is 16 ulps or more, so that is 1/16 of all
      // columns at most.
      const long double ulp = std::numeric_limits<double>::epsilon() * std::abs(value) /
                              (extent.high - extent.low) * scale.columns;
      const auto near = [&](std::size_t c) {
        return std::abs(static_cast<long double>(c) - column) <= 0.5L + 1e-9L + ulp;
      };
      bool marked = near(0);
      for (std::size_t c = 1; c < axis.line.size(); ++c)
        marked = marked || (axis.line[c] == '+' && near(c));
      REQUIRE(marked);
      const bool moved = start == 0 || at == axis.line.size() + margin;
      const long double middle =
          static_cast<long double>(start + at) / 2 - static_cast<long double>(margin);
      if (!moved) REQUIRE(std::abs(middle - (column + 0.5L)) <= 1 + 1e-9L + ulp);
      ++ticks;
    }
    const auto pluses =
        static_cast<std::size_t>(std::count(axis.line.begin(), axis.line.end(), '+'));
    REQUIRE((ticks == pluses || ticks == pluses + 1));
  }
}

}  // namespace
}  // namespace rotor
