// Races: the loosest tolerance with which each solver reaches an error, and what that then costs.
#pragma once

#include <string>
#include <vector>

#include "solver.hpp"

namespace rotor::bench {

/// Seconds of this process's CPU time.
double cpu_seconds();
/// Of an odd number of values the middle one, of an even number the mean of the two; not empty.
double median(std::vector<double> values);

/// How a solver reached an error.
struct Entry {
  std::string solver;
  bool peer;
  Kind kind;
  double tolerance;
  double error;
  std::size_t omega_calls;
  double ms;  // median CPU time
};

/// All solvers on a problem to an error of at most `target`.
struct Race {
  const Problem* problem;
  double target;
  std::vector<Entry> entries = {};  // of those that reached it
  /// The others: solver, kind and the least error that it reached.
  struct Absent {
    std::string solver;
    Kind kind;
    double least_error;
  };
  std::vector<Absent> absent = {};

  /// rotor's entry, if it reached the target.
  const Entry* rotor(Kind kind) const;
  /// The fastest peer's, if any reached it.
  const Entry* best_peer(Kind kind) const;
};

/// Tolerances are tried from 1e-2 to 1e-16 in half decades until the achieved error, the greatest
/// over the problem's times, is at most the target. Then all of them run in turn, `rounds` times
/// over; one that has used up a second drops out of further rounds after three.
std::vector<Race> race(const Problem& problem, const std::vector<Solver>& solvers,
                       const std::vector<double>& targets, int rounds,
                       const std::vector<Kind>& kinds = {Kind::kNative, Kind::kLua});

}  // namespace rotor::bench
