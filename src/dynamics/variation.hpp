// The linearised motion in a chart.
#pragma once

#include "dynamics/tangent.hpp"
#include "motion/run.hpp"

namespace rotor {

/// d' = A(t) d along a run, by DOP853 on the run's dense output: omega is taken from it, and no
/// script is called. Local errors are 1e-12 of d at most.
class Variation {
 public:
  Variation(const Run& run, Chart chart, double first_step);

  /// Follows d, of order 1, from t to t_end. False, with d as it was, where the chart is singular
  /// on the way or nearly so.
  bool advance(double t, double t_end, Matrix& d);

 private:
  Matrix rates(double t) const;
  double step(double t, double h, Matrix& d) const;

  const Run& run_;
  Chart chart_;
  double h_;
};

}  // namespace rotor
