// rotor beside the solvers of Odeint and GSL, and the goals line by line.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "measure.hpp"
#include "output/csv.hpp"

namespace {

using namespace rotor::bench;

constexpr const char* kUsage =
    "usage: bench/run [--quick]\n"
    "  --quick   fewer repetitions, and P1L by rotor alone\n"
    "Of the program that it builds:\n"
    "  --csv FILE  all rows of the races\n"
    "  --speed     goals 1 and 2 alone, at 1e-9\n"
    "  --dynamics  goals 9 to 12 alone\n";

struct Options {
  bool quick = false;
  bool speed = false;
  bool dynamics = false;
  std::string csv;
};

std::vector<Solver> all_solvers() {
  std::vector<Solver> solvers = peers();
  solvers.insert(solvers.begin(), rotor_solver());
  return solvers;
}

std::vector<Race> race_all(const Options& options) {
  const int rounds = options.quick ? 5 : 15;
  const std::vector<double> targets =
      options.speed ? std::vector<double>{1e-9}
                    : std::vector<double>{1e-4, 1e-6, 1e-8, 1e-9, 1e-10, 1e-12};
  std::vector<Race> races;
  const auto run = [&](const Problem& problem, const std::vector<Solver>& solvers, int times) {
    for (Race& race : rotor::bench::race(problem, solvers, targets, times)) {
      if (!options.speed) print(race);
      races.push_back(std::move(race));
    }
  };
  for (const Problem* problem : {&p1(), &p2(), &p3(), &p4()}) run(*problem, all_solvers(), rounds);
  if (options.speed) return races;
  run(p6(), all_solvers(), rounds);
  run(p1_long(), options.quick ? std::vector<Solver>{rotor_solver()} : all_solvers(), 1);
  return races;
}

void write_csv(const std::vector<Race>& races, const std::string& file) {
  const std::string header[] = {"problem", "target", "solver", "omega",
                                "asked",   "error",  "calls",  "ms"};
  rotor::CsvWriter writer(file, header);
  for (const Race& race : races) {
    for (const Entry& entry : race.entries) {
      writer.cell(race.problem->name);
      writer.cell(race.target);
      writer.cell(entry.solver);
      writer.cell(entry.kind == Kind::kLua ? "Lua" : "native");
      for (const double x : {entry.tolerance, entry.error, double(entry.omega_calls), entry.ms}) {
        writer.cell(x);
      }
      writer.end_row();
    }
  }
  writer.commit();
}

Options parse(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--quick") {
      options.quick = true;
    } else if (word == "--speed") {
      options.speed = true;
    } else if (word == "--dynamics") {
      options.dynamics = true;
    } else if (word == "--csv" && i + 1 < argc) {
      options.csv = argv[++i];
    } else {
      std::fputs(kUsage, word == "--help" ? stdout : stderr);
      std::exit(word == "--help" ? EXIT_SUCCESS : EXIT_FAILURE);
    }
  }
  return options;
}

int run(const Options& options) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  Goals goals;
  const char* portable = std::getenv("ROTOR_PORTABLE");
  std::printf("rotor: %s kernel; CPU time, medians of interleaved runs\n",
              portable != nullptr && *portable != 0 ? "portable" : "dispatched");
  if (options.speed) {
    judge_speed(race_all(options), goals);
    goals.print();
    return EXIT_SUCCESS;
  }
  if (options.dynamics) {
    judge_dynamics(options.quick ? 3 : 7, goals);
    goals.print();
    return goals.all_reached() ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  judge_memory(goals);
  judge_start_up(200, goals);
  judge_dynamics(options.quick ? 3 : 7, goals);
  std::vector<Race> races = race_all(options);
  judge_speed(races, goals);
  judge_calls(races, goals);
  judge_accuracy(goals);
  races.push_back(judge_outputs(3, goals));
  races.push_back(judge_paper(3, goals));
  if (!options.csv.empty()) write_csv(races, options.csv);
  goals.print();
  return goals.all_reached() ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(parse(argc, argv));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "rotor_bench: %s\n", error.what());
    return EXIT_FAILURE;
  }
}
