// The rules of the house about includes, as functions of text, so that they can be tried on made-up
// files.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace rotor::house {

/// Folder of src/ to floor number, from the rows `| n | `folder/` | ... |` of src/README.md.
using Floors = std::map<std::string, int>;
Floors floors_of(const std::string& readme);

/// What the file `path` (relative to src/) includes against the rules, one message each.
std::vector<std::string> include_faults(const std::string& path, const std::string& text,
                                        const Floors& floors);

}  // namespace rotor::house
