// The goals, each with what was measured.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace rotor::bench {

/// Collects the verdicts and prints them, goal by goal, as lines "goal 3  P1 Lua 1e-9, omega calls:
/// 1090, wanted <= 1300: reached".
class Goals {
 public:
  void at_least(int goal, const std::string& what, double measured, double wanted);
  void at_most(int goal, const std::string& what, double measured, double wanted);
  void between(int goal, const std::string& what, double measured, double least, double most);
  /// What could not be measured.
  void miss(int goal, const std::string& what);
  void print() const;
  bool all_reached() const { return missed_ == 0; }

 private:
  void add(int goal, const std::string& what, bool reached);
  struct Line {
    int goal;
    std::string text;
  };
  std::vector<Line> lines_;
  std::size_t missed_ = 0;
};

/// Three significant digits, or the nearest whole number from 1000 on: for people.
std::string three_digits(double x);

}  // namespace rotor::bench
