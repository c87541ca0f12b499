// The pairs of a sequence of points outside a Theiler window, and their distances.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "dynamics/neighbours.hpp"
#include "integrate/loop.hpp"

namespace rotor {

/// Throws std::invalid_argument unless theiler >= 1 and there is a pair with j - i >= theiler.
void check_theiler(std::size_t n, std::size_t theiler);

/// How many pairs of n points have j - i >= theiler.
double pair_count(std::size_t n, std::size_t theiler);

/// The distances of 1e5 pairs drawn at random, always the same ones, in order.
std::vector<double> sampled_distances(const PointSequence& sequence, std::size_t theiler);

/// `visit`, which stops by throwing Interrupted where the observer says no to the part done.
NeighbourVisitor watched(std::size_t n, const Observer& observer, NeighbourVisitor visit);

/// The smallest threshold, to rounding, at which that share of the pairs (0 to 1) recurs: the
/// distance of the pair of that rank. Throws std::invalid_argument for another rate, and where as
/// many pairs are at no distance at all.
double threshold_of_rate(const PointSequence& sequence, double rate, std::size_t theiler = 1,
                         const Observer& observer = {});

}  // namespace rotor
