// Goals 1, 2, 3 and 7.
#include <cstdio>

#include "measure.hpp"
#include "rotation/text.hpp"

namespace rotor::bench {
namespace {

const char* name_of(Kind kind) { return kind == Kind::kLua ? "Lua" : "native"; }

std::string cell(const Entry* entry, const Entry* rotor) {
  if (entry == nullptr) return "        -       -";
  char text[40];
  const std::string ratio = rotor == nullptr ? "-" : three_digits(entry->ms / rotor->ms);
  std::snprintf(text, sizeof text, "%9s %7s", three_digits(entry->ms).c_str(), ratio.c_str());
  return text;
}

const Entry* entry_of(const Race& race, const std::string& solver, Kind kind) {
  for (const Entry& entry : race.entries) {
    if (entry.solver == solver && entry.kind == kind) return &entry;
  }
  return nullptr;
}

void print_row(const std::string& name, const Race& race, const Entry& entry, bool native,
               bool lua) {
  const auto times = [&](Kind kind, bool wanted) {
    return wanted ? cell(entry_of(race, entry.solver, kind), race.rotor(kind))
                  : cell(nullptr, nullptr);
  };
  std::printf("%-21s %7.1e %7.1e %9zu %s %s\n", name.c_str(), entry.tolerance, entry.error,
              entry.omega_calls, times(Kind::kNative, native).c_str(),
              times(Kind::kLua, lua).c_str());
}

std::string to_error(const Race& race, Kind kind) {
  return race.problem->name + " " + name_of(kind) + " " + text(race.target, 1);
}

/// What the goals say of P1-P4 for a ratio to the best peer.
struct Wanted {
  Kind kind;
  double target;
  double ratio;
  double ratio_of_p4;
};
constexpr Wanted kWanted[] = {
    {Kind::kLua, 1e-9, 8, 4}, {Kind::kLua, 1e-6, 2.5, 2.5}, {Kind::kNative, 1e-9, 4, 2.5}};

void judge(const Race& race, const Wanted& wanted, Goals& goals) {
  const int goal = wanted.kind == Kind::kLua ? 1 : 2;
  const std::string what = to_error(race, wanted.kind);
  const double ratio = race.problem->name == "P4" ? wanted.ratio_of_p4 : wanted.ratio;
  const Entry* rotor = race.rotor(wanted.kind);
  const Entry* peer = race.best_peer(wanted.kind);
  if (rotor == nullptr) {
    goals.miss(goal, what + ": rotor does not arrive");
  } else if (peer == nullptr) {
    goals.at_least(goal, what + ", no peer arrives", std::numeric_limits<double>::infinity(),
                   ratio);
  } else {
    goals.at_least(goal, what + ", speed / " + peer->solver, peer->ms / rotor->ms, ratio);
  }
}

/// Of the method's prototype, portable code on another machine: omega calls and ms at 1e-9, and
/// the calls that the goal allows.
struct Prototype {
  const char* problem;
  const char* native;
  const char* lua;
  double most_calls;
};
constexpr Prototype kPrototype[] = {{"P1", "12k / 1.06", "1088 / 1.3", 1300},
                                    {"P2", "30k / 2.2", "10k / 4.1", 11'000},
                                    {"P3", "15k / 0.78", "10k / 2.3", 11'000},
                                    {"P4", "1.8k / 0.21", "960 / 0.43", 1100}};

const Race* find(const std::vector<Race>& races, const std::string& problem, double target) {
  for (const Race& race : races) {
    if (race.problem->name == problem && race.target == target) return &race;
  }
  return nullptr;
}

std::string calls_and_ms(const Entry* entry) {
  if (entry == nullptr) return "-";
  return std::to_string(entry->omega_calls) + " / " + three_digits(entry->ms);
}

}  // namespace

void print(const Race& race) {
  std::printf("\n%s, error <= %s\n%s\n", race.problem->name.c_str(), text(race.target, 1).c_str(),
              race.problem->statement.c_str());
  std::printf("%-21s %7s %7s %9s %9s %7s %9s %7s\n", "", "asked", "error", "calls", "native ms",
              "/ rotor", "Lua ms", "/ rotor");
  for (const Entry& entry : race.entries) {
    if (!entry.peer) {
      print_row(std::string("rotor, ") + name_of(entry.kind), race, entry,
                entry.kind == Kind::kNative, entry.kind == Kind::kLua);
    } else if (entry.kind == Kind::kNative) {
      print_row(entry.solver, race, entry, true, true);
    }
  }
  for (const Race::Absent& absent : race.absent) {
    const bool peer = absent.solver != "rotor";
    if (peer && absent.kind == Kind::kLua) continue;  // as native
    const std::string name = absent.solver + (peer ? "" : std::string(", ") + name_of(absent.kind));
    std::printf("%-21s       - %7.1e  is the least it reaches%s\n", name.c_str(),
                absent.least_error, peer ? " in 40 million calls" : "");
  }
}

void judge_speed(const std::vector<Race>& races, Goals& goals) {
  for (const Wanted& wanted : kWanted) {
    for (const char* problem : {"P1", "P2", "P3", "P4"}) {
      const Race* race = find(races, problem, wanted.target);
      if (race != nullptr) judge(*race, wanted, goals);
    }
  }
}

void judge_calls(const std::vector<Race>& races, Goals& goals) {
  std::printf("\nomega calls / ms at 1e-9\n%-4s %18s %18s %18s %18s\n", "", "native", "prototype",
              "Lua", "prototype");
  for (const Prototype& prototype : kPrototype) {
    const Race* race = find(races, prototype.problem, 1e-9);
    if (race == nullptr) continue;
    const Entry* lua = race->rotor(Kind::kLua);
    std::printf("%-4s %18s %18s %18s %18s\n", prototype.problem,
                calls_and_ms(race->rotor(Kind::kNative)).c_str(), prototype.native,
                calls_and_ms(lua).c_str(), prototype.lua);
    const std::string what = std::string(prototype.problem) + " Lua 1e-9, omega calls";
    if (lua == nullptr) {
      goals.miss(3, what + ": rotor does not arrive");
    } else {
      goals.at_most(3, what, static_cast<double>(lua->omega_calls), prototype.most_calls);
    }
  }
}

Race judge_paper(int rounds, Goals& goals) {
  // Its step is the first that the race tries, 1e-2; rotor must be at least as accurate.
  const Solver paper = rk4_on_euler_vector();
  const double target = greatest_error(p1(), paper.run(p1(), Kind::kNative, 0.01).samples);
  Race race = bench::race(p1(), {rotor_solver(), paper}, {target}, rounds).front();
  print(race);
  for (const Kind kind : {Kind::kNative, Kind::kLua}) {
    const std::string what =
        "P1 " + std::string(name_of(kind)) + ", speed / RK4 (h = 0.01), more accurate";
    const Entry* rotor = race.rotor(kind);
    if (rotor == nullptr) {
      goals.miss(7, what);
    } else {
      goals.at_least(7, what, race.best_peer(kind)->ms / rotor->ms, 50);
    }
  }
  return race;
}

}  // namespace rotor::bench
