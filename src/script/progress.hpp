// How far a long computation is, for a person at a terminal.
#pragma once

#include <chrono>

#include "integrate/loop.hpp"

namespace rotor::script {

/// Shows the part done and the time left on stderr: only on a terminal, after one second, five
/// times a second at most; erased at the end.
class Progress {
 public:
  Progress();
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `part` from 0 to 1.
  void show(double part);

 private:
  using Clock = std::chrono::steady_clock;
  bool terminal_;
  bool shown_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_ = start_ + std::chrono::seconds(1);
};

/// An observer for work from t0 to t1: shows the progress, and says no once Ctrl-C came.
Observer watching(double t0, double t1);

}  // namespace rotor::script
