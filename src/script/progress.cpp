#include "script/progress.hpp"

#include <unistd.h>

#include <cstdio>

namespace rotor::script {

Progress::Progress() : terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (shown_) std::fprintf(stderr, "\r%*s\r", 40, "");
}

void Progress::show(double part) {
  if (!terminal_) return;
  const Clock::time_point now = Clock::now();
  if (now < next_) return;
  next_ = now + std::chrono::milliseconds(200);
  shown_ = true;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  std::fprintf(stderr, "\r%5.1f %%  %.0f s left   ", 100 * part, elapsed * (1 - part) / part);
}

}  // namespace rotor::script
