// Goal 6: quaternions, CSV, memory.
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>

#include "measure.hpp"
#include "output/csv.hpp"
#include "scratch.hpp"

namespace rotor::bench {
namespace {

constexpr double kMiB = 1 << 20;

void write_by_rotor(const Result& result, const std::filesystem::path& file) {
  const std::array<std::string, 5> header = {"t", "w", "x", "y", "z"};
  CsvWriter writer(file, header);
  for (std::size_t i = 0; i < result.samples.size(); ++i) {
    const Quaternion& q = result.samples[i];
    writer.row(std::array<double, 5>{p5().times[i], q.w(), q.x(), q.y(), q.z()});
  }
  writer.commit();
}

void write_by_printf(const Result& result, const std::filesystem::path& file) {
  std::FILE* const out = std::fopen(file.c_str(), "w");
  if (out == nullptr) throw std::runtime_error("cannot write " + file.string());
  std::fputs("t,w,x,y,z\n", out);
  for (std::size_t i = 0; i < result.samples.size(); ++i) {
    const Quaternion& q = result.samples[i];
    std::fprintf(out, "%.17g,%.17g,%.17g,%.17g,%.17g\n", p5().times[i], q.w(), q.x(), q.y(), q.z());
  }
  std::fclose(out);
}

template <class Work>
double seconds_of(const Work& work) {
  const double begin = cpu_seconds();
  work();
  return cpu_seconds() - begin;
}

/// The two numbers that the command prints.
std::array<double, 2> two_numbers_from(const std::string& command) {
  const std::string said = output_of(command);
  std::array<double, 2> numbers{};
  if (std::sscanf(said.c_str(), "%lf %lf", &numbers[0], &numbers[1]) != 2) {
    throw std::runtime_error(command + ": expected two numbers, got " + said);
  }
  return numbers;
}

/// CPU seconds and peak memory (kB, above that of a start) of a script on `run`, the motion of P1.
std::array<double, 2> cost_of_script(const std::string& script, const Scratch& scratch) {
  const auto file = scratch / "script.lua";
  std::ofstream(file) << "local function peak()\n"
                         "  local status = io.open('/proc/self/status'):read('a')\n"
                         "  return tonumber(status:match('VmHWM:%s*(%d+)'))\n"
                         "end\n"
                         "local cos, sin, a = math.cos, math.sin, 2*math.pi/40\n"
                         "local before = peak()\n"
                         "local run = evolve{\n"
                         "  omega = function(t) return cos(a*t), sin(a*t), 0 end,\n"
                         "  from = rotation({1, 1, 1}, 1), to = 4200, accuracy = 2e-9\n"
                         "}\n"
                         "local begin = os.clock()\n"
                      << script << "\nio.stderr:write(os.clock() - begin, ' ', peak() - before)\n";
  return two_numbers_from(ROTOR_BINARY " '" + file.string() + "' 2>&1 >/dev/null");
}

/// kB by which the peak of this process's memory grows while a child of it works.
template <class Work>
double growth_kb(const Work& work) {
  const auto peak = [] {
    std::ifstream status("/proc/self/status");
    std::string word;
    double kb = NAN;
    while (status >> word && word != "VmHWM:") {
    }
    status >> kb;
    return kb;
  };
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
  const pid_t child = fork();
  if (child == 0) {
    try {
      const double before = peak();
      work();
      const double growth = peak() - before;
      _exit(write(ends[1], &growth, sizeof growth) == sizeof growth ? 0 : 1);
    } catch (const std::exception&) {
      _exit(1);
    }
  }
  close(ends[1]);
  double growth = NAN;
  if (read(ends[0], &growth, sizeof growth) != sizeof growth) growth = NAN;
  close(ends[0]);
  waitpid(child, nullptr, 0);
  return growth;
}

}  // namespace

void judge_memory(Goals& goals) {
  const Solver rotor = rotor_solver();
  const Problem& problem = p5();
  const double kb = growth_kb([&] { rotor.run(problem, Kind::kNative, 1e-9); });
  const double output = static_cast<double>(problem.times.size() * sizeof(Quaternion));
  goals.at_most(6, "P5 in C++, MiB of memory above its output of " + three_digits(output / kMiB),
                kb * 1024 / kMiB - output / kMiB, 16);
  const Scratch scratch;
  const auto file = scratch / "run.csv";
  const auto csv = cost_of_script(
      "run:csv('" + file.string() + "', {every = 0.01, columns = {'t', 'quaternion'}})", scratch);
  const auto sample = cost_of_script("local states = run:sample{every = 0.01}", scratch);
  const auto megabytes = static_cast<double>(std::filesystem::file_size(file)) / 1e6;
  std::printf("\nP5 in Lua, 420,001 states: run:csv %s s (%s MB/s), run:sample %s s\n",
              three_digits(csv[0]).c_str(), three_digits(megabytes / csv[0]).c_str(),
              three_digits(sample[0]).c_str());
  std::printf("memory above the start: run:csv %s MiB, run:sample %s MiB\n",
              three_digits(csv[1] / 1024).c_str(), three_digits(sample[1] / 1024).c_str());
  goals.at_most(6, "P5 by run:csv, MiB of memory", csv[1] / 1024, 16);
}

Race judge_outputs(int rounds, Goals& goals) {
  Race race =
      bench::race(p5(), {rotor_solver(), dense_peer()}, {1e-9}, rounds, {Kind::kNative}).front();
  print(race);
  const Entry* rotor = race.rotor(Kind::kNative);
  const Entry* peer = race.best_peer(Kind::kNative);
  const std::string what = "P5 native 1e-9, speed / dense dopri5";
  if (rotor == nullptr || peer == nullptr) {
    goals.miss(6, what + ": one of them does not arrive");
  } else {
    goals.at_least(6, what, peer->ms / rotor->ms, 2);
  }

  const Scratch scratch;
  const Result result = rotor_solver().run(p5(), Kind::kNative, 1e-9);
  std::vector<double> ours;
  std::vector<double> theirs;
  for (int round = 0; round < 3; ++round) {
    ours.push_back(seconds_of([&] { write_by_rotor(result, scratch / "rotor.csv"); }));
    theirs.push_back(seconds_of([&] { write_by_printf(result, scratch / "printf.csv"); }));
  }
  const double numbers = 5 * static_cast<double>(result.samples.size());
  std::printf("\nCSV, ns a number, writing included: rotor %s, printf %s\n",
              three_digits(1e9 * median(ours) / numbers).c_str(),
              three_digits(1e9 * median(theirs) / numbers).c_str());
  goals.at_least(6, "CSV, speed / printf %.17g", median(theirs) / median(ours), 4);
  return race;
}

}  // namespace rotor::bench
