// Tables for people.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace rotor {

enum class Align {
  kAuto,  // kPoint if every cell reads as a number (or is empty), else kLeft
  kLeft,
  kRight,
  kPoint,  // the decimal points stand below each other
};

/// The header, a rule and the rows, two blanks between the columns, no blanks at line ends; every
/// line ends with '\n'. Rows may be shorter than the header: their last cells are empty.
/// `alignment` may name the first columns only: the others are kAuto. Throws std::invalid_argument
/// on a row longer than the header.
std::string table(std::span<const std::string> header,
                  std::span<const std::vector<std::string>> rows,
                  std::span<const Align> alignment = {});

/// A table of numbers for people, `width` characters wide at most. What does not fit side by side
/// with 6 significant digits (or `digits`, if that is fewer) stands in blocks with a blank line
/// between, each with the first column again; a column too wide stands beside that one alone. There
/// are as many digits, `digits` at most, as these blocks have room for. If it is `numbered`, the
/// first column, i, counts the rows from 1. There is a column at least.
std::string number_table(const std::vector<std::string>& header,
                         std::span<const std::vector<double>> rows, int digits,
                         bool numbered = false, std::size_t width = 80);

}  // namespace rotor
