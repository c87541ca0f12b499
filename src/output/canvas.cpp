#include "output/canvas.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "output/page.hpp"
#include "output/scale.hpp"
#include "output/trace.hpp"
#include "output/utf8.hpp"
#include "rotation/text.hpp"

namespace rotor {
namespace {

constexpr std::string_view kMarks = "*+ox#@%&=~";
constexpr int kThirds = 3;
constexpr unsigned kPoint = 1u << kThirds;
// What the thirds of a cell look like: bit 0 the lowest. A point hides them.
constexpr std::string_view kThirdsMarks = " .-.'|'|********";
constexpr int kLeastHeight = 5;
constexpr int kLeastColumns = 10;
constexpr std::size_t kGap = 3;  // blanks between the names of the legend

[[noreturn]] void refuse(const std::string& what) { throw std::invalid_argument("plot: " + what); }

void check_x(std::span<const double> x, bool log) {
  const auto place = [&](auto point) { return "point " + std::to_string(point - x.begin() + 1); };
  const auto bad = std::find_if_not(x.begin(), x.end(), [](double t) { return std::isfinite(t); });
  if (bad != x.end()) refuse("x must be finite, " + place(bad) + " is " + text(*bad));
  if (x.empty()) return;
  const auto low = std::min_element(x.begin(), x.end());
  if (log && *low <= 0)
    refuse("x must be positive on a logarithmic axis, " + place(low) + " is " + text(*low));
  const auto turn = x.front() <= x.back()
                        ? std::is_sorted_until(x.begin(), x.end())
                        : std::is_sorted_until(x.begin(), x.end(), std::greater<>());
  if (turn != x.end())
    refuse("x must be monotone, " + place(turn) + " turns back from " + text(*std::prev(turn)) +
           " to " + text(*turn));
}

void check_series(std::size_t size, std::span<const Series> series) {
  if (series.empty()) refuse("no series to draw");
  if (series.size() > kMarks.size())
    refuse("at most " + std::to_string(kMarks.size()) + " series, got " +
           std::to_string(series.size()));
  for (const Series& one : series)
    if (one.y.size() != size)
      refuse("x has " + std::to_string(size) + " values, series \"" + one.name + "\" has " +
             std::to_string(one.y.size()));
}

/// The places along a logarithmic axis: nan for what has none.
std::vector<double> logarithms(std::span<const double> values) {
  std::vector<double> places(values.size());
  std::transform(values.begin(), values.end(), places.begin(), [](double value) {
    return value > 0 ? std::log10(value) : std::numeric_limits<double>::quiet_NaN();
  });
  return places;
}

Extent extent_of(std::span<const Series> series, Spacing spacing) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const Series& one : series) {
    for (double y : one.y) {
      if (!std::isfinite(y)) continue;
      low = std::min(low, y);
      high = std::max(high, y);
    }
  }
  if (low > high)
    refuse(spacing == Spacing::kLinear ? "no finite value to draw"
                                       : "no finite positive value to draw");
  return drawable(low, high, spacing);
}

/// For each cell a set of bits: the series that pass it, or the thirds in which the only one does.
class Grid {
 public:
  Grid(const HorizontalScale& across, const VerticalScale& up, std::size_t series)
      : across_(across),
        up_(up),
        single_(series == 1),
        cells_(static_cast<std::size_t>(across.columns * up.rows)) {}

  /// The pieces between gaps and jumps.
  void draw(std::span<const double> x, const Series& series, unsigned index) {
    const std::vector<double>& y = series.y;
    std::vector<GridPoint> piece;
    const bool backwards = x.front() > x.back();
    for (std::size_t k = 0; k < x.size(); ++k) {
      const std::size_t i = backwards ? x.size() - 1 - k : k;
      const std::size_t before = backwards ? i + 1 : i - 1;
      if (!piece.empty() && std::abs(y[i] - y[before]) > series.jump) {
        draw_piece(piece, index);
        piece.clear();
      }
      if (std::isfinite(y[i])) {
        piece.push_back({across_.across(x[i]), up_.up(y[i]) * thirds()});
      } else {
        draw_piece(piece, index);
        piece.clear();
      }
    }
    draw_piece(piece, index);
  }

  std::string row(int row) const {
    std::string marks;
    for (int column = 0; column < across_.columns; ++column) {
      const unsigned bits = cells_[at(column, row)];
      marks += single_ ? kThirdsMarks[bits] : mark(bits, column);
    }
    return marks;
  }

 private:
  int thirds() const { return single_ ? kThirds : 1; }

  std::size_t at(int column, int row) const {
    return static_cast<std::size_t>(row * across_.columns + column);
  }

  void draw_piece(std::span<const GridPoint> piece, unsigned index) {
    if (piece.empty()) return;
    for (const Run& run : trace(piece)) {
      for (int row = run.bottom; row <= run.top; ++row) {
        const unsigned third = piece.size() == 1 ? kPoint : 1u << (row % kThirds);
        cells_[at(run.column, row / thirds())] |= single_ ? third : 1u << index;
      }
    }
  }

  static char mark(unsigned bits, int column) {
    if (bits == 0) return ' ';
    for (int turn = column % std::popcount(bits); turn > 0; --turn) bits &= bits - 1;
    return kMarks[static_cast<std::size_t>(std::countr_zero(bits))];
  }

  const HorizontalScale& across_;
  const VerticalScale& up_;
  bool single_;
  std::vector<unsigned> cells_;
};

void add_legend(Page& page, std::span<const Series> series) {
  std::string entries;
  for (std::size_t i = 0; i < series.size(); ++i) {
    const std::string entry = std::string{kMarks[i], ' '} + series[i].name;
    if (i > 0 && utf8_count(entries) + kGap + utf8_count(entry) > page.width()) {
      page.line(entries);
      entries.clear();
    }
    if (!entries.empty()) entries.append(kGap, ' ');
    entries += entry;
  }
  page.line(entries);
}

/// The picture of places along the axes.
std::string drawn(std::span<const double> x, std::span<const Series> series,
                  const PlotOptions& options) {
  const Spacing x_spacing = options.log_x ? Spacing::kLogarithmic : Spacing::kLinear;
  const Spacing y_spacing = options.log_y ? Spacing::kLogarithmic : Spacing::kLinear;
  const VerticalScale up = vertical_scale(extent_of(series, y_spacing), options.height, y_spacing);
  const std::size_t margin = margin_of(up);
  const int columns = options.width - static_cast<int>(margin);
  if (columns < kLeastColumns)
    refuse("width must be at least " + std::to_string(options.width - columns + kLeastColumns) +
           " with these labels, got " + std::to_string(options.width));
  const auto [low, high] = std::minmax(x.front(), x.back());
  const HorizontalScale across{drawable(low, high, x_spacing), columns, x_spacing};
  Grid grid(across, up, series.size());
  for (std::size_t i = 0; i < series.size(); ++i) grid.draw(x, series[i], static_cast<unsigned>(i));

  Page page(static_cast<std::size_t>(options.width));
  page.centred(options.title, margin);
  const bool is_named = !options.y_label.empty() || series.size() > 1;
  const std::string& y_label = is_named ? options.y_label : series.front().name;
  if (!y_label.empty()) page.line(y_label);
  page.frame(up, across, [&](int row) { return grid.row(row); });
  page.centred(options.x_label, margin);
  if (series.size() > 1) add_legend(page, series);
  return page.take();
}

}  // namespace

std::string plot(std::span<const double> x, std::span<const Series> series,
                 const PlotOptions& options) {
  check_x(x, options.log_x);
  check_series(x.size(), series);
  if (options.height < kLeastHeight)
    refuse("height must be at least " + std::to_string(kLeastHeight) + ", got " +
           std::to_string(options.height));
  const std::vector<double> x_places =
      options.log_x ? logarithms(x) : std::vector<double>(x.begin(), x.end());
  std::vector<Series> places(series.begin(), series.end());
  for (Series& one : places)
    if (options.log_y) one.y = logarithms(one.y);
  return drawn(x_places, places, options);
}

}  // namespace rotor
