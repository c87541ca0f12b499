// A program on a pseudo-terminal, driven as a person would: type, and wait for what must appear.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <vector>

class Pty {
 public:
  static constexpr std::chrono::seconds kPatience{20};  // far more than any machine needs

  /// Starts a program with these arguments and additions to the environment.
  explicit Pty(const std::vector<std::string>& arguments = {"-q"},
               const std::map<std::string, std::string>& environment = {},
               const std::string& program = ROTOR_BINARY);
  ~Pty();
  Pty(const Pty&) = delete;
  Pty& operator=(const Pty&) = delete;

  void type(const std::string& keys) const;
  void type_line(const std::string& line) const { type(line + "\r"); }

  /// Waits until `text` appears after what the last wait found. False: it did not.
  bool shows(const std::string& text);

  /// Waits for the program to end; its exit status, none if it does not end or a signal ended it.
  std::optional<int> status();

  /// Presses Ctrl-C until the program ends: the kernel makes one of two that come too fast.
  std::optional<int> status_after_interrupts();

  /// All that appeared so far.
  const std::string& screen() const { return screen_; }

 private:
  bool read_some(std::chrono::milliseconds timeout);

  pid_t child_ = -1;
  int terminal_ = -1;
  bool open_ = true;
  std::string screen_;
  std::size_t seen_ = 0;  // shows() found everything before
};
