#include "output/csv.hpp"

#include <charconv>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace rotor {
namespace {

constexpr std::size_t kFlushed = std::size_t{1} << 16;
// The longest shortest form is that of -2.2250738585072014e-308: 24 characters; then a separator.
constexpr std::size_t kNumber = 32;

/// A field of the header. An empty one is quoted, too: alone in its row it would be an empty line.
std::string field(const std::string& name) {
  if (!name.empty() && name.find_first_of(",\"\r\n") == std::string::npos) return name;
  std::string quoted = "\"";
  for (char c : name) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + '"';
}

char* write_number(char* to, double x) {
  if (std::isnan(x)) return std::strcpy(to, "nan") + 3;  // to_chars would write the sign of a NaN
  return std::to_chars(to, to + kNumber, x).ptr;
}

}  // namespace

CsvWriter::CsvWriter(std::filesystem::path file, std::span<const std::string> header)
    : file_(std::move(file)), columns_(header.size()) {
  if (header.empty())
    throw std::invalid_argument(file_.path().string() + ": a CSV file needs at least one column");
  for (const std::string& name : header) buffer_ += field(name) + ',';
  buffer_.back() = '\n';
  used_ = buffer_.size();
  buffer_.resize(used_ + kFlushed + columns_ * kNumber);
}

void CsvWriter::row(std::span<const double> values) {
  file_.require_open();
  if (values.size() != columns_)
    throw std::invalid_argument(file_.path().string() + ": a row has " +
                                std::to_string(values.size()) + " values, the header has " +
                                std::to_string(columns_) + " names");
  char* end = buffer_.data() + used_;
  for (double value : values) {
    end = write_number(end, value);
    *end++ = ',';
  }
  end[-1] = '\n';
  used_ = static_cast<std::size_t>(end - buffer_.data());
  ++rows_;
  if (used_ >= kFlushed) flush();
}

void CsvWriter::commit() {
  flush();
  file_.commit();
}

void CsvWriter::flush() {
  file_.write(std::string_view(buffer_).substr(0, used_));
  used_ = 0;
}

}  // namespace rotor
