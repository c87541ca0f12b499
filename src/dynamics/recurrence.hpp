// How a motion comes back to where it has been: the recurrence matrix, its lines and what they
// measure.
//
// R_ij = 1 where |x_i - x_j| <= threshold. The matrix is symmetric and not kept: its rows are found
// again where they are asked for (visit_neighbours).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "dynamics/chart.hpp"
#include "dynamics/neighbours.hpp"
#include "motion/run.hpp"

namespace rotor {

/// The states at the times, in a chart or as rotations. Throws std::invalid_argument unless there
/// are two times at least, rising or falling, and where the chart has no value.
PointSequence recurrence_points(const Run& run, std::span<const double> times, Chart norm,
                                const Observer& observer = {});

/// The distance between neighbours of times that are evenly spaced, to a millionth of it.
std::optional<double> even_spacing(std::span<const double> times);

struct RecurrenceOptions {
  /// Theiler window: pairs with |i - j| < theiler are left out; 1 leaves out i = j alone.
  std::size_t theiler = 1;
  /// The points of a diagonal, and of a vertical line, at least.
  std::size_t least_diagonal = 2;
  std::size_t least_vertical = 2;
};

/// Recurrence quantification as Marwan, Romano, Thiel, Kurths, Physics Reports 438 (2007) define
/// it, over the whole matrix outside the Theiler window. P(l) counts the diagonals of l points that
/// go on at neither end, P(v) the vertical lines; lengths are in points. A mean of nothing and a
/// share of nothing are nan.
struct RecurrenceMeasures {
  std::size_t pairs = 0;         // recurrent points i < j
  double rate = 0;               // RR: their share of all such pairs
  double determinism = 0;        // DET: sum of l P(l), l >= least, over that of all l
  double mean_diagonal = 0;      // L: sum of l P(l) / sum of P(l), l >= least
  std::size_t max_diagonal = 0;  // L_max; 0 where none is as long as the least
  double entropy = 0;            // ENTR: -sum of p ln p, p(l) = P(l) / sum of P(l), l >= least
  double divergence = 0;         // DIV = 1 / L_max
  double laminarity = 0;         // LAM: as DET, of vertical lines
  double trapping_time = 0;      // TT: as L, of vertical lines
  std::size_t max_vertical = 0;  // V_max
};

/// A recurrence matrix: what makes it, and what it measures.
struct Recurrence {
  PointSequence sequence;
  double threshold = 0;
  RecurrenceOptions options;
  RecurrenceMeasures measures;
  /// How many points of the diagonal of each lag j - i recur.
  std::vector<std::uint32_t> diagonals;
};

/// That of a run, with the times of its points.
struct RunRecurrence {
  std::vector<double> times;
  Chart norm = Chart::kEulerVector;
  Recurrence matrix;
};

/// Throws std::invalid_argument unless the threshold is positive and finite and the options leave
/// a pair; std::length_error where more than 1e10 pairs would recur; Interrupted where the observer
/// (asked with the part done, 0 to 1) says no.
Recurrence recurrence(PointSequence sequence, double threshold,
                      const RecurrenceOptions& options = {}, const Observer& observer = {});

/// A line of the recurrence plot parallel to its diagonal.
struct RecurrentLag {
  double lag;    // in points
  double share;  // of the diagonal that recurs
};

/// The lags at which the share of recurrent points is greatest between two dips to half of it, and
/// `least` or more: each in the middle between where it passes its half, interpolated. Diagonals of
/// fewer than 1/least points cannot measure such a share, and are left out. Throws
/// std::invalid_argument unless 0 < least <= 1.
std::vector<RecurrentLag> recurrent_lags(const Recurrence& matrix, double least = 0.01);

/// How many points pass between one that is within `distance` of the first, and the next: in their
/// order. On a circle [theory 4.3] there are at most three different ones, the greatest the sum of
/// the others. Throws std::invalid_argument unless the distance is positive.
std::vector<std::size_t> return_times(const PointSequence& sequence, double distance);

/// Visits the rows of the matrix as visit_neighbours does, without the Theiler window.
void visit_rows(const Recurrence& matrix, const NeighbourVisitor& visit);

}  // namespace rotor
