// Curves on a grid of cells.
#pragma once

#include <span>
#include <vector>

namespace rotor {

/// A point of a curve in cells: column c is [c, c + 1) across, row r is [r, r + 1) up.
struct GridPoint {
  long double across;
  long double up;
};

/// The rows bottom .. top of one column.
struct Run {
  int column;
  int bottom;
  int top;
};

/// A thin, unbroken drawing of the curve through the points, which go from left to right (or
/// straight up or down): one run for each column from the first point to the last. It holds the row
/// of the curve in the middle of the column, the rows of the extremes that lie inside the column,
/// and as much as it takes to touch its neighbours: a row passed left of the common edge belongs to
/// the left column, else to the right.
std::vector<Run> trace(std::span<const GridPoint> points);

}  // namespace rotor
