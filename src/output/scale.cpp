#include "output/scale.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace rotor {
namespace {

constexpr std::size_t kGap = 3;  // blanks between labels

std::int64_t floor_of(long double x) { return static_cast<std::int64_t>(std::floor(x)); }

VerticalScale scaled(Extent extent, Step step, int rows_per_tick) {
  VerticalScale scale{step, rows_per_tick, 0, 0, {}, {}};
  scale.bottom = floor_of(extent.low / scale.row_size() + 0.5L);
  const std::int64_t top = floor_of(extent.high / scale.row_size() + 0.5L);
  scale.rows = static_cast<int>(top - scale.bottom + 1);
  for (int row = 0; row < scale.rows; ++row)
    if ((scale.bottom + row) % rows_per_tick == 0) scale.tick_rows.push_back(row);
  return scale;
}

/// The smallest step that is not below `size` and has ticks.
Step least_step(long double size, Spacing spacing) {
  return step_from(spacing == Spacing::kLinear ? size : std::max(size, 1.0L));
}

/// Without labels if they do not fit.
BottomAxis axis_with(const HorizontalScale& scale, Step step, std::size_t margin) {
  const long double half = (scale.extent.high - scale.extent.low) / (scale.columns - 1) / 2;
  const std::int64_t first = -floor_of((half - scale.extent.low) / step.size());
  const std::int64_t last = floor_of((scale.extent.high + half) / step.size());
  BottomAxis axis{std::string(static_cast<std::size_t>(scale.columns), '-'), ""};
  const std::size_t width = margin + axis.line.size();
  std::int64_t tick = first;
  for (const std::string& label : tick_labels(step, first, last, scale.spacing)) {
    const long double across = scale.across(static_cast<long double>(tick++) * step.size());
    const auto column = static_cast<std::size_t>(
        std::clamp(across, 0.0L, static_cast<long double>(scale.columns - 1)));
    const std::size_t middle = margin + column;
    const std::size_t centred = middle - std::min(middle, (label.size() - 1) / 2);
    const std::size_t start = std::min(centred, width - std::min(width, label.size()));
    const std::size_t free = axis.labels.empty() ? 0 : axis.labels.size() + kGap;
    if (start < free || label.size() > width) return {std::string(axis.line.size(), '-'), ""};
    axis.labels.append(start - axis.labels.size(), ' ').append(label);
    if (column > 0) axis.line[column] = '+';
  }
  return axis;
}

}  // namespace

// The clamp is for the last bit only: the top of the extent may be the edge between two rows.
long double VerticalScale::up(double y) const {
  return std::clamp(y / row_size() - static_cast<long double>(bottom) + 0.5L, 0.0L, rows - 1e-6L);
}

VerticalScale vertical_scale(Extent extent, int height, Spacing spacing) {
  const long double size = extent.high - extent.low;
  const int densest = std::max(height / 6, 1);
  const int sparsest = std::max(densest + 4, densest * 5 / 2);
  VerticalScale best;
  // Some step always fits with `densest` rows a tick: let the extent be s rows; then rows - 1 is
  // within 1 of s, so that 2 densest - 1 < s <= height - 2 gives two ticks and fits; the ends of
  // this interval are a factor 3 or more apart, steps 2.5 at most.
  const Step least = least_step(size / height, spacing);
  for (Step step = least; step.size() <= densest * size; step = step.next()) {
    // A decade is not divided: where there are few, each takes what rows there are.
    const bool whole = spacing == Spacing::kLogarithmic && step.size() == least.size();
    const int most = whole ? height : sparsest;
    for (int rows_per_tick = densest; rows_per_tick <= most; ++rows_per_tick) {
      if (size / step.size() * rows_per_tick > height) continue;
      VerticalScale scale = scaled(extent, step, rows_per_tick);
      if (scale.rows <= height && scale.rows > best.rows && scale.tick_rows.size() >= 2)
        best = std::move(scale);
    }
  }
  const std::int64_t first = (best.bottom + best.tick_rows.front()) / best.rows_per_tick;
  best.labels = tick_labels(best.step, first, first + std::ssize(best.tick_rows) - 1, spacing);
  return best;
}

BottomAxis bottom_axis(const HorizontalScale& scale, std::size_t margin) {
  const long double size = scale.extent.high - scale.extent.low;
  Step step = least_step(size / scale.columns, scale.spacing);
  BottomAxis axis = axis_with(scale, step, margin);
  while (axis.labels.empty() && step.size() < size) {
    step = step.next();
    axis = axis_with(scale, step, margin);
  }
  return axis;
}

}  // namespace rotor
