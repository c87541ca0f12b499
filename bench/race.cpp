#include "race.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <optional>

namespace rotor::bench {
namespace {

/// Something to be timed, and its times so far.
struct Runner {
  const Solver* solver;
  Entry entry;
  std::vector<double> seconds = {};
  double spent = 0;
};

double half_decade(int i) { return std::pow(10, -i / 2.0); }

struct Scan {
  std::vector<std::optional<Entry>> found;  // one a target, with the loosest tolerance
  double least_error = std::numeric_limits<double>::infinity();
};

Scan scan(const Problem& problem, const Solver& solver, Kind kind,
          const std::vector<double>& targets) {
  Scan result{std::vector<std::optional<Entry>>(targets.size())};
  for (int i = 4; i <= 32; ++i) {
    const double tolerance = half_decade(i);
    const Result run = solver.run(problem, kind, tolerance);
    const double error = greatest_error(problem, run.samples);
    result.least_error = std::min(result.least_error, error);
    bool all = true;
    for (std::size_t k = 0; k < targets.size(); ++k) {
      if (!result.found[k] && error <= targets[k]) {
        result.found[k] =
            Entry{solver.name, solver.peer, kind, tolerance, error, run.omega_calls, 0};
      }
      all = all && result.found[k];
    }
    if (all || run.omega_calls > kMostCalls) break;
  }
  return result;
}

void time_in_turn(const Problem& problem, std::vector<Runner>& runners, int rounds) {
  for (int round = 0; round < rounds; ++round) {
    for (Runner& runner : runners) {
      if (runner.spent > 1 && round >= 3) continue;
      const double begin = cpu_seconds();
      runner.solver->run(problem, runner.entry.kind, runner.entry.tolerance);
      runner.seconds.push_back(cpu_seconds() - begin);
      runner.spent += runner.seconds.back();
    }
  }
}

}  // namespace

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

const Entry* Race::rotor(Kind kind) const {
  for (const Entry& entry : entries) {
    if (!entry.peer && entry.kind == kind) return &entry;
  }
  return nullptr;
}

const Entry* Race::best_peer(Kind kind) const {
  const Entry* best = nullptr;
  for (const Entry& entry : entries) {
    if (entry.peer && entry.kind == kind && (best == nullptr || entry.ms < best->ms)) best = &entry;
  }
  return best;
}

std::vector<Race> race(const Problem& problem, const std::vector<Solver>& solvers,
                       const std::vector<double>& targets, int rounds,
                       const std::vector<Kind>& kinds) {
  std::vector<Race> races;
  races.reserve(targets.size());
  for (const double target : targets) races.push_back({&problem, target});
  std::vector<std::vector<Runner>> runners(targets.size());
  for (const Solver& solver : solvers) {
    // A peer computes the same numbers from the same function in Lua; rotor samples that sparsely.
    std::optional<Scan> same;
    for (const Kind kind : kinds) {
      if (!same || !solver.peer)
        same = scan(problem, solver, solver.peer ? Kind::kNative : kind, targets);
      Scan result = *same;
      for (std::size_t k = 0; k < targets.size(); ++k) {
        if (result.found[k]) {
          result.found[k]->kind = kind;
          runners[k].push_back({&solver, *result.found[k]});
        } else {
          races[k].absent.push_back({solver.name, kind, result.least_error});
        }
      }
    }
  }
  for (std::size_t k = 0; k < targets.size(); ++k) {
    time_in_turn(problem, runners[k], rounds);
    for (Runner& runner : runners[k]) {
      runner.entry.ms = 1e3 * median(runner.seconds);
      races[k].entries.push_back(runner.entry);
    }
  }
  return races;
}

}  // namespace rotor::bench
