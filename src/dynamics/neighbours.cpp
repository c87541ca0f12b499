#include "dynamics/neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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
    found_.resize(places.size() + 1);
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

  /// Those put in so far that are near the point, in no order.
  std::span<std::uint32_t> near(std::uint32_t owner) {
    const std::uint32_t place = slot_[owner];
    const std::uint32_t cell = cell_of_[owner];
    std::size_t count = 0;
    for (std::size_t n = near_begin_[cell]; n < near_begin_[cell + 1]; ++n)
      count = near_in(near_[n], place, count);
    return {found_.data(), count};
  }

  /// Points are put in by rising numbers.
  void put_in(std::uint32_t owner) { ++filled_[cell_of_[owner]]; }

 private:
  // The numbers of a cell along each component, the last one lowest.
  using Key = std::uint64_t;
  static constexpr int kBits = 64 / static_cast<int>(D);
  struct Keyed {
    Key key;
    std::uint32_t owner;
    bool operator<(const Keyed& other) const {
      return key < other.key || (key == other.key && owner < other.owner);
    }
  };

  // Cells are counted from the median of each component, and have at least a 2^-17 of what lies
  // about it. What is further out than there are numbers is put into the last cell, which is still
  // next to those of its neighbours. A number is rounded by 2^-10 at most, and a cell larger than
  // the distance by more than that.
  static std::vector<Keyed> keys(const std::vector<Place>& places, double distance) {
    const double most = std::ldexp(1, kBits - 1) - 2;
    std::vector<Keyed> keyed(places.size());
    for (std::size_t k = 0; k < D; ++k) {
      const Spread spread = spread_of(places, k);
      const double size = std::max(distance * (1 + 0x1p-9), spread.width * std::ldexp(8, -kBits));
      for (std::size_t i = 0; i < places.size(); ++i) {
        const double cell = std::floor((places[i][k] - spread.middle) / size);
        keyed[i].key =
            (keyed[i].key << kBits) + static_cast<Key>(std::clamp(cell, -most, most) + most + 1);
        keyed[i].owner = static_cast<std::uint32_t>(i);
      }
    }
    return keyed;
  }

  // Median and width of the middle half of a component, by a thousand or two of the points.
  struct Spread {
    double middle;
    double width;
  };
  static Spread spread_of(const std::vector<Place>& places, std::size_t k) {
    const std::size_t step = std::max<std::size_t>(places.size() / 1024, 1);
    std::vector<double> sample;
    sample.reserve(places.size() / step + 1);
    for (std::size_t i = 0; i < places.size(); i += step) sample.push_back(places[i][k]);
    std::sort(sample.begin(), sample.end());
    const std::size_t quarter = sample.size() / 4;
    const double width = sample[sample.size() - 1 - quarter] - sample[quarter];
    return {sample[sample.size() / 2], std::min(width, std::numeric_limits<double>::max())};
  }

  // Cells next to a cell, by the step in all components but the last, are three successive keys at
  // most; from one cell to the next, where they begin only moves on.
  void find_neighbours(const std::vector<Key>& cells) {
    constexpr std::size_t kSteps = D == 3 ? 9 : 27;
    std::array<Key, kSteps> steps{};
    for (std::size_t s = 0; s < kSteps; ++s) {
      for (std::size_t k = 0, rest = s; k + 1 < D; ++k, rest /= 3)
        steps[s] = (steps[s] + rest % 3 - 1) << kBits;  // modulo 2^64
    }
    std::array<std::size_t, kSteps> at{};
    near_begin_.assign(1, 0);
    for (const Key cell : cells) {
      for (std::size_t s = 0; s < kSteps; ++s) {
        const Key middle = cell + steps[s];
        while (at[s] < cells.size() && cells[at[s]] < middle - 1) ++at[s];
        for (std::size_t c = at[s]; c < cells.size() && cells[c] <= middle + 1; ++c)
          near_.push_back(static_cast<std::uint32_t>(c));
      }
      near_begin_.push_back(near_.size());
    }
  }

  std::size_t near_in(std::uint32_t cell, std::uint32_t place, std::size_t count) {
    const std::uint32_t begin = begin_[cell];
    const std::size_t size = filled_[cell] - begin;
    const Place p = places_[place];
    const Place* const places = places_.data() + begin;
    const std::uint32_t* const owners = owners_.data() + begin;
    std::uint32_t* const found = found_.data();
    const double most = square_;
    for (std::size_t i = 0; i < size; ++i) {
      double square = 0;
      for (std::size_t k = 0; k < D; ++k) square += (places[i][k] - p[k]) * (places[i][k] - p[k]);
      found[count] = owners[i];  // kept if it counts
      count += square <= most ? 1 : 0;
    }
    return count;
  }

  double square_;
  std::vector<Place> places_;            // by cell, in a cell by number
  std::vector<std::uint32_t> owners_;    // the numbers of the places
  std::vector<std::uint32_t> cell_of_;   // by number
  std::vector<std::uint32_t> slot_;      // by number: where by cell
  std::vector<std::uint32_t> begin_;     // by cell, the first place
  std::vector<std::uint32_t> filled_;    // by cell, the end of the places put in
  std::vector<std::size_t> near_begin_;  // by cell, and the end
  std::vector<std::uint32_t> near_;      // the cells next to each cell, itself among them
  std::vector<std::uint32_t> found_;
};

void visit_vectors(const PointSequence& sequence, double distance, const NeighbourVisitor& visit) {
  std::vector<std::array<double, 3>> places;
  places.reserve(sequence.size());
  for (const Point& p : sequence.points) places.push_back({p[0], p[1], p[2]});
  CellGrid<3> grid(places, distance);
  for (std::uint32_t j = 0; j < sequence.size(); ++j) {
    if (!visit(j, grid.near(j))) return;
    grid.put_in(j);
  }
}

// Point i is there as p (2i) and as -p (2i + 1). It may be near as both where the chord is sqrt 2
// or more, for |p - q|^2 + |p + q|^2 = 4.
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
  for (std::uint32_t j = 0; j < sequence.size(); ++j) {
    std::span<std::uint32_t> found = grid.near(2 * j);
    for (std::uint32_t& owner : found) owner /= 2;
    if (chord > 1.4) {
      std::sort(found.begin(), found.end());
      found = {found.begin(), std::unique(found.begin(), found.end())};
    }
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
