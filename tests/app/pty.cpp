#include "app/pty.hpp"

#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>

namespace {

using Clock = std::chrono::steady_clock;

[[noreturn]] void become(const std::string& program, const std::vector<std::string>& arguments,
                         const std::map<std::string, std::string>& environment) {
  for (const char* variable : {"LUA_INIT", "LUA_INIT_5_4", "NO_COLOR"}) {
    unsetenv(variable);
  }
  setenv("TERM", "xterm", 1);
  setenv("ROTOR_HISTORY", "", 1);
  setenv("INPUTRC", "/dev/null", 1);
  for (const auto& [name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
  std::vector<const char*> argv = {program.c_str()};
  for (const std::string& argument : arguments) argv.push_back(argument.c_str());
  argv.push_back(nullptr);
  execv(program.c_str(), const_cast<char* const*>(argv.data()));
  _exit(127);
}

}  // namespace

Pty::Pty(const std::vector<std::string>& arguments,
         const std::map<std::string, std::string>& environment, const std::string& program) {
  // Wide, so that no line of a test wraps.
  winsize size = {};
  size.ws_row = 50;
  size.ws_col = 500;
  child_ = forkpty(&terminal_, nullptr, nullptr, &size);
  if (child_ < 0) throw std::runtime_error("forkpty failed");
  if (child_ == 0) become(program, arguments, environment);
}

Pty::~Pty() {
  if (child_ > 0) {
    kill(child_, SIGKILL);
    waitpid(child_, nullptr, 0);
  }
  close(terminal_);
}

void Pty::type(const std::string& keys) const {
  if (write(terminal_, keys.data(), keys.size()) != static_cast<ssize_t>(keys.size())) {
    throw std::runtime_error("cannot type into the terminal");
  }
}

bool Pty::read_some(std::chrono::milliseconds timeout) {
  pollfd output = {terminal_, POLLIN, 0};
  if (!open_ || poll(&output, 1, static_cast<int>(timeout.count())) <= 0) return false;
  char buffer[4096];
  const ssize_t count = read(terminal_, buffer, sizeof buffer);
  open_ = count > 0;  // when the program has ended, reading fails
  if (open_) screen_.append(buffer, static_cast<std::size_t>(count));
  return open_;
}

bool Pty::shows(const std::string& text) {
  const auto deadline = Clock::now() + kPatience;
  for (;;) {
    const std::size_t found = screen_.find(text, seen_);
    if (found != std::string::npos) {
      seen_ = found + text.size();
      return true;
    }
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now());
    if (left.count() <= 0 || !read_some(left)) return false;
  }
}

std::optional<int> Pty::status() {
  const auto deadline = Clock::now() + kPatience;
  while (open_ && Clock::now() < deadline) read_some(std::chrono::milliseconds(100));
  int status = 0;
  if (open_ || waitpid(child_, &status, 0) != child_) return std::nullopt;
  child_ = -1;
  return WIFEXITED(status) ? std::optional<int>(WEXITSTATUS(status)) : std::nullopt;
}

std::optional<int> Pty::status_after_interrupts() {
  const auto deadline = Clock::now() + kPatience;
  while (open_ && Clock::now() < deadline) {
    type("\x03");
    read_some(std::chrono::milliseconds(200));
  }
  return status();
}
