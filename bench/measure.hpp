// What is measured: each prints its tables and gives its verdicts.
#pragma once

#include <cstddef>
#include <vector>

#include "goals.hpp"
#include "race.hpp"

namespace rotor::bench {

/// Prints a race as a table: solvers, tolerance, error, omega calls, ms and their ratios to
/// rotor's, native and with Lua.
void print(const Race& race);

/// Goals 1 and 2 of P1-P4, to each error for which there is one.
void judge_speed(const std::vector<Race>& races, Goals& goals);
/// Goal 3; beside the calls and times of the prototype.
void judge_calls(const std::vector<Race>& races, Goals& goals);
/// Goals 4 and 5: rotor asked for 1e-4 ... 1e-12, and for 1e-16.
void judge_accuracy(Goals& goals);
/// Goal 6 without the memory.
Race judge_outputs(int rounds, Goals& goals);
/// The memory of goal 6. First of all, as what was freed before would hide growth.
void judge_memory(Goals& goals);
/// Goal 7.
Race judge_paper(int rounds, Goals& goals);
/// Goal 8: that many starts of each.
void judge_start_up(std::size_t starts, Goals& goals);
/// Goals 9 to 12: strobe, Lyapunov exponents, recurrence, figures.
void judge_dynamics(int rounds, Goals& goals);

}  // namespace rotor::bench
