#include "output/csv.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace rotor {
namespace {

constexpr std::size_t kFlushed = std::size_t{1} << 16;
// The longest shortest form is that of -2.2250738585072014e-308: 24 characters.
constexpr std::size_t kNumber = 32;

/// An empty word is quoted, too: alone in its row it would be an empty line; and what may be taken
/// for a separator.
std::string field(const std::string& word) {
  if (!word.empty() && word.find_first_of(",;\t\"\r\n") == std::string::npos) return word;
  std::string quoted = "\"";
  for (char c : word) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + '"';
}

}  // namespace

CsvWriter::CsvWriter(std::filesystem::path file, std::span<const std::string> header)
    : file_(std::move(file)), columns_(header.size()) {
  if (header.empty())
    throw std::invalid_argument(file_.path().string() + ": a CSV file needs at least one column");
  for (auto name = header.begin(); name != header.end(); ++name) {
    if (std::find(header.begin(), name, *name) != name)
      throw std::invalid_argument(file_.path().string() + ": two columns have the name '" + *name +
                                  "'");
    buffer_ += field(*name) + ',';
  }
  buffer_.back() = '\n';
}

void CsvWriter::row(std::span<const double> values) {
  file_.require_open();
  require_count(values.size());
  for (double value : values) cell(value);
  end_row();
}

void CsvWriter::cell(double value) {
  ++cells_;
  if (std::isnan(value)) {
    buffer_ += "nan,";  // to_chars would write the sign of a NaN
    return;
  }
  std::array<char, kNumber> number;
  buffer_.append(number.begin(), std::to_chars(number.begin(), number.end(), value).ptr) += ',';
}

void CsvWriter::cell(const std::string& word) {
  ++cells_;
  buffer_ += field(word) + ',';
}

void CsvWriter::end_row() {
  file_.require_open();
  require_count(std::exchange(cells_, 0));
  buffer_.back() = '\n';
  ++rows_;
  if (buffer_.size() >= kFlushed) flush();
}

void CsvWriter::commit() {
  flush();
  file_.commit();
}

void CsvWriter::flush() {
  file_.write(buffer_);
  buffer_.clear();
}

void CsvWriter::require_count(std::size_t count) const {
  if (count != columns_)
    throw std::invalid_argument(file_.path().string() + ": a row has " + std::to_string(count) +
                                " values, the header has " + std::to_string(columns_) + " names");
}

}  // namespace rotor
