#include "dynamics/chart.hpp"

#include <stdexcept>

namespace rotor {

const char* name_of(Chart chart) {
  switch (chart) {
    case Chart::kEulerVector:
      return "euler_vector";
    case Chart::kModifiedGibbs:
      return "modified_gibbs";
    case Chart::kGibbs:
      return "gibbs";
    case Chart::kMrp:
      return "mrp";
    default:
      return "rotation";
  }
}

State chart_state(const Run& run, double t, Chart chart, const Observer& observer) {
  return chart == Chart::kEulerVector ? run(t, observer) : run.attitude(t);
}

Vector coordinates(Chart chart, const State& state) {
  switch (chart) {
    case Chart::kEulerVector:
      return state.euler_vector();
    case Chart::kModifiedGibbs:
      return state.modified_gibbs();
    case Chart::kGibbs:
      return state.gibbs();
    case Chart::kMrp:
      return state.mrp();
    default:
      throw std::invalid_argument("\"rotation\" has no coordinates: expected a chart");
  }
}

}  // namespace rotor
