#include "output/csv_reader.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include "output/columns.hpp"
#include "output/csv.hpp"

namespace rotor {
namespace {

constexpr std::size_t kChunk = std::size_t{1} << 20;
constexpr std::size_t kRowsBetweenLooks = std::size_t{1} << 16;

[[noreturn]] void refuse_line(const std::string& file, std::size_t line, const std::string& what) {
  throw std::invalid_argument(file + ": line " + std::to_string(line) + ": " + what);
}

std::size_t lines_in(std::string_view content) {
  return static_cast<std::size_t>(std::count(content.begin(), content.end(), '\n'));
}

void look(const Observer& observer, double part) {
  if (observer && !observer(part)) throw Interrupted();
}

class Descriptor {
 public:
  explicit Descriptor(const std::string& file)
      : number_(open(file.c_str(), O_RDONLY | O_NOCTTY | O_CLOEXEC)) {}
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }

 private:
  int number_;
};

// NUL is looked for on the way: /dev/zero has no end.
std::string content_of(const std::string& file, const Observer& observer) {
  const auto fail = [&] { throw std::system_error(errno, std::generic_category(), file); };
  const Descriptor descriptor(file);
  if (descriptor.number() < 0) fail();
  std::string content;
  for (std::size_t size = 0;;) {
    look(observer, 0);
    content.resize(size + kChunk);
    const ssize_t got = read(descriptor.number(), content.data() + size, kChunk);
    if (got < 0 && errno != EINTR) fail();
    if (got < 0) continue;
    content.resize(size + static_cast<std::size_t>(got));
    const auto nul = content.find('\0', size);
    if (nul != content.npos) {
      refuse_line(file, 1 + lines_in(std::string_view(content).substr(0, nul)),
                  "expected text, got a NUL byte: this is a binary file, or one in UTF-16");
    }
    if (got == 0) return content;
    size = content.size();
  }
}

std::string_view without_blanks(std::string_view field) {
  const auto first = field.find_first_not_of(" \t");
  if (first == field.npos) return {};
  return field.substr(first, field.find_last_not_of(" \t") - first + 1);
}

// An empty field is nan.
std::errc read_number(std::string_view field, double& x) {
  field = without_blanks(field);
  x = std::numeric_limits<double>::quiet_NaN();
  if (field.empty()) return {};
  if (field.front() == '+' && field.find('-') != 1) field.remove_prefix(1);
  const auto read = std::from_chars(field.data(), field.data() + field.size(), x);
  return read.ptr == field.data() + field.size() ? read.ec : std::errc::invalid_argument;
}

/// The fields one after the other. They lie in the content, from which doubled quotes are taken
/// out.
class Fields {
 public:
  Fields(std::string& content, const std::string& file, char separator)
      : file_(file),
        separator_(separator),
        start_(content.data()),
        at_(start_),
        end_(start_ + content.size()) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (content.starts_with(kByteOrderMark)) at_ += kByteOrderMark.size();
    while (end_ > at_ && (end_[-1] == '\n' || end_[-1] == '\r')) --end_;
    is_done_ = at_ == end_;
  }

  bool is_done() const { return is_done_; }
  bool is_quoted() const { return at_ < end_ && *at_ == '"'; }
  std::size_t line() const { return line_; }
  double part() const {
    return static_cast<double>(at_ - start_) / static_cast<double>(end_ - start_);
  }

  /// Appends those of the next row.
  void row(std::vector<std::string_view>& fields) {
    for (;;) {
      fields.push_back(is_quoted() ? quoted() : plain());
      is_done_ = at_ == end_;
      if (is_done_) return;
      if (*at_++ == '\n') {
        ++line_;
        return;
      }
    }
  }

 private:
  std::string_view plain() {
    char* const first = at_;
    at_ = std::find_if(at_, end_, [&](char c) { return c == separator_ || c == '\n'; });
    const bool is_crlf = at_ < end_ && *at_ == '\n' && at_ > first && at_[-1] == '\r';
    const std::string_view field(first, static_cast<std::size_t>(at_ - first) - (is_crlf ? 1 : 0));
    if (field.find('\r') != field.npos)
      refuse_line(file_, line_, "expected lines that end in LF or CRLF, got a CR alone");
    return field;
  }

  std::string_view quoted() {
    const std::size_t opened = line_;
    char* const first = ++at_;
    char* to = first;
    for (;; *to++ = *at_++) {
      if (at_ == end_) refuse_line(file_, opened, "a quote that is not closed");
      if (*at_ == '\n') ++line_;
      if (*at_ == '"' && (++at_ == end_ || *at_ != '"')) break;
    }
    if (end_ - at_ >= 2 && at_[0] == '\r' && at_[1] == '\n') ++at_;
    if (at_ < end_ && *at_ != separator_ && *at_ != '\n')
      refuse_line(file_, line_, "text after a closing quote");
    return {first, static_cast<std::size_t>(to - first)};
  }

  const std::string& file_;
  char separator_;
  char* start_;
  char* at_;
  char* end_;
  bool is_done_;
  std::size_t line_ = 1;
};

// A header of one name that another separator would split.
void refuse_separator(const CsvTable& table, std::string_view header) {
  const auto found = header.find_first_of(",;\t");
  if (found == header.npos) return;
  const std::string separator = header[found] == '\t' ? "\\t" : std::string(1, header[found]);
  refuse_line(table.file, 1,
              "one column, '" + std::string(header) + "': separated by '" + separator +
                  "'? give separator = \"" + separator + "\"");
}

void read_header(CsvTable& table, const std::vector<std::string_view>& names) {
  double x = 0;
  if (std::all_of(names.begin(), names.end(),
                  [&](auto name) { return read_number(name, x) != std::errc::invalid_argument; }))
    refuse_line(table.file, 1,
                "expected a header row of names, got " + (names.size() == 1 && names[0].empty()
                                                              ? "a blank line"
                                                              : "'" + std::string(names[0]) + "'"));
  for (const auto name : names) {
    const std::string trimmed(without_blanks(name));
    for (const CsvColumn& before : table.columns) {
      if (before.name == trimmed)
        refuse_line(table.file, 1, "two columns have the name '" + trimmed + "'");
    }
    table.columns.push_back({trimmed, {}});
  }
}

// Column `c` of the cells, row by row: numbers if they all are.
void convert(CsvTable& table, std::size_t c, const std::vector<std::string_view>& cells) {
  const std::size_t width = table.columns.size();
  const std::size_t rows = table.lines.size();
  std::vector<double> numbers(rows);
  std::size_t empty = 0;
  std::optional<std::size_t> out_of_range;
  for (std::size_t row = 0; row < rows; ++row) {
    const std::string_view cell = cells[row * width + c];
    const std::errc error = read_number(cell, numbers[row]);
    if (error == std::errc::invalid_argument) {
      empty = rows;
      break;
    }
    if (without_blanks(cell).empty()) ++empty;
    if (error != std::errc() && !out_of_range) out_of_range = row;
  }
  if (rows == 0 || empty < rows) {
    if (out_of_range)
      table.refuse(*out_of_range, "'" + table.columns[c].name + "' is " +
                                      std::string(cells[*out_of_range * width + c]) +
                                      ", out of the range of doubles");
    table.columns[c].values = std::move(numbers);
    return;
  }
  std::vector<std::string> words;
  words.reserve(rows);
  for (std::size_t row = 0; row < rows; ++row) words.emplace_back(cells[row * width + c]);
  table.columns[c].values = std::move(words);
}

}  // namespace

std::size_t CsvColumn::size() const {
  return std::visit([](const auto& list) { return list.size(); }, values);
}

const CsvColumn& CsvTable::column(const std::string& name) const {
  std::vector<std::string> known;
  for (const CsvColumn& one : columns) {
    if (one.name == name) return one;
    known.push_back(one.name);
  }
  throw UnknownName("column", name, std::move(known));
}

const std::vector<double>& CsvTable::numbers(const CsvColumn& column) const {
  if (const auto* numbers = std::get_if<std::vector<double>>(&column.values)) return *numbers;
  const auto& words = std::get<std::vector<std::string>>(column.values);
  double x = 0;
  const auto word = std::find_if(words.begin(), words.end(), [&](const std::string& cell) {
    return read_number(cell, x) != std::errc();
  });
  // Where nothing is wrong all are empty: the first will do.
  const auto row = word == words.end() ? 0 : static_cast<std::size_t>(word - words.begin());
  refuse(row, "'" + column.name + "': expected a number, got \"" + words[row] + "\"");
}

void CsvTable::refuse(std::size_t row, const std::string& message) const {
  refuse_line(file, lines[row], message);
}

CsvTable read_csv(const std::filesystem::path& file, const Observer& observer, char separator) {
  if (std::string_view("\"\r\n").find(separator) != std::string_view::npos)
    throw std::invalid_argument("separator: expected no quote and no line end");
  CsvTable table{file.string(), {}, {}};
  std::string content = content_of(table.file, observer);
  Fields fields(content, table.file, separator);
  if (fields.is_done())
    throw std::invalid_argument(table.file + ": expected a header row of names, got an empty file");
  std::vector<std::string_view> cells;
  const bool is_quoted = fields.is_quoted();
  fields.row(cells);
  if (cells.size() == 1 && !is_quoted) refuse_separator(table, cells[0]);
  read_header(table, cells);
  const std::size_t width = cells.size();
  cells.clear();
  while (!fields.is_done()) {
    if (table.lines.size() % kRowsBetweenLooks == 0) look(observer, fields.part() / 2);
    table.lines.push_back(fields.line());
    fields.row(cells);
    const std::size_t count = cells.size() - (table.lines.size() - 1) * width;
    if (count != width)
      table.refuse(table.lines.size() - 1, "expected " + std::to_string(width) +
                                               " fields, as the header has, got " +
                                               std::to_string(count));
  }
  for (std::size_t c = 0; c < width; ++c) {
    look(observer, 0.5 + 0.5 * static_cast<double>(c) / static_cast<double>(width));
    convert(table, c, cells);
  }
  return table;
}

std::size_t write_csv(const std::filesystem::path& file, std::span<const CsvColumn> columns) {
  std::vector<std::string> header;
  for (const CsvColumn& column : columns) {
    header.push_back(column.name);
    if (column.size() != columns[0].size())
      throw std::invalid_argument("expected columns of one length, got " +
                                  std::to_string(columns[0].size()) + " values in '" +
                                  columns[0].name + "' and " + std::to_string(column.size()) +
                                  " in '" + column.name + "'");
  }
  CsvWriter writer(file, header);
  const std::size_t rows = columns[0].size();
  for (std::size_t row = 0; row < rows; ++row) {
    for (const CsvColumn& column : columns)
      std::visit([&](const auto& list) { writer.cell(list[row]); }, column.values);
    writer.end_row();
  }
  writer.commit();
  return rows;
}

}  // namespace rotor
