// Files that are there whole or not at all.
#pragma once

#include <filesystem>
#include <string_view>

namespace rotor {

/// A file being written. A regular file is written under a temporary name in the same directory and
/// takes its own name, and the permissions of the file it replaces, in `commit`; until then the old
/// content stands. Whatever else the name leads to (a terminal, a pipe, this process's own output)
/// is written directly. Every failure is a std::system_error "FILE: reason"; after one, and after
/// `commit`, the file is closed.
class OutputFile {
 public:
  explicit OutputFile(std::filesystem::path file);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Unbuffered. On a closed file each of the three throws std::logic_error.
  void write(std::string_view content);
  void commit();
  void require_open() const;

  const std::filesystem::path& path() const { return path_; }

 private:
  void open_directly(int own_output);
  void open_temporary();
  void discard() noexcept;
  [[noreturn]] void fail(int error);

  std::filesystem::path path_;       // as given: what messages say
  std::filesystem::path target_;     // links followed: what is replaced
  std::filesystem::path temporary_;  // empty if written directly
  int descriptor_ = -1;
};

/// The whole content of `file`, by the same discipline.
void write_file(const std::filesystem::path& file, std::string_view content);

}  // namespace rotor
