// Lyapunov exponents of the attitude flow, as charts see them.
//
// The flow on the unit quaternions is a multiplication by U(t), an isometry: whatever omega is, its
// three exponents are exactly 0. In a chart, neighbouring motions separate by
//   D(t) = J(t) G(t) J(t0)^-1,
// J of tangent.hpp, G the matrix of U(t) where omega is given in the space frame and 1 in the body
// frame. D is bounded as long as J and its inverse are, so its finite-time exponents go to 0 as
// 1/(t - t0): what they measure is the chart.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "dynamics/birkhoff.hpp"
#include "dynamics/tangent.hpp"
#include "motion/run.hpp"

namespace rotor {

/// D(t). Not finite, or not invertible, where the chart is singular at one of the two times.
Matrix tangent_map(const Run& run, double t, Chart chart);

/// log(s_i)/|t - t0|, largest first, of the singular values s_i of D(t): how fast the ball of
/// neighbours has become an ellipsoid with these half axes. nan where the chart is singular at t to
/// within the error of the run. Throws std::invalid_argument where it is at the start, or for
/// t = t0.
Vector finite_time_exponents(const Run& run, double t, Chart chart);

enum class LyapunovMethod {
  kExact,  // singular values of D(t)
  kQr      // the linearised equation d' = A d, made orthonormal again at each time
};

struct LyapunovSpectrum {
  /// Those asked for, the start excepted.
  std::vector<double> times;
  /// The exponents from the start to each of the times, largest first; nan where there are none.
  std::vector<Vector> history;
  /// The largest of the three weighted averages of the local rates of expansion, those of
  /// log R_ii(t) in D(t) = Q R: where the motion is quasiperiodic and the chart is regular all
  /// along it, they come to the exponents faster than any power of t. nan for fewer than two times.
  Average local;
  /// The times at which the chart is singular to within the error of the run.
  std::vector<double> singular;
  /// How many times D went across a singularity of the chart: by kQr where it is singular or nearly
  /// so, by kExact as many as the times see.
  std::size_t bridged = 0;
};

/// The spectrum at the times, in the order of the motion; the start may be among them. By kQr the
/// exponents at a time are the sums of log R_ii so far, sorted: those of the singular values but
/// for O(1/t). Throws std::invalid_argument for times out of order, none after the start, or a
/// chart that is singular at the start; std::out_of_range for one outside the run.
LyapunovSpectrum lyapunov_spectrum(const Run& run, std::span<const double> times, Chart chart,
                                   LyapunovMethod method, const Observer& observer = {});

/// Makes the columns of m orthonormal in their order and gives the logarithms of the lengths that
/// they had across those before them: log R_ii of m = Q R.
Vector orthonormalise(Matrix& m);

}  // namespace rotor
