// Where a file of numbers comes from.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

#include "output/columns.hpp"
#include "output/json.hpp"

namespace rotor {

/// Writes FILE.json beside the table FILE: program, scene (a word on what was run, for instance the
/// script's name), rows, columns with their meaning, conventions, and what `more` adds. Where FILE
/// is no regular file (a pipe, a terminal) nothing is written, and the answer is false. Throws
/// std::system_error if the file cannot be written.
bool write_provenance(const std::filesystem::path& file, const Columns& columns, std::size_t rows,
                      const std::string& scene, const std::string& conventions,
                      const JsonObject& more = {});
/// The same of columns that are no choice from a state or a rotation.
bool write_provenance(const std::filesystem::path& file, std::span<const Column> columns,
                      std::size_t rows, const std::string& scene, const std::string& conventions,
                      const JsonObject& more = {});

}  // namespace rotor
