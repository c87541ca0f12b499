#include "script/progress.hpp"

#include <unistd.h>

#include <cstdio>
#include <memory>

#include "script/interrupt.hpp"

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

Observer watching(double t0, double t1) {
  return [t0, t1, progress = std::make_shared<Progress>()](double t) {
    progress->show((t - t0) / (t1 - t0));
    return !interrupt_pending();
  };
}

}  // namespace rotor::script
