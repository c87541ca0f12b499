// Tables as CSV.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

#include "output/file.hpp"

namespace rotor {

/// RFC 4180 with LF line ends: one header row, then rows of numbers, each the shortest text that
/// reads back as the same double (`nan`, `inf`, `-inf`), and of words. The file appears in `commit`
/// (see OutputFile, whose errors are this class's errors) and not before.
class CsvWriter {
 public:
  /// Throws std::invalid_argument on an empty header, and on two equal names.
  CsvWriter(std::filesystem::path file, std::span<const std::string> header);

  /// The next row, at once or cell by cell. Throws std::invalid_argument unless there is one value
  /// for each name of the header.
  void row(std::span<const double> values);
  void cell(double value);
  void cell(const std::string& word);
  void end_row();
  std::size_t rows() const { return rows_; }
  void commit();

 private:
  void flush();
  void require_count(std::size_t count) const;

  OutputFile file_;
  std::size_t columns_;
  std::size_t rows_ = 0;
  std::size_t cells_ = 0;  // of the row that has not ended
  std::string buffer_;
};

}  // namespace rotor
