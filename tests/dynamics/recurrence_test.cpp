// Recurrence quantification, against its definitions written out, and against closed forms.
#include "dynamics/recurrence.hpp"

#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <random>
#include <stdexcept>

#include "catch.hpp"
#include "dynamics/pair_distances.hpp"
#include "motion/times.hpp"
#include "spin/models.hpp"

namespace {

using namespace rotor;
using Catch::Matchers::Contains;
constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// The definitions, on the whole matrix.
struct Definition {
  std::vector<std::vector<bool>> r;
  int n;

  Definition(const Recurrence& matrix) : n(static_cast<int>(matrix.sequence.size())) {
    const auto size = matrix.sequence.size();
    r.assign(size, std::vector<bool>(size));
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = 0; j < size; ++j)
        r[i][j] = (i > j ? i - j : j - i) >= matrix.options.theiler &&
                  matrix.sequence.distance(i, j) <= matrix.threshold;
  }
  bool at(int i, int j) const {
    return i >= 0 && j >= 0 && i < n && j < n &&
           r[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  }
  // P(l): lines in the direction (di, dj), by the product of the factors of the definition.
  std::map<int, double> lines(int di, int dj) const {
    std::map<int, double> count;
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        if (!at(i, j) || at(i - di, j - dj)) continue;
        int l = 1;
        while (at(i + l * di, j + l * dj)) ++l;
        ++count[l];
      }
    }
    return count;
  }
};

struct LineMeasures {
  double share, mean, entropy;
  std::size_t longest;
};
LineMeasures measures_of(const std::map<int, double>& lines, std::size_t least) {
  double all = 0, points = 0, number = 0;
  LineMeasures m{0, 0, 0, 0};
  for (const auto& [l, count] : lines) {
    all += l * count;
    if (static_cast<std::size_t>(l) < least) continue;
    points += l * count;
    number += count;
    m.longest = static_cast<std::size_t>(l);
  }
  for (const auto& [l, count] : lines)
    if (static_cast<std::size_t>(l) >= least)
      m.entropy -= count / number * std::log(count / number);
  m.share = points / all;
  m.mean = points / number;
  return m;
}

// Sums of at most some hundred terms: 1e-13 is beyond their rounding.
void check_same(double a, double b) {
  if (std::isnan(b)) {
    CHECK(std::isnan(a));
  } else {
    CHECK(a == Approx(b).epsilon(1e-13).margin(1e-13));
  }
}

void check_definitions(const Recurrence& matrix) {
  const Definition whole(matrix);
  const RecurrenceMeasures& m = matrix.measures;
  double recurrent = 0;
  for (const auto& row : whole.r)
    for (const bool is : row) recurrent += is ? 1 : 0;
  CHECK(2 * static_cast<double>(m.pairs) == recurrent);
  CHECK(m.rate == Approx(recurrent / 2 / pair_count(matrix.sequence.size(), matrix.options.theiler))
                      .epsilon(1e-15));
  const auto d = measures_of(whole.lines(1, 1), matrix.options.least_diagonal);
  check_same(m.determinism, d.share);
  check_same(m.mean_diagonal, d.mean);
  check_same(m.entropy, d.entropy);
  CHECK(m.max_diagonal == d.longest);
  CHECK(m.divergence == 1 / static_cast<double>(d.longest));
  const auto v = measures_of(whole.lines(1, 0), matrix.options.least_vertical);
  check_same(m.laminarity, v.share);
  check_same(m.trapping_time, v.mean);
  CHECK(m.max_vertical == v.longest);
}

// A walk, so that there are lines.
PointSequence walk(std::size_t n, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::uniform_real_distribution<double> step(-0.5, 0.5);
  PointSequence sequence;
  std::array<double, 4> p{};
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < 3; ++k) p[k] = 0.9 * p[k] + step(generator);
    sequence.points.push_back(p);
  }
  return sequence;
}

Run turn(double t1) { return evolve({AngularVelocity(Vector(0, 0, 1)), 0, t1}, Rotation()); }

Run paper_run(double t1) {
  const auto omega = std::make_shared<const TurningSpin>(Vector(1, 0, 0), Vector(0, 0, 1),
                                                         2 * std::numbers::pi / 40);
  return evolve({AngularVelocity(omega), 0, t1}, from_euler_vector(Vector(1, 1, 1) / std::sqrt(3)));
}

}  // namespace

TEST_CASE("recurrence quantification is what its definitions say") {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const RecurrenceOptions options{1 + seed % 4, 1 + seed % 3, 1 + seed % 5};
    for (const double threshold : {1e-6, 0.2, 0.6, 1.0, 9.0}) {
      CAPTURE(seed, threshold);
      check_definitions(recurrence(walk(5 + seed, seed), threshold, options));
    }
  }
}

TEST_CASE("a periodic motion has whole diagonals, at the multiples of its period") {
  const std::size_t period = 20;
  const std::size_t n = 201;
  const double every = 2 * std::numbers::pi / period;
  const auto times = times_every(0, every * static_cast<double>(n - 1), every);
  const Recurrence matrix =
      recurrence(recurrence_points(turn(times.back()), times, Chart::kRotation), 1e-6);
  const RecurrenceMeasures& m = matrix.measures;
  // Of lags 20, 40, ... 200: diagonals of 181, 161, ... 1 points.
  CHECK(m.pairs == 10 * 91);
  CHECK(m.determinism == Approx(909.0 / 910).epsilon(1e-15));
  CHECK(m.mean_diagonal == Approx(909.0 / 9).epsilon(1e-15));
  CHECK(m.max_diagonal == n - period);
  CHECK(m.entropy == Approx(std::log(9)).epsilon(1e-14));
  CHECK(m.laminarity == 0);
  CHECK(std::isnan(m.trapping_time));
  CHECK(m.max_vertical == 0);
  const auto lags = recurrent_lags(matrix, 0.1);
  REQUIRE(lags.size() == 9);  // the last diagonal has fewer than 10 points
  for (std::size_t k = 0; k < lags.size(); ++k) {
    CHECK(lags[k].lag == static_cast<double>(period * (k + 1)));
    CHECK(lags[k].share == 1);
  }
}

TEST_CASE("of a motion at rest everything recurs, and no lag stands out") {
  PointSequence rest{PointSequence::Space::kVectors, {50, {1, 2, 3, 0}}};
  const Recurrence matrix = recurrence(rest, 1e-12);
  CHECK(matrix.measures.rate == 1);
  CHECK(matrix.measures.max_diagonal == 49);
  CHECK(matrix.measures.max_vertical == 49);
  CHECK(matrix.measures.determinism == Approx(1224.0 / 1225).epsilon(1e-15));
  CHECK(recurrent_lags(matrix).empty());
  CHECK_THROWS_WITH(threshold_of_rate(rest, 0.5), Contains("distance 0.0") && Contains("0.5"));
}

TEST_CASE("where nothing recurs, the measures of lines are those of none") {
  const Recurrence matrix = recurrence(walk(30, 5), 1e-9);
  CHECK(matrix.measures.pairs == 0);
  CHECK(matrix.measures.rate == 0);
  CHECK(std::isnan(matrix.measures.determinism));
  CHECK(matrix.measures.max_diagonal == 0);
  CHECK(matrix.measures.divergence == kInf);
  CHECK(matrix.measures.entropy == 0);
  CHECK(recurrent_lags(matrix).empty());
}

TEST_CASE("a line has one lag, however its top is made, in the middle of its half height") {
  Recurrence matrix;
  const std::size_t n = 1000;
  matrix.diagonals.assign(n, 0);
  const auto put = [&](std::size_t lag, double share) {
    matrix.diagonals[lag] = static_cast<std::uint32_t>(std::lround(share * double(n - lag)));
  };
  put(1, 0.9);  // falls from the main diagonal: no line
  put(2, 0.4);
  const std::vector<double> top = {0.5, 0.7, 0.6, 0.8, 0.55};  // half of 0.8: both ends in between
  for (std::size_t k = 0; k < top.size(); ++k) put(98 + k, top[k]);
  put(300, 0.02);
  put(400, 0.005);  // less than the least
  put(950, 1);      // of a diagonal too short
  const auto lags = recurrent_lags(matrix);
  REQUIRE(lags.size() == 2);
  // Passed at 97 + 0.4/0.5 and 103 - 0.4/0.55; shares are rounded to 1/900.
  CHECK(lags[0].lag == Approx((97 + 0.8 + 103 - 8.0 / 11) / 2).margin(2e-3));
  CHECK(lags[0].share == Approx(0.8).margin(1e-3));
  CHECK(lags[1].lag == 300);
}

// The paper's Figure 11 (theory 5). A pair recurs as long as t is within threshold/|E'| of the lag,
// some 0.1: a sampling of 0.1 is needed to see the lines of threshold 0.1. The lags are known to
// half a sampling and half a digit.
TEST_CASE("the Euler vector of P15, T = 40, recurs at the lags of the paper's Figure 11") {
  const Run run = paper_run(2500);
  const auto times = times_every(0, 2500, 0.1);
  const auto points = recurrence_points(run, times, Chart::kEulerVector);
  const auto check = [&](double threshold, const std::vector<double>& expected) {
    const auto lags = recurrent_lags(recurrence(points, threshold));
    REQUIRE(lags.size() >= expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) {
      CAPTURE(threshold, k, lags[k].lag, lags[k].share);
      CHECK(std::abs(lags[k].lag * 0.1 - expected[k]) <= 0.05 + 0.05);
    }
    return lags.size();
  };
  CHECK(check(0.1, {720, 1440, 2160}) == 3);
  check(0.3, {161.4, 279.3, 440.7, 558.6, 720});
}

TEST_CASE("a recurrence matrix is asked for with care") {
  const Run run = turn(10);
  const auto times = times_in(0, 10, 11);
  const PointSequence points = recurrence_points(run, times, Chart::kMrp);
  for (const double wrong : {0.0, -1.0, kInf, kNan})
    CHECK_THROWS_WITH(recurrence(points, wrong), Contains("threshold must be positive and finite"));
  for (const double wrong : {0.0, -1.0, 1.5, kNan})
    CHECK_THROWS_WITH(threshold_of_rate(points, wrong), Contains("rate must be above 0"));
  for (const double wrong : {0.0, -1.0, 1.5, kNan})
    CHECK_THROWS_WITH(recurrent_lags(recurrence(points, 1), wrong), Contains("least"));
  CHECK_THROWS_WITH(recurrence(points, 1, {0, 2, 2}), Contains("theiler must be at least 1"));
  CHECK_THROWS_WITH(recurrence(points, 1, {11, 2, 2}), Contains("leaves no pair of 11 points"));
  CHECK(recurrence(points, 9, {10, 2, 2}).measures.pairs == 1);
  CHECK_THROWS_WITH(recurrence(points, 1, {1, 0, 2}), Contains("at least 1"));
  const auto points_at = [&](const std::vector<double>& at) {
    return recurrence_points(run, at, Chart::kEulerVector);
  };
  CHECK_THROWS_WITH(points_at({}), Contains("got 0"));
  CHECK_THROWS_WITH(points_at({1}), Contains("two points") && Contains("got 1"));
  CHECK_THROWS_WITH(points_at({1, 2, 2}), Contains("rise or fall"));
  CHECK_THROWS_WITH(points_at({3, 2, 4}), Contains("rise or fall"));
  CHECK_THROWS_AS(points_at({3, 12}), std::out_of_range);
  CHECK(points_at({3, 2, 1}).size() == 3);
}

TEST_CASE("a chart without a value is refused with its time") {
  // At rest from t = 1 on, where the angle is 0 but for rounding, and there is no axis.
  const AngularVelocity omega([](double t) { return Vector(0, 0, t < 1 ? -1 : 0); });
  Scene scene{omega, 0, 3};
  scene.breaks = {1};
  const Run run = evolve(scene, Rotation(Vector(0, 0, 1), 1));
  CHECK_THROWS_WITH(recurrence_points(run, times_in(0, 3, 31), Chart::kEulerVector),
                    Contains("no value at t = 1.0"));
  CHECK(recurrence_points(run, times_in(0, 3, 31), Chart::kRotation).size() == 31);
  const Run half = evolve({AngularVelocity(Vector(0, 0, 1)), 0, 1}, Rotation(Vector(0, 0, 1), 1));
  PointSequence gibbs = recurrence_points(half, times_in(0, 1, 5), Chart::kGibbs);
  CHECK(gibbs.points[0][2] == Approx(std::tan(0.5)).epsilon(1e-14));
}

TEST_CASE("a matrix of too many pairs is refused, and told what would do") {
  const PointSequence rest{PointSequence::Space::kVectors, {200'000, {1, 0, 0, 0}}};
  CHECK_THROWS_WITH(recurrence(rest, 1),
                    Contains("about 2.0e10 pairs") && Contains("fewer points"));
  CHECK_THROWS_WITH(recurrence(walk(200'000, 1), 9), Contains("threshold of about"));
}

TEST_CASE("a recurrence matrix stops where its observer says so") {
  const PointSequence points = walk(100, 3);
  const Observer no = [](double part) { return part < 0.25; };
  CHECK_THROWS_AS(recurrence(points, 1, {}, no), Interrupted);
  CHECK_THROWS_AS(threshold_of_rate(points, 0.1, 1, no), Interrupted);
}

TEST_CASE("times are evenly spaced, or not") {
  CHECK(even_spacing(times_every(0, 4200, 0.1)).value() == Approx(0.1).epsilon(1e-12));
  CHECK(even_spacing(times_in(1, -1, 101)).value() == Approx(0.02).epsilon(1e-12));
  CHECK_FALSE(even_spacing(std::vector<double>{0, 1, 3}));
}
