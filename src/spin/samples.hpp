// Logs of an angular velocity: their rows, and what may be wrong with them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "rotation/rotation.hpp"

namespace rotor {

/// One row of a log.
struct Sample {
  double t = 0;
  Vector omega = Vector::Zero();  // rad per unit of t
  std::size_t row = 0;            // of the data, from 1
  std::size_t line = 0;           // of the file where the row begins; 0: there is no file
};

struct Samples {
  std::string name;  // of the file, for messages; may be empty
  std::vector<Sample> rows;
};

/// "gyro.csv: message"; the message alone where there is no file.
std::string said_of(const Samples& samples, const std::string& message);

/// What becomes of rows that are no clean log.
struct Cleaning {
  enum class Duplicates { kRefuse, kFirst, kMean };

  bool skip_missing = false;  // leave out rows that have a number missing, or not finite
  bool sort = false;          // put rows that go back in time where they belong
  Duplicates duplicates = Duplicates::kRefuse;  // of rows of one time keep the first, or their mean
};

/// The rows as a clean log: finite, each time once, rising. Throws std::invalid_argument that lists
/// what is wrong by row, with the option that accepts it, where `cleaning` does not accept it; and
/// for fewer than two rows, or times further apart than the largest double.
Samples cleaned(Samples samples, const Cleaning& cleaning = {});

/// An interval between two rows that is much longer than most.
struct Gap {
  std::size_t row = 0;  // the row before it, its number in the data
  std::size_t line = 0;
  double from = 0;
  double to = 0;
};

/// The median interval between neighbours of a clean log.
double usual_interval(const Samples& samples);

/// The intervals longer than `factor` times the usual one, in a clean log. Throws
/// std::invalid_argument unless the factor is at least 1.
std::vector<Gap> gaps(const Samples& samples, double factor);

/// "gyro.csv: 2 intervals longer than 10 times the usual 0.01: after row 5 (line 6), 0.04 .. 0.9;
/// ...", or nothing where there are none.
std::string report_of(const std::vector<Gap>& gaps, const Samples& samples, double factor);

}  // namespace rotor
