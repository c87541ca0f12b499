// In what attitudes are compared, and motions measured.
#pragma once

#include <array>

#include "motion/run.hpp"

namespace rotor {

enum class Chart {
  kEulerVector,    // E = n theta, continuous
  kRotation,       // no coordinates: the rotation from one attitude to another
  kModifiedGibbs,  // M = n sin(theta/2)
  kGibbs,          // G = n tan(theta/2)
  kMrp             // n tan(theta/4)
};
inline constexpr std::array kCharts = {Chart::kEulerVector, Chart::kRotation, Chart::kModifiedGibbs,
                                       Chart::kGibbs, Chart::kMrp};

/// "euler_vector", "rotation", ...
const char* name_of(Chart chart);

/// The state of a run, as much of it as the chart needs: axis and angle for E alone.
State chart_state(const Run& run, double t, Chart chart, const Observer& observer = {});

/// The coordinates of such a state. Throws std::invalid_argument for kRotation, which has none.
Vector coordinates(Chart chart, const State& state);

}  // namespace rotor
