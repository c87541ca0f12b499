#include "output/table.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "output/utf8.hpp"
#include "rotation/text.hpp"

namespace rotor {
namespace {

using Column = std::vector<std::string>;

bool is_number(std::string_view cell) {
  double x = 0;
  const auto read = std::from_chars(cell.data(), cell.data() + cell.size(), x);
  // Out of range is a number, too: its end is known.
  return read.ec != std::errc::invalid_argument && read.ptr == cell.data() + cell.size();
}

Align chosen(const Column& cells) {
  const bool numbers = std::all_of(cells.begin(), cells.end(), [](const std::string& cell) {
    return cell.empty() || is_number(cell);
  });
  return numbers ? Align::kPoint : Align::kLeft;
}

/// What stands left of the decimal point; of "12" and "1e-300", what would. Of "nan" nothing does.
std::size_t before_point(std::string_view cell) {
  if (cell.find_first_of("0123456789") == std::string_view::npos) return 0;
  return utf8_count(cell.substr(0, is_number(cell) ? cell.find_first_of(".e") : cell.find('.')));
}

void pad_left(std::string& cell, std::size_t width) {
  cell.insert(0, width - std::min(width, utf8_count(cell)), ' ');
}

void pad_right(std::string& cell, std::size_t width) {
  cell.append(width - std::min(width, utf8_count(cell)), ' ');
}

std::size_t width(const Column& cells) {
  std::size_t width = 0;
  for (const std::string& cell : cells) width = std::max(width, utf8_count(cell));
  return width;
}

/// Makes the cells that have digits equally wide; the others, aligned right later, are left as they
/// are.
void align_points(Column& cells) {
  std::size_t most_before = 0;
  std::size_t most_after = 0;
  for (const std::string& cell : cells) {
    const std::size_t before = before_point(cell);
    most_before = std::max(most_before, before);
    if (before > 0) most_after = std::max(most_after, utf8_count(cell) - before);
  }
  for (std::string& cell : cells) {
    const std::size_t before = before_point(cell);
    if (before == 0) continue;
    cell.insert(0, most_before - before, ' ');
    pad_right(cell, most_before + most_after);
  }
}

/// Name, rule and cells of one column, all of the same width.
Column laid_out(std::string name, Column cells, Align align) {
  if (align == Align::kAuto) align = chosen(cells);
  if (align == Align::kPoint) align_points(cells);
  const std::size_t full = std::max(width(cells), utf8_count(name));
  cells.insert(cells.begin(), std::move(name));
  for (std::string& cell : cells) {
    if (align == Align::kLeft)
      pad_right(cell, full);
    else
      pad_left(cell, full);
  }
  cells.insert(cells.begin() + 1, std::string(full, '-'));
  return cells;
}

// Two blanks between them, none at line ends.
std::string side_by_side(std::span<const Column* const> columns, std::size_t lines) {
  std::string out;
  for (std::size_t i = 0; i < lines; ++i) {
    std::string line;
    for (const Column* column : columns)
      line += (column == columns.front() ? "" : "  ") + (*column)[i];
    out += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
  }
  return out;
}

// As many columns side by side as fit, and the others below; each block begins with the first one.
std::vector<std::string> blocks_of(const std::vector<Column>& columns, std::size_t width) {
  const auto size = [](const Column& column) { return utf8_count(column.front()); };
  std::vector<std::string> blocks;
  std::size_t next = 1;
  do {
    std::vector<const Column*> block = {&columns.front()};
    std::size_t taken = size(columns.front());
    for (; next < columns.size(); ++next) {
      taken += 2 + size(columns[next]);
      if (taken > width && block.size() > 1) break;
      block.push_back(&columns[next]);
    }
    blocks.push_back(side_by_side(block, columns.front().size()));
  } while (next < columns.size());
  return blocks;
}

}  // namespace

std::string table(std::span<const std::string> header,
                  std::span<const std::vector<std::string>> rows,
                  std::span<const Align> alignment) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].size() > header.size())
      throw std::invalid_argument("table: row " + std::to_string(i + 1) + " has " +
                                  std::to_string(rows[i].size()) + " cells, the header has " +
                                  std::to_string(header.size()));
  }
  std::vector<Column> columns;
  for (std::size_t c = 0; c < header.size(); ++c) {
    Column cells;
    for (const auto& row : rows) cells.push_back(c < row.size() ? row[c] : "");
    columns.push_back(
        laid_out(header[c], std::move(cells), c < alignment.size() ? alignment[c] : Align::kAuto));
  }
  std::vector<const Column*> all;
  all.reserve(columns.size());
  for (const Column& column : columns) all.push_back(&column);
  return side_by_side(all, rows.size() + 2);
}

std::string number_table(const std::vector<std::string>& header,
                         std::span<const std::vector<double>> rows, int digits, bool numbered,
                         std::size_t width) {
  constexpr int kLeastDigits = 6;
  const auto blocks = [&](int significant) {
    std::vector<Column> columns;
    Column cells;
    for (std::size_t i = 0; i < rows.size(); ++i) cells.push_back(std::to_string(i + 1));
    if (numbered) columns.push_back(laid_out("i", cells, Align::kRight));
    for (std::size_t c = 0; c < header.size(); ++c) {
      for (std::size_t i = 0; i < rows.size(); ++i) cells[i] = text(rows[i][c], significant);
      columns.push_back(laid_out(header[c], cells, Align::kPoint));
    }
    return blocks_of(columns, width);
  };
  const std::size_t fewest = blocks(std::min(digits, kLeastDigits)).size();
  std::vector<std::string> written;
  do written = blocks(digits--);
  while (written.size() > fewest);
  std::string out;
  for (const std::string& block : written) out += (out.empty() ? "" : "\n") + block;
  return out;
}

}  // namespace rotor
