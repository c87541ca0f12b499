// Goals 4 and 5.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "measure.hpp"
#include "rotation/text.hpp"

namespace rotor::bench {
namespace {

struct Floor {
  const Problem& problem;
  double most;  // of the quaternion's error; 0: no goal
};

/// Asked for 1e-4 ... 1e-12: the greatest ratio of the achieved rotation error to what it may be,
/// the accuracy or the estimate of the run that is greater.
double worst_of_promises(const Problem& problem, Kind kind, const Solver& rotor) {
  double worst = 0;
  for (int decade = 4; decade <= 12; ++decade) {
    const double asked = std::pow(10, -decade);
    const Result result = rotor.run(problem, kind, asked);
    // The distance d of unit quaternions is 2 sin(theta/4) for the rotation theta between them.
    const double error = 4 * std::asin(std::min(1.0, greatest_error(problem, result.samples) / 2));
    const double ratio = error / std::max(asked, result.error_estimate);
    if (!(ratio <= worst)) worst = ratio;
  }
  return worst;
}

}  // namespace

void judge_accuracy(Goals& goals) {
  const Solver rotor = rotor_solver();
  const Floor floors[] = {{p1(), 4e-13}, {p2(), 5e-14}, {p3(), 2e-13},
                          {p4(), 2e-14}, {p5(), 0},     {p1_long(), 2e-9}};
  std::printf(
      "\nrotor asked for 1e-4 ... 1e-12: the greatest achieved / allowed; and for 1e-16:\n"
      "%-12s %18s %16s %12s %9s\n",
      "", "achieved/allowed", "quaternion error", "rotation", "estimate");
  for (const Floor& floor : floors) {
    for (const Kind kind : {Kind::kNative, Kind::kLua}) {
      if (kind == Kind::kLua && &floor.problem == &p5()) continue;  // the run is that of P1
      const std::string name = floor.problem.name + (kind == Kind::kLua ? " Lua" : " native");
      const double ratio = worst_of_promises(floor.problem, kind, rotor);
      const Result result = rotor.run(floor.problem, kind, 1e-16);
      const double error = greatest_error(floor.problem, result.samples);
      std::printf("%-12s %18.2g %16.1e %12.1e %9.1e\n", name.c_str(), ratio, error, 2 * error,
                  result.error_estimate);
      goals.at_most(4, name + " 1e-4 ... 1e-12, achieved / allowed", ratio, 1);
      goals.between(4, name + " 1e-16, estimate / error", result.error_estimate / (2 * error), 1,
                    10);
      if (floor.most > 0) goals.at_most(5, name + ", floor", error, floor.most);
    }
  }
}

}  // namespace rotor::bench
