// A run as a CSV file, as a table and as a picture. An observer that says no stops them:
// Interrupted.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "motion/run.hpp"
#include "output/columns.hpp"
#include "output/picture.hpp"

namespace rotor {

/// Writes the states at the times as FILE, and where it comes from as FILE.json: program, columns
/// with their meaning, interval, start, method, accuracy, error estimate, cost. `scene` is a word
/// on what was run, for instance the script's name. To what is not a regular file (a pipe, a
/// terminal) the table alone is written, and the answer is false. Throws std::system_error if a
/// file cannot be written.
bool write_csv(const Run& run, std::span<const double> times, const StateColumns& columns,
               const std::filesystem::path& file, const std::string& scene,
               const Observer& observer = {});

/// Columns at the times as an aligned table for people, of at most `digits` significant digits.
std::string table(const Run& run, std::span<const double> times, const StateColumns& columns,
                  int digits, const Observer& observer = {});

/// Columns over time.
Picture picture(const Run& run, std::span<const double> times, const StateColumns& columns,
                const PlotOptions& look = {}, const Observer& observer = {});

/// The second of two columns over the first, at the times. Throws std::invalid_argument unless
/// there are two.
Picture points_picture(const Run& run, std::span<const double> times, const StateColumns& columns,
                       const PlotOptions& look = {}, const Observer& observer = {});

}  // namespace rotor
