// A recurrence matrix as a picture and as a CSV file. An observer (asked with the part done) that
// says no stops them: Interrupted.
#pragma once

#include <filesystem>
#include <string>

#include "dynamics/recurrence.hpp"
#include "output/picture.hpp"

namespace rotor {

/// The recurrence plot, t across and up, square where a character is twice as high as wide: in each
/// cell a mark by the share of its pairs of points that recur. Throws std::invalid_argument where
/// the size leaves no room.
std::string plot(const RunRecurrence& recurrence, const PlotOptions& options = {},
                 const Observer& observer = {});

/// All its points. Throws std::length_error where there are more than a million.
Picture points_picture(const RunRecurrence& recurrence, const PlotOptions& look = {},
                       const Observer& observer = {});

/// Writes the recurrent pairs i < j, counted from 1, with their times, and where they come from as
/// FILE.json (`scene` and the answer as for a run). Throws std::system_error if a file cannot be
/// written.
bool write_csv(const RunRecurrence& recurrence, const std::filesystem::path& file,
               const std::string& scene, const std::string& norm, const Observer& observer = {});

}  // namespace rotor
