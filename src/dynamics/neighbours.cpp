#include "dynamics/neighbours.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace rotor {
namespace {

using Point = std::array<double, 4>;

double chord_squared(const Point& p, const Point& q, double sign) {
  double sum = 0;
  for (std::size_t k = 0; k < 4; ++k) sum += (p[k] - sign * q[k]) * (p[k] - sign * q[k]);
  return sum;
}

// Points of D components in cells no smaller than the distance, so that neighbours are in cells
// next to one another. They are put in one after the other: what is there is what came before.
template <std::size_t D>
class CellGrid {
 public:
  using Place = std::array<double, D>;

  CellGrid(const std::vector<Place>& places, double distance)
      : square_(distance * distance), cell_of_(places.size()), slot_(places.size()) {
    std::vector<Keyed> keyed = keys(places, distance);
    std::sort(keyed.begin(), keyed.end());
    places_.resize(places.size());
    owners_.resize(places.size());
    std::vector<Key> cells;
    for (std::uint32_t slot = 0; slot < keyed.size(); ++slot) {
      const auto& [key, owner] = keyed[slot];
      if (cells.empty() || cells.back() != key) {
        cells.push_back(key);
        filled_.push_back(slot);
      }
      places_[slot] = places[owner];
      owners_[slot] = owner;
      slot_[owner] = slot;
      cell_of_[owner] = static_cast<std::uint32_t>(cells.size() - 1);
    }
    begin_ = filled_;
    find_neighbours(cells);
  }

  /// Appends those put in so far that are near the point.
  void near(std::uint32_t owner, std::vector<std::uint32_t>& found) const {
    const Place& p = places_[slot_[owner]];
    const std::uint32_t cell = cell_of_[owner];
    for (std::size_t n = near_begin_[cell]; n < near_begin_[cell + 1]; ++n) {
      const std::uint32_t begin = begin_[near_[n]];
      const std::uint32_t end = filled_[near_[n]];
      std::size_t count = found.size();
      found.resize(count + (end - begin));
      for (std::uint32_t slot = begin; slot < end; ++slot) {
        double square = 0;
        for (std::size_t k = 0; k < D; ++k) {
          const double d = places_[slot][k] - p[k];
          square += d * d;
        }
        found[count] = owners_[slot];
        count += square <= square_ ? 1 : 0;
      }
      found.resize(count);
    }
  }

  /// Points are put in by rising numbers.
  void put_in(std::uint32_t owner) { ++filled_[cell_of_[owner]]; }

 private:
  using Key = std::array<std::int64_t, D>;
  struct Keyed {
    Key key;
    std::uint32_t owner;
    auto operator<=>(const Keyed&) const = default;
  };

  // Cells are counted from the median of each component, to 2^40 both ways: the quotient is then
  // good to 2^-12, and the cell larger than the distance by more than that. What lies further out
  // is put into the last cell, which is still next to those of its neighbours.
  static std::vector<Keyed> keys(const std::vector<Place>& places, double distance) {
    constexpr double kMost = 0x1p40;
    const double size = distance * (1 + 0x1p-9);
    std::vector<Keyed> keyed(places.size());
    std::vector<double> component(places.size());
    for (std::size_t k = 0; k < D; ++k) {
      for (std::size_t i = 0; i < places.size(); ++i) component[i] = places[i][k];
      const auto middle = component.begin() + static_cast<std::ptrdiff_t>(component.size() / 2);
      std::nth_element(component.begin(), middle, component.end());
      for (std::size_t i = 0; i < places.size(); ++i) {
        const double cell = std::floor((places[i][k] - *middle) / size);
        keyed[i].key[k] = static_cast<std::int64_t>(std::clamp(cell, -kMost, kMost));
        keyed[i].owner = static_cast<std::uint32_t>(i);
      }
    }
    return keyed;
  }

  // Cells next to a cell, by the step in all components but the last, are three successive keys at
  // most; from one cell to the next, where they begin only moves on.
  void find_neighbours(const std::vector<Key>& cells) {
    constexpr std::size_t kSteps = D == 3 ? 9 : 27;
    std::array<std::size_t, kSteps> at{};
    near_begin_.assign(1, 0);
    for (const Key& cell : cells) {
      for (std::size_t step = 0; step < kSteps; ++step) {
        Key first = cell;
        for (std::size_t k = 0, rest = step; k + 1 < D; ++k, rest /= 3)
          first[k] += static_cast<std::int64_t>(rest % 3) - 1;
        --first[D - 1];
        Key last = first;
        last[D - 1] += 2;
        std::size_t& place = at[step];
        while (place < cells.size() && cells[place] < first) ++place;
        for (std::size_t c = place; c < cells.size() && cells[c] <= last; ++c)
          near_.push_back(static_cast<std::uint32_t>(c));
      }
      near_begin_.push_back(near_.size());
    }
  }

  double square_;
  std::vector<Place> places_;            // by cell, in a cell by number
  std::vector<std::uint32_t> owners_;    // the numbers of the places
  std::vector<std::uint32_t> cell_of_;   // by number
  std::vector<std::uint32_t> slot_;      // by number: where in places_
  std::vector<std::uint32_t> begin_;     // by cell, the first place
  std::vector<std::uint32_t> filled_;    // by cell, the end of the places put in
  std::vector<std::size_t> near_begin_;  // by cell, and the end
  std::vector<std::uint32_t> near_;      // the cells next to each cell, itself among them
};

// Sorts numbers below `end`, each once: where they are dense by marking them, for that takes no
// comparisons.
class Sorter {
 public:
  void sort(std::vector<std::uint32_t>& numbers, std::size_t end) {
    const std::size_t words = end / 64 + 1;
    if (words > 8 * numbers.size()) {
      std::sort(numbers.begin(), numbers.end());
      numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
      return;
    }
    marks_.resize(std::max(marks_.size(), words));
    for (const std::uint32_t number : numbers)
      marks_[number / 64] |= std::uint64_t{1} << number % 64;
    numbers.clear();
    for (std::size_t word = 0; word < words; ++word) {
      for (std::uint64_t bits = std::exchange(marks_[word], 0); bits != 0; bits &= bits - 1)
        numbers.push_back(static_cast<std::uint32_t>(64 * word) +
                          static_cast<std::uint32_t>(std::countr_zero(bits)));
    }
  }

 private:
  std::vector<std::uint64_t> marks_;
};

void visit_vectors(const PointSequence& sequence, double distance, const NeighbourVisitor& visit) {
  std::vector<std::array<double, 3>> places;
  places.reserve(sequence.size());
  for (const Point& p : sequence.points) places.push_back({p[0], p[1], p[2]});
  CellGrid<3> grid(places, distance);
  std::vector<std::uint32_t> found;
  Sorter sorter;
  for (std::uint32_t j = 0; j < sequence.size(); ++j) {
    found.clear();
    grid.near(j, found);
    sorter.sort(found, j);
    if (!visit(j, found)) return;
    grid.put_in(j);
  }
}

// Point i is there as p (2i) and as -p (2i + 1); it may be near as both.
void visit_rotations(const PointSequence& sequence, double distance,
                     const NeighbourVisitor& visit) {
  std::vector<Point> places;
  places.reserve(2 * sequence.size());
  for (const Point& p : sequence.points) {
    places.push_back(p);
    places.push_back({-p[0], -p[1], -p[2], -p[3]});
  }
  // No two rotations are further apart than pi, where the chord is sqrt 2.
  const double chord = distance >= std::numbers::pi ? 2 : 2 * std::sin(distance / 4);
  CellGrid<4> grid(places, chord);
  std::vector<std::uint32_t> found;
  Sorter sorter;
  for (std::uint32_t j = 0; j < sequence.size(); ++j) {
    found.clear();
    grid.near(2 * j, found);
    for (std::uint32_t& owner : found) owner /= 2;
    sorter.sort(found, j);
    if (!visit(j, found)) return;
    grid.put_in(2 * j);
    grid.put_in(2 * j + 1);
  }
}

}  // namespace

double PointSequence::distance(std::size_t i, std::size_t j) const {
  const double square = chord_squared(points[i], points[j], 1);
  if (space == Space::kVectors) return std::sqrt(square);
  const double nearer = std::min(square, chord_squared(points[i], points[j], -1));
  return 4 * std::asin(std::min(std::sqrt(nearer) / 2, 1.0));
}

void visit_neighbours(const PointSequence& sequence, double distance,
                      const NeighbourVisitor& visit) {
  if (sequence.size() >= std::size_t{1} << 31)
    throw std::length_error("2^31 points or more: give fewer");
  sequence.space == PointSequence::Space::kVectors ? visit_vectors(sequence, distance, visit)
                                                   : visit_rotations(sequence, distance, visit);
}

}  // namespace rotor
