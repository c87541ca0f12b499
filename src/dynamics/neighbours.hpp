// Which points of a sequence lie near one another.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace rotor {

/// Points of a space in which a distance is measured.
struct PointSequence {
  enum class Space {
    kVectors,    // of 3 components, the fourth is 0: |p - q|
    kRotations,  // unit quaternions, of which p and -p are one: the angle 2 acos |p . q|, rad
  };
  Space space = Space::kVectors;
  std::vector<std::array<double, 4>> points;  // finite

  std::size_t size() const { return points.size(); }
  double distance(std::size_t i, std::size_t j) const;
};

/// Called with j and all i < j whose point is near point j, in no order; false ends the search.
using NeighbourVisitor = std::function<bool(std::size_t j, std::span<const std::uint32_t> earlier)>;

/// Visits every point j, in order, with its neighbours among those before it: the points at a
/// distance of at most `distance` > 0. Nothing is kept but the points, by the cell that they are
/// in: the cost is near n log n and what is found. Throws std::length_error for 2^31 points or
/// more.
void visit_neighbours(const PointSequence& sequence, double distance,
                      const NeighbourVisitor& visit);

}  // namespace rotor
