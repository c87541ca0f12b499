// Which files --test runs.
#pragma once

#include <string>
#include <vector>

namespace rotor::app {

/// The files among `paths`, and all *.lua in the directories among them, each directory sorted.
/// Throws std::runtime_error for a path that is not there and when nothing is found.
std::vector<std::string> tests_to_run(const std::vector<std::string>& paths);

}  // namespace rotor::app
