#include "output/scatter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "output/page.hpp"
#include "output/scale.hpp"
#include "output/utf8.hpp"

namespace rotor {
namespace {

constexpr std::string_view kMarks = ".:-=+*#%@";
constexpr int kLeastHeight = 5;
constexpr int kLeastColumns = 10;

[[noreturn]] void refuse(const std::string& what) { throw std::invalid_argument("plot: " + what); }

struct Points {
  std::vector<double> x;
  std::vector<double> y;
};

Points finite(std::span<const double> x, std::span<const double> y) {
  if (x.size() != y.size())
    refuse(std::to_string(x.size()) + " values of x, but " + std::to_string(y.size()) + " of y");
  Points points;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!std::isfinite(x[i]) || !std::isfinite(y[i])) continue;
    points.x.push_back(x[i]);
    points.y.push_back(y[i]);
  }
  if (points.x.empty()) refuse("no finite point to draw");
  return points;
}

Extent extent_of(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return {*low, *high};
}

// About its middle, to `least` at least.
Extent widened(Extent extent, long double least) {
  const long double middle = extent.low + (extent.high - extent.low) / 2;
  const long double half = std::max(extent.high - extent.low, least) / 2;
  return {middle - half, middle + half};
}

struct Frame {
  VerticalScale up;
  HorizontalScale across;
};

// With as many rows as leave room for the columns that belong to them.
Frame frame_of(Extent x, Extent y, const PlotOptions& options) {
  for (int height = options.height; height >= kLeastHeight; --height) {
    const VerticalScale up = vertical_scale(y, height);
    const long double column = up.row_size() / 2;
    const int room = options.width - static_cast<int>(margin_of(up));
    const long double columns = std::ceil((x.high - x.low) / column - 1e-9L) + 1;
    if (columns > room) continue;
    const int number = std::max(static_cast<int>(columns), kLeastColumns);
    if (number > room) continue;
    const long double spare = (number - 1) * column - (x.high - x.low);
    return {up, {{x.low - spare / 2, x.high + spare / 2}, number}};
  }
  refuse("no room for these points in " + std::to_string(options.width) + " columns and " +
         std::to_string(options.height) + " rows with one scale for both axes");
}

}  // namespace

std::string scatter(std::span<const double> x, std::span<const double> y,
                    const PlotOptions& options) {
  const Points points = finite(x, y);
  Extent across = extent_of(points.x);
  Extent up = extent_of(points.y);
  const long double size = std::max(across.high - across.low, up.high - up.low);
  if (size > 0) {
    // At least as high as the fewest rows are where the width takes all columns.
    const long double room = std::max(options.width - kLeastColumns, 1);
    across = widened(across, size / 20);
    up = widened(up, size * std::min(3.0L * kLeastHeight / room, 1.0L));
  } else {
    up = drawable(static_cast<double>(up.low), static_cast<double>(up.high));
    across = widened(across, up.high - up.low);
  }
  const Frame frame = frame_of(across, up, options);
  const auto columns = static_cast<std::size_t>(frame.across.columns);
  std::vector<std::size_t> counts(columns * static_cast<std::size_t>(frame.up.rows));
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    const auto row = static_cast<std::size_t>(frame.up.up(points.y[i]));
    const auto column = static_cast<std::size_t>(
        std::clamp(frame.across.across(points.x[i]), 0.0L, static_cast<long double>(columns - 1)));
    ++counts[row * columns + column];
  }
  const std::size_t most = *std::max_element(counts.begin(), counts.end());
  const auto mark = [&](std::size_t count) {
    if (count == 0) return ' ';
    if (most == 1) return '*';
    const double share = std::log(static_cast<double>(count)) / std::log(static_cast<double>(most));
    const auto last = static_cast<double>(std::min(kMarks.size(), most) - 1);
    return kMarks[static_cast<std::size_t>(std::lround(share * last))];
  };
  const std::size_t margin = margin_of(frame.up);
  Page page(static_cast<std::size_t>(options.width));
  if (!options.title.empty()) {
    const std::size_t room = columns - std::min(columns, utf8_count(options.title));
    page.line(std::string(margin + room / 2, ' ') + options.title);
  }
  if (!options.y_label.empty()) page.line(options.y_label);
  page.frame(frame.up, frame.across, [&](int row) {
    std::string marks;
    for (std::size_t column = 0; column < columns; ++column) {
      marks += mark(counts[static_cast<std::size_t>(row) * columns + column]);
    }
    return marks;
  });
  page.line(std::string(std::max(margin + columns, options.x_label.size()) - options.x_label.size(),
                        ' ') +
            options.x_label);
  return page.take();
}

}  // namespace rotor
