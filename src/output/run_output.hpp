// A run as a CSV file, as a table and as a picture. An observer that says no stops them:
// Interrupted.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>

#include "motion/run.hpp"
#include "output/canvas.hpp"
#include "output/columns.hpp"

namespace rotor {

/// Writes the states at the times as FILE, and where it comes from as FILE.json: program, columns
/// with their meaning, interval, start, method, accuracy, error estimate, cost. `scene` is a word
/// on what was run, for instance the script's name. To what is not a regular file (a pipe, a
/// terminal) the table alone is written, and the answer is false. Throws std::system_error if a
/// file cannot be written.
bool write_csv(const Run& run, std::span<const double> times, const Columns& columns,
               const std::filesystem::path& file, const std::string& scene,
               const Observer& observer = {});

/// Columns at the times as an aligned table for people; `number` writes the numbers.
std::string table(const Run& run, std::span<const double> times, const Columns& columns,
                  const std::function<std::string(double)>& number, const Observer& observer = {});

/// Columns over time as an ASCII plot.
std::string plot(const Run& run, std::span<const double> times, const Columns& columns,
                 PlotOptions options = {}, const Observer& observer = {});

}  // namespace rotor
