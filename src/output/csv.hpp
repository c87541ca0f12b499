// Tables of numbers as CSV.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

#include "output/file.hpp"

namespace rotor {

/// RFC 4180 with LF line ends: one header row, then rows of numbers, each the shortest text that
/// reads back as the same double; `nan`, `inf`, `-inf`. The file appears in `commit` (see
/// OutputFile, whose errors are this class's errors) and not before.
class CsvWriter {
 public:
  /// Throws std::invalid_argument on an empty header.
  CsvWriter(std::filesystem::path file, std::span<const std::string> header);

  /// Throws std::invalid_argument unless there is one value for each name of the header.
  void row(std::span<const double> values);
  std::size_t rows() const { return rows_; }
  void commit();

 private:
  void flush();

  OutputFile file_;
  std::size_t columns_;
  std::size_t rows_ = 0;
  std::string buffer_;  // its first used_ characters are to be written
  std::size_t used_ = 0;
};

}  // namespace rotor
