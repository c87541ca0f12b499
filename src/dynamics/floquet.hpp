// The frequencies that a motion under a periodic omega can have, from one period of it.
#pragma once

#include <optional>
#include <string>

#include "dynamics/fraction.hpp"
#include "motion/run.hpp"

namespace rotor {

/// The two frequencies of the motion under an omega of period T, cycles per unit of t.
///
/// U(t) = P(t) exp(b 2 pi f t), P of period T and b the unit axis of U(T) (Floquet): f = beta/(2 pi
/// T), beta half the angle of U(T). Adding whole drives to f, or turning b and f round, leaves U as
/// it is; `floquet` is the one that is strongest in U, positive. The frequencies are |j drive + k
/// floquet|: k = +-1 in the quaternion and M, which are linear in U; 0 or +-2 in the matrix and the
/// points of the body, which are quadratic; any k in what is not polynomial (E, n, theta, G). An
/// initial rotation changes amplitudes only.
struct FloquetFrequencies {
  double drive;  // 1/T; 0 where omega is constant
  double floquet;
  double amplitude;  // of that line in the unit quaternion U, at most 1
  double error = 0;  // of `floquet`, by the run's error estimate
};

/// The period that omega is known to have: of a PeriodicSpin, of a TurningSpin.
std::optional<double> drive_period(const AngularVelocity& omega);

/// The greatest |omega| at 16 times of the period from t on, backward where it is negative.
double greatest_rate(const Run& run, double t, double period);

/// From one period after the start. Of a constant omega the period does not matter. Throws
/// std::invalid_argument unless the period is positive and no longer than the run, and where omega,
/// as far as two periods tell, does not repeat with it.
FloquetFrequencies floquet_frequencies(const Run& run, double period);
/// With the period that omega is known to have; none where none is, or where the run is shorter.
std::optional<FloquetFrequencies> floquet_frequencies(const Run& run);

/// f_F over the drive, where that is a fraction (see fraction_within): all frequencies are
/// commensurate then, and the motion is periodic. None where omega is constant.
std::optional<Fraction> commensurate(const FloquetFrequencies& basis);

/// j drive + k floquet.
struct Combination {
  int j;
  int k;
  double difference;  // of the frequency from it

  /// "f_F", "drive - f_F", "2 f_F - 3 drive".
  std::string name() const;
};

/// The simplest combination of that frequency, of least |j| + |k| and then of the least difference,
/// |k| <= 8, that is no further from it than `tolerance` and |k| times the error of f_F; none where
/// none is, or where the drive is so slow that any frequency would be one.
std::optional<Combination> combination(const FloquetFrequencies& basis, double frequency,
                                       double tolerance);

}  // namespace rotor
