#include "app/history.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

namespace rotor::app {
namespace {

namespace fs = std::filesystem;

constexpr int kOwnerOnly = 0600;

std::string escaped(const std::string& entry) {
  std::string line;
  for (const char c : entry) {
    if (c == '\n') {
      line += "\\n";
    } else if (c == '\\') {
      line += "\\\\";
    } else {
      line += c;
    }
  }
  return line;
}

std::string unescaped(const std::string& line) {
  std::string entry;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] != '\\' || i + 1 == line.size()) {
      entry += line[i];
    } else {
      ++i;
      entry += line[i] == 'n' ? '\n' : line[i];
    }
  }
  return entry;
}

/// One write, so that the lines of two sessions do not mix.
bool write_all(const fs::path& path, int flags, const std::string& text) {
  const int file = open(path.c_str(), flags | O_WRONLY | O_CREAT | O_CLOEXEC, kOwnerOnly);
  if (file < 0) return false;
  const ssize_t written = write(file, text.data(), text.size());
  return close(file) == 0 && written == static_cast<ssize_t>(text.size());
}

void rewrite(const fs::path& path, const std::vector<std::string>& entries) {
  std::string text;
  for (const std::string& entry : entries) text += escaped(entry) + "\n";
  fs::path fresh = path;
  fresh += ".new";
  std::error_code ignored;  // the longer file is as good
  if (write_all(fresh, O_TRUNC, text)) fs::rename(fresh, path, ignored);
}

}  // namespace

History History::from_environment() {
  if (const char* file = std::getenv("ROTOR_HISTORY")) return History(file);
  const char* state = std::getenv("XDG_STATE_HOME");
  if (state != nullptr && fs::path(state).is_absolute()) {
    return History(fs::path(state) / "rotor" / "history");
  }
  const char* home = std::getenv("HOME");
  if (home == nullptr || *home == '\0') return none();
  return History(fs::path(home) / ".local" / "state" / "rotor" / "history");
}

std::vector<std::string> History::load() const {
  std::vector<std::string> entries;
  std::error_code none;
  if (!fs::is_regular_file(path_, none)) return entries;
  std::ifstream file(path_);
  for (std::string line; std::getline(file, line);) entries.push_back(unescaped(line));
  if (entries.size() > kMostEntries) {
    entries.erase(entries.begin(), entries.end() - static_cast<std::ptrdiff_t>(kMostEntries));
    rewrite(path_, entries);
  }
  return entries;
}

bool History::append(const std::string& entry) const {
  if (path_.empty()) return true;
  std::error_code ignored;  // the write says it
  if (path_.has_parent_path()) fs::create_directories(path_.parent_path(), ignored);
  return write_all(path_, O_APPEND, escaped(entry) + "\n");
}

}  // namespace rotor::app
