#include "dynamics/pair_distances.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>

#include "rotation/text.hpp"

namespace rotor {
namespace {

// No two points are further apart.
double diameter(const PointSequence& sequence) {
  if (sequence.space == PointSequence::Space::kRotations) return std::numbers::pi;
  PointSequence corners{sequence.space, {sequence.points.front(), sequence.points.front()}};
  for (const auto& p : sequence.points) {
    for (std::size_t k = 0; k < p.size(); ++k) {
      corners.points[0][k] = std::min(corners.points[0][k], p[k]);
      corners.points[1][k] = std::max(corners.points[1][k], p[k]);
    }
  }
  return corners.distance(0, 1);
}

// Wider than the distance of that rank, but for bad luck.
double first_guess(const PointSequence& sequence, double rate, std::size_t theiler) {
  const std::vector<double> sample = sampled_distances(sequence, theiler);
  const double m = static_cast<double>(sample.size());
  const double rank = rate * m + 5 * std::sqrt(rate * (1 - rate) * m) + 5;
  if (rank >= m) return diameter(sequence);
  const double guess = sample[static_cast<std::size_t>(rank)];
  if (guess > 0) return guess;
  const auto positive = std::upper_bound(sample.begin(), sample.end(), 0.0);
  return positive == sample.end() ? diameter(sequence) : *positive;
}

}  // namespace

void check_theiler(std::size_t n, std::size_t theiler) {
  if (theiler == 0) throw std::invalid_argument("theiler must be at least 1, got 0");
  if (theiler >= n) {
    throw std::invalid_argument("theiler = " + std::to_string(theiler) + " leaves no pair of " +
                                std::to_string(n) + (n == 1 ? " point" : " points"));
  }
}

double pair_count(std::size_t n, std::size_t theiler) {
  const double rest = static_cast<double>(n - theiler);
  return rest * (rest + 1) / 2;
}

std::vector<double> sampled_distances(const PointSequence& sequence, std::size_t theiler) {
  constexpr std::size_t kSample = 100'000;
  std::mt19937_64 generator(1);
  std::vector<double> distances;
  distances.reserve(kSample);
  // Of a wide window few pairs are left, at the corners of the matrix.
  std::uniform_int_distribution<std::size_t> corner(0, sequence.size() - theiler);
  while (distances.size() < kSample) {
    const std::size_t a = corner(generator);
    const std::size_t b = corner(generator);
    if (a < b) distances.push_back(sequence.distance(a, b + theiler - 1));
  }
  std::sort(distances.begin(), distances.end());
  return distances;
}

NeighbourVisitor watched(std::size_t n, const Observer& observer, NeighbourVisitor visit) {
  return
      [n, &observer, visit = std::move(visit)](std::size_t j, std::span<const std::uint32_t> row) {
        const double part = static_cast<double>(j) / static_cast<double>(n);
        if (observer && !observer(part * part)) throw Interrupted();
        return visit(j, row);
      };
}

// The digits of the wanted distance, 16 bits a sweep, highest first: positive doubles are in the
// order of their bits.
double threshold_of_rate(const PointSequence& sequence, double rate, std::size_t theiler,
                         const Observer& observer) {
  if (!(rate > 0 && rate <= 1))
    throw std::invalid_argument("rate must be above 0 and at most 1, got " + text(rate));
  check_theiler(sequence.size(), theiler);
  const double wanted = std::ceil(rate * pair_count(sequence.size(), theiler) * (1 - 1e-14));
  double wide = first_guess(sequence, rate, theiler);
  std::uint64_t prefix = 0;
  auto rank = static_cast<std::uint64_t>(std::max(wanted, 1.0));
  for (int shift = 48; shift >= 0;) {
    std::vector<std::uint64_t> count(1 << 16);
    const auto tally = [&](std::size_t j, std::span<const std::uint32_t> row) {
      for (const std::uint32_t i : row) {
        if (i + theiler > j) continue;
        const auto bits = std::bit_cast<std::uint64_t>(sequence.distance(i, j));
        if (shift == 48 || bits >> (shift + 16) == prefix) ++count[bits >> shift & 0xffff];
      }
      return true;
    };
    if (wide > 0) visit_neighbours(sequence, wide, watched(sequence.size(), observer, tally));
    std::uint64_t digit = 0;
    while (digit < count.size() && count[digit] < rank) rank -= count[digit++];
    if (digit < count.size()) {
      prefix = prefix << 16 | digit;
      shift -= 16;
    } else if (wide > 0) {  // bad luck
      wide *= 2;
      rank = static_cast<std::uint64_t>(std::max(wanted, 1.0));
    } else {
      break;
    }
  }
  const double distance = std::bit_cast<double>(prefix);
  if (distance == 0 || wide == 0) {
    throw std::invalid_argument("rate = " + text(rate) +
                                " is had at no threshold: as many pairs are at distance 0.0");
  }
  // The search compares squares, or chords: not to lose the pair itself to rounding.
  return distance * (1 + 8 * std::numeric_limits<double>::epsilon());
}

}  // namespace rotor
