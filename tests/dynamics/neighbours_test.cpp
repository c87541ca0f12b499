// Neighbours, against every pair looked at.
#include "dynamics/neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

#include "catch.hpp"
#include "dynamics/pair_distances.hpp"

namespace {

using namespace rotor;
using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;
using Space = PointSequence::Space;

Pairs found(const PointSequence& sequence, double distance) {
  Pairs pairs;
  visit_neighbours(sequence, distance, [&](std::size_t j, std::span<const std::uint32_t> row) {
    for (const std::uint32_t i : row) pairs.emplace_back(i, j);
    return true;
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

Pairs all(const PointSequence& sequence, double distance) {
  Pairs pairs;
  for (std::size_t j = 0; j < sequence.size(); ++j)
    for (std::size_t i = 0; i < j; ++i)
      if (sequence.distance(i, j) <= distance) pairs.emplace_back(i, j);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

PointSequence random_points(Space space, std::size_t n, double size, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  PointSequence sequence{space, {}};
  for (std::size_t i = 0; i < n; ++i) {
    std::array<double, 4> p{normal(generator), normal(generator), normal(generator),
                            normal(generator)};
    if (space == Space::kVectors) {
      for (double& x : p) x *= size;
      p[3] = 0;
    } else {
      const double norm = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2] + p[3] * p[3]);
      for (double& x : p) x /= norm;
    }
    sequence.points.push_back(p);
  }
  return sequence;
}

}  // namespace

TEST_CASE("neighbours are what looking at every pair finds") {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    for (const double distance : {1e-3, 0.1, 0.7, 3.0, 100.0}) {
      CAPTURE(seed, distance);
      const PointSequence vectors = random_points(Space::kVectors, 60 * seed, 1, seed);
      CHECK(found(vectors, distance) == all(vectors, distance));
      const PointSequence rotations = random_points(Space::kRotations, 60 * seed, 1, seed);
      CHECK(found(rotations, distance) == all(rotations, distance));
    }
  }
  CHECK(found(random_points(Space::kVectors, 1, 1, 1), 1).empty());
}

TEST_CASE("neighbours are found however far apart the points lie") {
  PointSequence sequence = random_points(Space::kVectors, 200, 1e-3, 7);
  for (std::size_t i = 0; i < 100; ++i) sequence.points[i][i % 3] += 1e9 * static_cast<double>(i);
  sequence.points[150] = {1.6e16, 0, 0, 0};
  sequence.points[151] = {-1e300, 1e300, 0, 0};
  sequence.points[152] = sequence.points[151];
  for (const double distance : {1e-300, 1e-3, 1e3, 1e200}) {
    CAPTURE(distance);
    CHECK(found(sequence, distance) == all(sequence, distance));
  }
}

TEST_CASE("a pair at the distance itself is a pair, and points may coincide") {
  PointSequence lattice;
  for (int i = 0; i < 64; ++i)
    lattice.points.push_back({double(i / 16), double(i / 4 % 4), double(i % 4), 0});
  CHECK(found(lattice, 1).size() == 3 * 3 * 16);  // the edges of a cube of 4 x 4 x 4
  CHECK(found(lattice, std::nextafter(1, 0)).empty());
  lattice.points.resize(128, {9, 9, 9, 0});
  CHECK(found(lattice, 0.5).size() == 64 * 63 / 2);
}

TEST_CASE("q and -q are one rotation, and all are within pi") {
  PointSequence sequence{Space::kRotations, {{1, 0, 0, 0}, {-1, 0, 0, 0}, {0, 0, 0, 1}}};
  CHECK(found(sequence, 1e-9) == Pairs{{0, 1}});
  CHECK(found(sequence, 3.14).size() == 1);
  CHECK(found(sequence, std::numbers::pi).size() == 3);
  CHECK(found(sequence, 7).size() == 3);
  CHECK(sequence.distance(0, 2) == Approx(std::numbers::pi).epsilon(1e-15));
}

// The angle of a random rotation has the distribution (a - sin a)/pi, and the angles between pairs
// of random rotations are independent two by two: the variance of their count is that of as many
// independent trials.
TEST_CASE("random rotations are as near one another as theory says") {
  const std::size_t n = 4000;
  const PointSequence sequence = random_points(Space::kRotations, n, 1, 11);
  for (const double angle : {0.2, 1.0, 2.5}) {
    CAPTURE(angle);
    const double trials = pair_count(n, 1);
    const double share = (angle - std::sin(angle)) / std::numbers::pi;
    const double count = static_cast<double>(found(sequence, angle).size());
    CHECK(std::abs(count - share * trials) < 5 * std::sqrt(share * (1 - share) * trials));
  }
}

TEST_CASE("a search for neighbours ends where its visitor says so") {
  std::size_t rows = 0;
  visit_neighbours(random_points(Space::kVectors, 50, 1, 3), 1,
                   [&](std::size_t, std::span<const std::uint32_t>) { return ++rows < 10; });
  CHECK(rows == 10);
}

TEST_CASE("the threshold of a rate is the distance of the pair of that rank") {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    for (const auto space : {Space::kVectors, Space::kRotations}) {
      const std::size_t theiler = seed;
      const PointSequence sequence = random_points(space, 150, 2, seed);
      std::vector<double> distances;
      for (std::size_t j = 0; j < sequence.size(); ++j)
        for (std::size_t i = 0; i + theiler <= j; ++i) distances.push_back(sequence.distance(i, j));
      std::sort(distances.begin(), distances.end());
      CHECK(static_cast<double>(distances.size()) == pair_count(sequence.size(), theiler));
      for (const double rate : {1e-9, 1e-3, 0.01, 0.3, 0.999, 1.0}) {
        CAPTURE(seed, rate, theiler);
        const auto rank =
            static_cast<std::size_t>(std::ceil(rate * static_cast<double>(distances.size())) - 1);
        const double threshold = threshold_of_rate(sequence, rate, theiler);
        CHECK(threshold >= distances[rank]);
        std::size_t pairs = 0;  // those found there: as many as asked for
        for (const auto& [a, b] : found(sequence, threshold)) pairs += b - a >= theiler ? 1 : 0;
        CHECK(pairs == rank + 1);
        CHECK(threshold <= distances[rank] * (1 + 1e-14));
      }
    }
  }
}
