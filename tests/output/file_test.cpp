#include "output/file.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <stdexcept>
#include <string>
#include <system_error>

#include "catch.hpp"
#include "temporary.hpp"

namespace rotor {
namespace {

namespace fs = std::filesystem;

template <class Action>
std::string failure(Action action) {
  try {
    action();
  } catch (const std::system_error& error) {
    return error.what();
  }
  return "no failure";
}

/// No file may grow beyond `size` bytes: a full disk that does not need a disk.
struct FileSizeLimit {
  explicit FileSizeLimit(rlim_t size) {
    getrlimit(RLIMIT_FSIZE, &before);
    handler = signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{size, before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before);
    signal(SIGXFSZ, handler);
  }
  rlimit before{};
  void (*handler)(int) = nullptr;
};

TEST_CASE("a file appears whole, with commit") {
  TemporaryDirectory here;
  const fs::path file = here.path / "new";
  {
    OutputFile output(file);
    output.write("one ");
    CHECK_FALSE(fs::exists(file));
    output.write("two");
    output.commit();
    CHECK(content_of(file) == "one two");
    CHECK_THROWS_AS(output.write("three"), std::logic_error);
    CHECK_THROWS_AS(output.commit(), std::logic_error);
  }
  CHECK(content_of(file) == "one two");
  CHECK(here.entries() == 1);
}

TEST_CASE("without commit the old content stands and nothing is left behind") {
  TemporaryDirectory here;
  const fs::path file = here.path / "kept";
  write_file(file, "old");
  {
    OutputFile output(file);
    output.write("new");
    CHECK(here.entries() == 2);
  }
  CHECK(content_of(file) == "old");
  CHECK(here.entries() == 1);
}

TEST_CASE("after a failed write the old content stands and nothing is left behind") {
  TemporaryDirectory here;
  const fs::path file = here.path / "kept";
  write_file(file, "old");
  {
    const FileSizeLimit limit(1000);
    CHECK(failure([&] { write_file(file, std::string(1001, 'x')); }) ==
          file.string() + ": File too large");
  }
  CHECK(content_of(file) == "old");
  CHECK(here.entries() == 1);
}

TEST_CASE("a failed rename says so and leaves nothing behind") {
  TemporaryDirectory here;
  const fs::path file = here.path / "name";
  OutputFile output(file);
  fs::create_directory(file);
  CHECK(failure([&] { output.commit(); }) == file.string() + ": Is a directory");
  CHECK(here.entries() == 1);
}

TEST_CASE("what cannot be opened is named with the reason") {
  TemporaryDirectory here;
  const auto failed = [](const fs::path& file) {
    return failure([&] { OutputFile output(file); });
  };
  CHECK(failed(here.path / "none" / "file") ==
        (here.path / "none" / "file").string() + ": No such file or directory");
  CHECK(failed(here.path) == here.path.string() + ": Is a directory");
  CHECK(failed(here.path / "slash" / "") == here.path.string() + "/slash/: Is a directory");
  CHECK(failed("") == ": No such file or directory");
  write_file(here.path / "file", "");
  CHECK(failed(here.path / "file" / "below") ==
        (here.path / "file" / "below").string() + ": Not a directory");
  CHECK(here.entries() == 1);
}

TEST_CASE("a full device is an error") {
  CHECK(failure([] { write_file("/dev/full", "x"); }) == "/dev/full: No space left on device");
  CHECK(fs::is_character_file("/dev/full"));
}

TEST_CASE("the longest name that a file may have will do") {
  TemporaryDirectory here;
  const fs::path file = here.path / std::string(255, 'n');
  write_file(file, "content");
  CHECK(content_of(file) == "content");
}

TEST_CASE("permissions: those of the replaced file, else those of the umask") {
  TemporaryDirectory here;
  const fs::path file = here.path / "file";
  const mode_t before = umask(027);
  write_file(file, "new");
  umask(before);
  CHECK(fs::status(file).permissions() == fs::perms{0640});
  fs::permissions(file, fs::perms{0604});
  write_file(file, "newer");
  CHECK(fs::status(file).permissions() == fs::perms{0604});
}

TEST_CASE("a protected file is not replaced") {
  TemporaryDirectory here;
  const fs::path file = here.path / "protected";
  write_file(file, "old");
  fs::permissions(file, fs::perms{0444});
  fs::permissions(here.path, fs::perms{0777});
  const bool is_root = geteuid() == 0;  // who may write everything
  constexpr uid_t kNobody = 65534;
  if (is_root) REQUIRE(seteuid(kNobody) == 0);
  const std::string message = failure([&] { write_file(file, "new"); });
  if (is_root) REQUIRE(seteuid(0) == 0);
  CHECK(message == file.string() + ": Permission denied");
  CHECK(content_of(file) == "old");
}

TEST_CASE("a symbolic link stays, its end is replaced or made") {
  TemporaryDirectory here;
  fs::create_directory(here.path / "data");
  fs::create_symlink("data/second", here.path / "first");
  fs::create_symlink("file", here.path / "data" / "second");
  for (const char* text : {"made", "replaced"}) {
    write_file(here.path / "first", text);
    CHECK(fs::is_symlink(here.path / "first"));
    CHECK(fs::is_symlink(here.path / "data" / "second"));
    CHECK(content_of(here.path / "data" / "file") == text);
  }
}

TEST_CASE("a pipe is written directly") {
  int ends[2];
  REQUIRE(pipe(ends) == 0);
  write_file("/proc/self/fd/" + std::to_string(ends[1]), "through");
  char read_back[16] = {};
  CHECK(read(ends[0], read_back, sizeof read_back) == 7);
  CHECK(std::string(read_back) == "through");
  close(ends[0]);
  close(ends[1]);
}

TEST_CASE("our own output, sent to a file, keeps its order") {
  TemporaryDirectory here;
  const fs::path file = here.path / "out";
  std::fflush(stdout);
  const int before = dup(STDOUT_FILENO);
  const int out = open(file.c_str(), O_WRONLY | O_CREAT, 0600);
  REQUIRE(dup2(out, STDOUT_FILENO) == STDOUT_FILENO);
  std::fputs("before ", stdout);
  const std::string failed = failure([] { write_file("/dev/stdout", "table "); });
  std::fputs("after", stdout);
  std::fflush(stdout);
  dup2(before, STDOUT_FILENO);
  close(before);
  close(out);
  CHECK(failed == "no failure");
  CHECK(content_of(file) == "before table after");
}

}  // namespace
}  // namespace rotor
