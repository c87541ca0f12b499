// What is raced: the solvers, rotor's among them, behind one face.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "problem.hpp"

namespace rotor::bench {

/// The motion from start() at the problem's times; not all of them where the solver gave up.
struct Result {
  std::vector<Quaternion> samples;
  std::size_t omega_calls = 0;
  double error_estimate = std::numeric_limits<double>::quiet_NaN();  // rotor's, rad
};

struct Solver {
  std::string name;
  bool peer;
  /// With the tolerance as that solver takes it: rotor's accuracy, a peer's absolute and relative
  /// tolerance.
  std::function<Result(const Problem&, Kind, double tolerance)> run;
};

/// Odeint's runge_kutta_fehlberg78 and runge_kutta_dopri5, controlled, and bulirsch_stoer, each by
/// integrate_times; GSL's rk8pd by gsl_odeiv2_driver_apply to each time. The state is the
/// quaternion, 4 doubles.
std::vector<Solver> peers();
/// evolve{method = "fgl"} in Lua, or propagate in C++, and the quaternions at the times.
Solver rotor_solver();

/// A peer gives up after so many omega calls.
constexpr std::size_t kMostCalls = 40'000'000;

/// Odeint's dopri5 with its dense output.
Solver dense_peer();
/// The paper's method, RK4 on equation [P7]; its tolerance is the step.
Solver rk4_on_euler_vector();

}  // namespace rotor::bench
