// Averages along a motion.
//
// Of a quasiperiodic motion with smooth samples the mean over n of them errs by O(1/n). The same
// samples with the weights exp(-1/(s (1 - s))), s from 0 to 1 along the way, which end flat, err by
// less than any power of 1/n (Das, Saiki, Sander, Yorke, in: The Foundations of Chaos Revisited,
// Springer 2016). Of a chaotic motion neither converges faster than the other.
#pragma once

#include <span>

namespace rotor {

struct Average {
  double plain = 0;
  double weighted = 0;
  /// How far the averages of the whole and of the two halves are apart, plain and weighted: what
  /// each may be wrong by, for a half alone.
  double plain_error = 0;
  double weighted_error = 0;
};

/// Of samples at equal intervals. Throws std::invalid_argument for fewer than two, and for one that
/// is not finite.
Average birkhoff(std::span<const double> samples);

/// Of the rate of `sum`, an integral along the way: (sum[i + 1] - sum[i])/|t[i + 1] - t[i]|,
/// weighted at the middles of these intervals and by their lengths. Times rise or fall. Throws
/// std::invalid_argument for fewer than three, for unequal numbers of times and sums, and for a sum
/// that is not finite.
Average birkhoff_rate(std::span<const double> t, std::span<const double> sum);

}  // namespace rotor
