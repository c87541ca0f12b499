// The linearised motion in a chart.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "dynamics/tangent.hpp"
#include "motion/run.hpp"

namespace rotor {

/// d' = A(t) d along a run, by collocation at 12 nodes of Gauss, of order 24, on the run's dense
/// output: omega is taken from it, and no script is called. Local errors are 1e-10 of d at most.
class Variation {
 public:
  /// D(t1) D(t0)^-1 of the tangent map, which goes across where the chart is singular or nearly so.
  using Bridge = std::function<Matrix(double t0, double t1)>;

  Variation(const Run& run, Chart chart, double first_step, Bridge bridge);

  /// From where the last call ended: follows the columns of d, orthonormal, from t to t_end, makes
  /// them orthonormal again on the way, and adds to logs those of the lengths (see orthonormalise).
  /// The chart is not singular at either time.
  void advance(double t, double t_end, Matrix& d, Vector& logs);
  /// How many stretches were bridged.
  std::size_t bridged() const { return bridged_; }

 private:
  struct Step;
  bool passable(const State& state) const;
  Matrix rate(double t, const State& state) const;
  Step step(double t, double t_next, const Matrix& rate_at_t) const;
  void follow(double t, double t_end, Matrix& d, Vector& logs);
  double end_of_bridge(double t, double t_end) const;

  const Run& run_;
  Chart chart_;
  double h_;
  Bridge bridge_;
  std::vector<double> stops_;  // in the order of the motion
  std::size_t next_stop_ = 0;
  double part_ = 0;  // of the chart
  std::size_t bridged_ = 0;
};

}  // namespace rotor
