#include "output/file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

namespace rotor {
namespace fs = std::filesystem;
namespace {

/// The standard output or error stream if that is the file of `status`, else -1.
int own_output(const struct stat& status) {
  for (int descriptor : {STDOUT_FILENO, STDERR_FILENO}) {
    struct stat own;
    if (fstat(descriptor, &own) == 0 && own.st_dev == status.st_dev && own.st_ino == status.st_ino)
      return descriptor;
  }
  return -1;
}

/// Renaming onto a symbolic link would replace the link: the file at its end is meant. The bound
/// ends a circle.
fs::path end_of_links(fs::path file) {
  std::error_code none;
  for (int links = 0; links < 40 && fs::is_symlink(file, none); ++links)
    file = file.parent_path() / fs::read_symlink(file);
  return file;
}

}  // namespace

OutputFile::OutputFile(fs::path file) : path_(std::move(file)) {
  struct stat status;
  const bool exists = stat(path_.c_str(), &status) == 0;
  const int own = exists ? own_output(status) : -1;
  if (own >= 0 || (exists && !S_ISREG(status.st_mode))) {
    open_directly(own);
    return;
  }
  // A rename needs no leave of the file that it replaces: what is protected must be protected from
  // it, too.
  if (exists && faccessat(AT_FDCWD, path_.c_str(), W_OK, AT_EACCESS) != 0) fail(errno);
  open_temporary();
  if (exists && fchmod(descriptor_, status.st_mode & 0777) != 0) fail(errno);
}

OutputFile::~OutputFile() { discard(); }

// A second descriptor of our own output shares its place in the file, so that neither overwrites
// the other.
void OutputFile::open_directly(int own_output) {
  if (own_output >= 0) std::fflush(own_output == STDOUT_FILENO ? stdout : stderr);
  descriptor_ = own_output >= 0 ? fcntl(own_output, F_DUPFD_CLOEXEC, 0)
                                : open(path_.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC);
  if (descriptor_ < 0) fail(errno);
}

// The name does not contain the file's own, which may be as long as names can be.
void OutputFile::open_temporary() {
  static std::atomic<unsigned> count = 0;
  target_ = end_of_links(path_);
  if (!target_.has_filename()) fail(target_.empty() ? ENOENT : EISDIR);
  const std::string prefix = ".rotor-" + std::to_string(getpid()) + "-";
  do {
    temporary_ = target_.parent_path() / (prefix + std::to_string(count++) + ".tmp");
    descriptor_ = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  } while (descriptor_ < 0 && errno == EEXIST);
  if (descriptor_ < 0) fail(errno);
}

void OutputFile::write(std::string_view content) {
  require_open();
  while (!content.empty()) {
    const ssize_t written = ::write(descriptor_, content.data(), content.size());
    if (written >= 0)
      content.remove_prefix(static_cast<std::size_t>(written));
    else if (errno != EINTR)
      fail(errno);
  }
}

void OutputFile::commit() {
  require_open();
  if (close(std::exchange(descriptor_, -1)) != 0) fail(errno);
  if (temporary_.empty()) return;
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
  temporary_.clear();
}

void OutputFile::require_open() const {
  if (descriptor_ < 0) throw std::logic_error(path_.string() + ": the file is closed already");
}

void OutputFile::discard() noexcept {
  if (descriptor_ >= 0) close(std::exchange(descriptor_, -1));
  if (!temporary_.empty()) unlink(temporary_.c_str());
  temporary_.clear();
}

void OutputFile::fail(int error) {
  discard();
  throw std::system_error(error, std::generic_category(), path_.string());
}

void write_file(const fs::path& file, std::string_view content) {
  OutputFile output(file);
  output.write(content);
  output.commit();
}

}  // namespace rotor
