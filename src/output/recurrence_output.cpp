#include "output/recurrence_output.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include "dynamics/pair_distances.hpp"
#include "output/csv.hpp"
#include "output/page.hpp"
#include "output/provenance.hpp"
#include "output/scale.hpp"
#include "rotation/text.hpp"

namespace rotor {
namespace {

constexpr int kLeastHeight = 5;
constexpr std::string_view kMarks = ".:*#";  // from more than none, 1/8, 1/4, 1/2 of the most

// The scales of a square picture that has room.
struct Square {
  VerticalScale up;
  HorizontalScale across;
};

Square square(const Extent& extent, const PlotOptions& options) {
  if (options.height < kLeastHeight)
    throw std::invalid_argument("height must be at least 5, got " + std::to_string(options.height));
  for (int height = options.height; height >= kLeastHeight; --height) {
    const VerticalScale up = vertical_scale(extent, height);
    const long double rows = (extent.high - extent.low) / up.row_size();
    const int columns = static_cast<int>(std::lround(2 * rows)) + 1;
    if (columns + static_cast<int>(margin_of(up)) <= options.width) return {up, {extent, columns}};
  }
  throw std::invalid_argument("width leaves no room for a picture of 5 rows, got " +
                              std::to_string(options.width));
}

// How many of the pairs of points of each cell there are, and recur.
class Cells {
 public:
  Cells(const std::vector<double>& times, const Square& square)
      : columns_(static_cast<std::size_t>(square.across.columns)),
        recurrent_(columns_ * static_cast<std::size_t>(square.up.rows)),
        in_column_(columns_),
        in_row_(static_cast<std::size_t>(square.up.rows)) {
    for (const double t : times) {
      column_.push_back(static_cast<std::size_t>(square.across.across(t)));
      row_.push_back(static_cast<std::size_t>(square.up.up(t)));
      ++in_column_[column_.back()];
      ++in_row_[row_.back()];
    }
  }
  void add(std::size_t i, std::size_t j) {
    ++recurrent_[row_[j] * columns_ + column_[i]];
    ++recurrent_[row_[i] * columns_ + column_[j]];
  }
  double share(std::size_t column, std::size_t row) const {
    const double recurrent = recurrent_[row * columns_ + column];
    return recurrent == 0 ? 0 : recurrent / (in_column_[column] * in_row_[row]);
  }
  double greatest_share() const {
    double greatest = 0;
    for (std::size_t row = 0; row < in_row_.size(); ++row)
      for (std::size_t column = 0; column < columns_; ++column)
        greatest = std::max(greatest, share(column, row));
    return greatest;
  }
  std::string line(std::size_t row, double most) const {
    std::string marks;
    for (std::size_t column = 0; column < columns_; ++column) {
      const double part = share(column, row) / most;
      marks += !(part > 0)    ? ' '
               : part < 0.125 ? kMarks[0]
               : part < 0.25  ? kMarks[1]
               : part < 0.5   ? kMarks[2]
                              : kMarks[3];
    }
    return marks;
  }

 private:
  std::size_t columns_;
  std::vector<double> recurrent_;
  std::vector<double> in_column_;
  std::vector<double> in_row_;
  std::vector<std::size_t> column_;  // of each point
  std::vector<std::size_t> row_;
};

}  // namespace

std::string plot(const RunRecurrence& recurrence, const PlotOptions& options,
                 const Observer& observer) {
  const auto [low, high] = std::minmax(recurrence.times.front(), recurrence.times.back());
  const Square scales = square(drawable(low, high), options);
  Cells cells(recurrence.times, scales);
  visit_rows(recurrence.matrix, watched(recurrence.times.size(), observer,
                                        [&](std::size_t j, std::span<const std::uint32_t> row) {
                                          for (const std::uint32_t i : row) cells.add(i, j);
                                          return true;
                                        }));
  const double most = cells.greatest_share();
  Page page(static_cast<std::size_t>(options.width));
  page.centred(options.title, margin_of(scales.up));
  page.line("t");
  page.frame(scales.up, scales.across,
             [&](int row) { return cells.line(static_cast<std::size_t>(row), most); });
  page.line(most > 0 ? ". : * #  over 0, 1/8, 1/4, 1/2 of the share " + text(most, 3)
                     : "nothing recurs");
  return page.take();
}

Picture points_picture(const RunRecurrence& recurrence, const PlotOptions& look,
                       const Observer& observer) {
  constexpr std::size_t kMost = 1'000'000;
  if (recurrence.matrix.measures.pairs > kMost / 2) {
    throw std::length_error(std::to_string(recurrence.matrix.measures.pairs) +
                            " pairs are too many for a picture of points: give a smaller threshold "
                            "or fewer times");
  }
  Picture picture{{}, {{"t", {}}}, look, true};
  const auto add = [&](double x, double y) {
    picture.x.push_back(x);
    picture.series[0].y.push_back(y);
  };
  for (const double t : recurrence.times) add(t, t);
  visit_rows(recurrence.matrix, watched(recurrence.times.size(), observer,
                                        [&](std::size_t j, std::span<const std::uint32_t> row) {
                                          const double t = recurrence.times[j];
                                          for (const std::uint32_t i : row) {
                                            add(recurrence.times[i], t);
                                            add(t, recurrence.times[i]);
                                          }
                                          return true;
                                        }));
  picture.look.x_label = "t";
  picture.look.y_label = "t";
  return picture;
}

bool write_csv(const RunRecurrence& recurrence, const std::filesystem::path& file,
               const std::string& scene, const std::string& norm, const Observer& observer) {
  static const std::array<std::string, 4> kHeader = {"i", "j", "t_i", "t_j"};
  static const std::array<Column, 4> kColumns = {{
      {"i", kHeader[0], "number of the earlier point, from 1", false},
      {"j", kHeader[1], "number of the later point", false},
      {"t_i", kHeader[2], "time of the earlier point", false},
      {"t_j", kHeader[3], "time of the later point", false},
  }};
  CsvWriter writer(file, kHeader);
  const Recurrence& matrix = recurrence.matrix;
  std::vector<std::uint32_t> sorted;
  visit_rows(matrix, watched(recurrence.times.size(), observer,
                             [&](std::size_t j, std::span<const std::uint32_t> row) {
                               sorted.assign(row.begin(), row.end());
                               std::sort(sorted.begin(), sorted.end());
                               for (const std::uint32_t i : sorted) {
                                 writer.row(std::array{static_cast<double>(i) + 1,
                                                       static_cast<double>(j) + 1,
                                                       recurrence.times[i], recurrence.times[j]});
                               }
                               return true;
                             }));
  writer.commit();
  return write_provenance(file, kColumns, matrix.measures.pairs, scene,
                          "pairs i < j at a distance of at most the threshold",
                          {{"norm", norm},
                           {"threshold", matrix.threshold},
                           {"theiler", matrix.options.theiler},
                           {"points", recurrence.times.size()}});
}

}  // namespace rotor
