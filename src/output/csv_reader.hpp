// Tables of numbers and words from CSV, and back.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "integrate/loop.hpp"

namespace rotor {

/// A column that is all numbers, or one of words.
struct CsvColumn {
  std::string name;
  std::variant<std::vector<double>, std::vector<std::string>> values;

  std::size_t size() const;
};

struct CsvTable {
  std::string file;  // for messages
  std::vector<CsvColumn> columns;
  std::vector<std::size_t> lines;  // of the file, from 1: where each row begins

  /// Throws UnknownName.
  const CsvColumn& column(const std::string& name) const;
  /// The values of that column; throws std::invalid_argument that names the first line whose value
  /// is not a number.
  const std::vector<double>& numbers(const CsvColumn& column) const;
  /// "FILE: line 3: message", an error in a row.
  [[noreturn]] void refuse(std::size_t row, const std::string& message) const;
};

/// Reads RFC 4180, or such a table with another separator, with LF or CRLF line ends, after a byte
/// order mark too: a header row of names, all different, then rows as long as the header. Blank
/// lines at the end do not count, nor do blanks around names and numbers. A column is one of
/// numbers if each of its fields, quoted or not, reads as one (nan, inf, -inf included; an empty
/// field is nan), but for empty ones; whatever the locale. Throws std::system_error where the file
/// cannot be read, std::invalid_argument "FILE: line 3: ..." where it is no such table, seems to
/// have another separator or a number is out of the range of doubles, std::invalid_argument where
/// the separator is a quote or a line end, and Interrupted where the observer, called with the part
/// done from 0 to 1, says no.
CsvTable read_csv(const std::filesystem::path& file, const Observer& observer = {},
                  char separator = ',');

/// Writes the columns, each double as the shortest text that reads back as the same; the answer is
/// the number of rows. Throws std::invalid_argument unless there is a column and all have the same
/// length, and as CsvWriter does.
std::size_t write_csv(const std::filesystem::path& file, std::span<const CsvColumn> columns);

}  // namespace rotor
