// The one time loop.
#pragma once

#include <cmath>
#include <cstddef>
#include <exception>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

#include "rotation/text.hpp"

namespace rotor {

/// Called before each step with the time reached; false stops the run there.
using Observer = std::function<bool(double t)>;

/// What an integration has cost.
struct Cost {
  std::size_t omega_calls = 0;
  std::size_t steps = 0;     // accepted
  std::size_t rejected = 0;  // tried and given up
  double seconds = 0;
};

/// A step whose result is no longer a finite number.
class StepOverflow : public std::overflow_error {
 public:
  using std::overflow_error::overflow_error;
};

/// A run of whose motion nothing would be known.
class AccuracyLost : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Thrown by omega to stop the run without having failed, as an observer does.
class Interrupted : public std::exception {
 public:
  const char* what() const noexcept override { return "interrupted"; }
};

/// Why a run ended before its end.
struct Stop {
  // "interrupted", "step limit", "step underflow", "step overflow", "accuracy lost", "omega failed"
  std::string reason;
  double t = 0;              // the time reached
  std::string message;       // for people
  std::exception_ptr cause;  // what omega threw, if it did
};

/// Steps shorter than this are not told apart from rounding: the nodes within one would fall
/// together.
inline double shortest_step(double t) {
  return 64 * std::numeric_limits<double>::epsilon() * std::abs(t);
}

/// The end of a step of length h, or less, on the way from t to `end`: no crumb is left there.
inline double step_towards(double end, double t, double h) {
  const double rest = std::abs(end - t);
  if (rest <= h || rest / 2 < shortest_step(t)) return end;
  const double length = rest < 2 * h ? rest / 2 : h;
  return end > t ? t + length : t - length;
}

/// Drives `method` from t0 to t1. A method has
///   double next(double t)               the end of the step that it would take from t,
///   bool step(double t, double t_next)  takes it, or rejects it and will propose a shorter one;
///   bool must_end(double t) const       whether a step has to end there, however short.
/// Steps end at doubles exactly, so that no error of time accumulates. Counts steps in `cost`.
/// Nothing if t1 was reached, else why not; an exception from omega is kept in Stop::cause.
template <class Method>
std::optional<Stop> integrate(Method& method, double t0, double t1, std::size_t max_steps,
                              const Observer& observer, Cost& cost) {
  double t = t0;
  try {
    while (t != t1) {
      if (observer && !observer(t)) return Stop{"interrupted", t, "interrupted", nullptr};
      if (cost.steps + cost.rejected >= max_steps) {
        return Stop{"step limit", t,
                    "step limit: max_steps = " + std::to_string(max_steps) + " are used up",
                    nullptr};
      }
      const double t_next = method.next(t);
      if (t_next == t ||
          (t_next != t1 && !method.must_end(t_next) && std::abs(t_next - t) < shortest_step(t))) {
        return Stop{
            "step underflow", t,
            "step underflow: a step of " + text(t_next - t, 2) +
                " is below what t resolves there (where steps adapt: omega jumps, or is not "
                "smooth)",
            nullptr};
      }
      if (method.step(t, t_next)) {
        ++cost.steps;
        t = t_next;
      } else {
        ++cost.rejected;
      }
    }
  } catch (const Interrupted& interrupted) {
    return Stop{interrupted.what(), t, interrupted.what(), nullptr};
  } catch (const StepOverflow& error) {
    return Stop{"step overflow", t, error.what(), nullptr};
  } catch (const AccuracyLost& error) {
    return Stop{"accuracy lost", t, error.what(), nullptr};
  } catch (const std::exception& error) {
    return Stop{"omega failed", t, error.what(), std::current_exception()};
  }
  return std::nullopt;
}

}  // namespace rotor
