#include "goals.hpp"

#include <cstdio>

namespace rotor::bench {

std::string three_digits(double x) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, x >= 1000 && x < 1e9 ? "%.0f" : "%.3g", x);
  return buffer;
}

void Goals::at_least(int goal, const std::string& what, double measured, double wanted) {
  add(goal, what + ": " + three_digits(measured) + ", wanted >= " + three_digits(wanted),
      measured >= wanted);
}

void Goals::at_most(int goal, const std::string& what, double measured, double wanted) {
  add(goal, what + ": " + three_digits(measured) + ", wanted <= " + three_digits(wanted),
      measured <= wanted);
}

void Goals::between(int goal, const std::string& what, double measured, double least, double most) {
  add(goal,
      what + ": " + three_digits(measured) + ", wanted " + three_digits(least) + " ... " +
          three_digits(most),
      measured >= least && measured <= most);
}

void Goals::miss(int goal, const std::string& what) { add(goal, what, false); }

void Goals::add(int goal, const std::string& what, bool reached) {
  lines_.push_back({goal, what + (reached ? ": reached" : ": MISSED")});
  if (!reached) ++missed_;
}

void Goals::print() const {
  std::printf("\n");
  for (int goal = 1; goal <= 12; ++goal) {
    for (const Line& line : lines_) {
      if (line.goal == goal) std::printf("goal %d  %s\n", goal, line.text.c_str());
    }
  }
  std::printf("%zu of %zu lines reached\n", lines_.size() - missed_, lines_.size());
}

}  // namespace rotor::bench
