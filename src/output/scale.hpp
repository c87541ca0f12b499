// From data to the cells of a picture.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "output/axis.hpp"

namespace rotor {

/// Rows, counted upwards. Row r is at (bottom + r) step / rows_per_tick, so that every tick is the
/// middle of a row.
struct VerticalScale {
  Step step{};
  int rows_per_tick = 1;
  std::int64_t bottom = 0;
  int rows = 0;
  std::vector<int> tick_rows;
  std::vector<std::string> labels;  // of the ticks

  long double row_size() const { return step.size() / rows_per_tick; }
  /// In rows from the lower edge, within [0, rows) for y in the extent.
  long double up(double y) const;
};

/// The scale that fills most of `height` rows (5 or more), with a tick in every third to seventh
/// row of 20; between powers of ten there may be more rows.
VerticalScale vertical_scale(Extent extent, int height, Spacing spacing = Spacing::kLinear);

/// Columns; the ends of the extent are the middles of the first and the last one.
struct HorizontalScale {
  Extent extent;
  int columns;
  Spacing spacing = Spacing::kLinear;

  /// In columns from the left edge.
  long double across(long double x) const {
    return (x - extent.low) / (extent.high - extent.low) * (columns - 1) + 0.5L;
  }
};

struct BottomAxis {
  std::string line;    // "---+---", '+' in the column of each tick but the first column's
  std::string labels;  // begins `margin` columns left of the line, each label about its tick
};

/// With as many ticks as have room for their labels.
BottomAxis bottom_axis(const HorizontalScale& scale, std::size_t margin);

}  // namespace rotor
