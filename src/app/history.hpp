// The file that keeps what was typed: one entry a line, with \n for a line break inside an entry
// and \\ for a backslash. Entries are appended as they come, so that nothing is lost whatever the
// session's end.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rotor::app {

class History {
 public:
  static constexpr std::size_t kMostEntries = 10'000;

  /// The file that the environment names; none when it names none, which keeps no history.
  static History from_environment();

  /// Keeps nothing.
  static History none() { return History({}); }

  /// The entries, oldest first. Leaves no more than kMostEntries in the file.
  std::vector<std::string> load() const;

  /// Makes the file and its directory where they are missing. Returns false when it cannot be
  /// written.
  bool append(const std::string& entry) const;

  const std::filesystem::path& path() const { return path_; }

 private:
  explicit History(std::filesystem::path path) : path_(std::move(path)) {}

  std::filesystem::path path_;
};

}  // namespace rotor::app
