#include "output/trace.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rotor {
namespace {

constexpr long double kInfinity = std::numeric_limits<long double>::infinity();

struct Range {
  long double low = kInfinity;
  long double high = -kInfinity;

  void include(long double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
  void include(const Range& other) {
    low = std::min(low, other.low);
    high = std::max(high, other.high);
  }
};

/// What the curve does in one column.
struct Column {
  Range all;
  Range edges;          // where it comes in and goes out
  Range middle;         // empty if it does not reach the middle
  long double out = 0;  // where it goes out to the next column
};

int cell(long double x) { return static_cast<int>(std::floor(x)); }

long double height(const GridPoint& a, const GridPoint& b, long double across) {
  if (b.across == a.across) return b.up;
  return std::lerp(a.up, b.up, (across - a.across) / (b.across - a.across));
}

/// Columns from that of the first point to that of the last.
std::vector<Column> columns_of(std::span<const GridPoint> points, int first) {
  std::vector<Column> columns(static_cast<std::size_t>(cell(points.back().across) - first + 1));
  const auto at = [&](int column) -> Column& {
    return columns[static_cast<std::size_t>(column - first)];
  };
  for (const GridPoint& point : points) at(cell(point.across)).all.include(point.up);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const GridPoint& a = points[i - 1];
    const GridPoint& b = points[i];
    for (int edge = cell(a.across) + 1; edge <= cell(b.across); ++edge) {
      const long double up = height(a, b, edge);
      for (Column* column : {&at(edge - 1), &at(edge)}) {
        column->all.include(up);
        column->edges.include(up);
      }
      at(edge - 1).out = up;
    }
    for (int column = cell(a.across + 0.5L); column + 0.5L <= b.across; ++column)
      if (column + 0.5L >= a.across) at(column).middle.include(height(a, b, column + 0.5L));
  }
  return columns;
}

/// Where the curve only passes through, the row of its middle is enough. An extreme is shown: it
/// lies inside the column or, on an edge, is not surpassed by the neighbours.
Run own_rows(std::span<const Column> columns, std::size_t i, int first) {
  const Column& column = columns[i];
  Range around;
  if (i > 0) around.include(columns[i - 1].all);
  if (i + 1 < columns.size()) around.include(columns[i + 1].all);
  Range range = column.middle;
  if (range.low > range.high) range = column.all;
  if (column.all.high > column.edges.high || column.all.high >= around.high)
    range.include(column.all.high);
  if (column.all.low < column.edges.low || column.all.low <= around.low)
    range.include(column.all.low);
  return {first + static_cast<int>(i), cell(range.low), cell(range.high)};
}

/// Fills the rows between two neighbours; the curve passes their common edge at `edge`.
void join(Run& left, Run& right, long double edge) {
  if (right.bottom > left.top + 1) {
    left.top = std::clamp(cell(edge - 0.5L), left.top, right.bottom - 1);
    right.bottom = left.top + 1;
  } else if (right.top < left.bottom - 1) {
    left.bottom = std::clamp(cell(edge + 0.5L), right.top + 1, left.bottom);
    right.top = left.bottom - 1;
  }
}

}  // namespace

std::vector<Run> trace(std::span<const GridPoint> points) {
  const int first = cell(points.front().across);
  const std::vector<Column> columns = columns_of(points, first);
  std::vector<Run> runs;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    runs.push_back(own_rows(columns, i, first));
    if (i > 0) join(runs[i - 1], runs[i], columns[i - 1].out);
  }
  return runs;
}

}  // namespace rotor
