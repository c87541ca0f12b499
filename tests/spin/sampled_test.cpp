// Interpolated omega against cubic_splines.csv, against polynomials, and against what defines it.
#include "spin/sampled.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>

#include "refusal.hpp"
#include "rotation/text.hpp"

using namespace rotor;

namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Samples samples_of(const std::vector<double>& times, const std::vector<Vector>& values) {
  Samples samples;
  for (std::size_t i = 0; i < times.size(); ++i)
    samples.rows.push_back({times[i], values[i], i + 1, 0});
  return samples;
}

// Intervals over `decades`.
std::vector<double> random_times(std::mt19937_64& random, std::size_t count, double decades) {
  std::uniform_real_distribution<double> exponent(-decades, 0);
  std::vector<double> times = {-0.7};
  while (times.size() < count) times.push_back(times.back() + std::pow(10, exponent(random)));
  return times;
}

struct TableSpline {
  std::vector<double> times, values;
  std::vector<std::pair<double, double>> between;
};
std::vector<TableSpline> table_splines() {
  std::ifstream file(std::string(ROTOR_SOURCE_DIR) + "/tests/spin/cubic_splines.csv");
  std::vector<TableSpline> splines;
  for (std::string line; std::getline(file, line);) {
    std::istringstream cells(line);
    std::string number, kind, t, value;
    std::getline(cells, number, ',');
    std::getline(cells, kind, ',');
    std::getline(cells, t, ',');
    std::getline(cells, value, ',');
    splines.resize(std::max<std::size_t>(splines.size(), std::stoul(number) + 1));
    const double x = std::strtod(t.c_str(), nullptr), y = std::strtod(value.c_str(), nullptr);
    if (kind == "knot") {
      splines.back().times.push_back(x);
      splines.back().values.push_back(y);
    } else {
      splines.back().between.emplace_back(x, y);
    }
  }
  return splines;
}

// The largest sum, at eleven places an interval, of the magnitudes of the splines of unit samples.
double lebesgue_constant(const std::vector<double>& times) {
  std::vector<double> sums(11 * (times.size() - 1), 0);
  for (std::size_t k = 0; k < times.size(); ++k) {
    std::vector<Vector> values(times.size(), Vector::Zero());
    values[k].x() = 1;
    const SampledSpin unit(samples_of(times, values), Interpolation::kCubic);
    for (std::size_t i = 0; i < sums.size(); ++i) {
      const double x = static_cast<double>(i % 11) / 11;
      sums[i] += std::abs(unit.value(times[i / 11] * (1 - x) + times[i / 11 + 1] * x).x());
    }
  }
  return *std::max_element(sums.begin(), sums.end());
}

// The sum of the jet's terms at a distance s.
Vector sum_of(const VectorJet& jet, double s) {
  Vector sum = Vector::Zero();
  for (std::size_t k = Jet::kOrder + 1; k-- > 0;)
    sum = sum * s + Vector(jet[0].c[k], jet[1].c[k], jet[2].c[k]);
  return sum;
}

}  // namespace

TEST_CASE("cubic samples against the true splines") {
  const std::vector<TableSpline> splines = table_splines();
  REQUIRE(splines.size() == 6);
  for (std::size_t number = 0; number < splines.size(); ++number) {
    const TableSpline& spline = splines[number];
    std::vector<Vector> values;
    double largest = 0;
    for (const double v : spline.values) values.emplace_back(v, -2 * v, 0);
    for (const auto& [t, v] : spline.between) largest = std::max(largest, std::abs(v));
    for (const double v : spline.values) largest = std::max(largest, std::abs(v));
    const SampledSpin omega(samples_of(spline.times, values), Interpolation::kCubic);
    REQUIRE(!spline.between.empty());
    for (const auto& [t, v] : spline.between) {
      // t - t_i is rounded where t_i is not near t, by u |t - t_i| at most, which is u of x; the
      // value is a sum of four terms, each of two roundings of x, 1 - x and one or two products:
      // some 8 u of their sum of magnitudes. That is at most |v0| + |v1| + 3/8 (|start| + |end|),
      // and where the spline swings, the bends are some four times what they add: 8 u * 4 * 2.
      CAPTURE(number, t, v);
      CHECK(std::abs(omega.value(t).x() - v) <= 32 * kEpsilon * largest);
      CHECK(omega.value(t).y() == -2 * omega.value(t).x());
      CHECK(omega.value(t).z() == 0);
    }
  }
}

TEST_CASE("cubic samples of a cubic polynomial are that polynomial, with its derivatives") {
  // Four conditions at each end are met by the polynomial itself, and the spline is unique.
  std::mt19937_64 random(7);
  const Vector c[] = {{1, -2, 0.5}, {0.25, 3, -1}, {-1, 0.125, 2}, {0.5, -0.75, 0.25}};
  const auto value = [&](double t) -> Vector { return c[0] + t * (c[1] + t * (c[2] + t * c[3])); };
  for (std::size_t trial = 0; trial < 20; ++trial) {
    const std::vector<double> times = random_times(random, 4 + trial, 1);
    std::vector<Vector> values;
    double size = 0;
    for (const double t : times) {
      values.push_back(value(t));
      size = std::max({size, 4 * norm(c[3]) * std::abs(t * t * t), 4 * norm(values.back()), 16.0});
    }
    const SampledSpin omega(samples_of(times, values), Interpolation::kCubic);
    const double lebesgue = lebesgue_constant(times);
    std::uniform_real_distribution<double> within(times.front(), times.back());
    for (int i = 0; i < 50; ++i) {
      const double t = within(random);
      CAPTURE(trial, t);
      // Values rounded by at most e change the spline by at most lebesgue(t) e; e is some 4 u of
      // the size of the terms, and evaluating here and there costs as much again.
      const double tolerance = (4 + 4 * lebesgue) * kEpsilon / 2 * size;
      CHECK(norm(omega.value(t) - value(t)) <= tolerance);
      // The jet is that polynomial about t: it tells the values a little further on.
      const VectorJet jet = omega.jet(t);
      for (std::size_t k = 4; k <= Jet::kOrder; ++k) CHECK(jet[0].c[k] == 0);
      const auto next = std::upper_bound(times.begin(), times.end() - 1, t);
      const double s = (*next - t) / 2;
      CHECK(norm(sum_of(jet, s) - value(t + s)) <= 2 * tolerance);
      CHECK(norm(sum_of(jet, 0) - omega.value(t)) == 0);
    }
  }
}

TEST_CASE("linear samples are straight between and exact at the samples") {
  const std::vector<double> times = {0, 1, 1.5, 4, 4 + 1e-9};
  const std::vector<Vector> values = {{0, 1, 2}, {4, -1, 0}, {4, 4, 4}, {-1, 0.5, 9}, {0, 0, 0}};
  for (const Interpolation way : {Interpolation::kLinear, Interpolation::kCubic}) {
    const SampledSpin omega(samples_of(times, values), way);
    for (std::size_t i = 0; i < times.size(); ++i) CHECK(omega.value(times[i]) == values[i]);
  }
  const SampledSpin omega(samples_of(times, values), Interpolation::kLinear);
  CHECK(omega.value(0.5) == Vector(2, 0, 1));
  CHECK(omega.value(1.25) == Vector(4, 1.5, 2));
  const VectorJet jet = omega.jet(1.25);
  CHECK(jet[0].c[1] == 0);
  CHECK(jet[1].c[1] == 10);
  CHECK(jet[2].c[1] == 8);
  CHECK(jet[1].c[2] == 0);
}

TEST_CASE("the order of the calls does not change a value") {
  std::mt19937_64 random(11);
  const std::vector<double> times = random_times(random, 200, 2);
  std::vector<Vector> values;
  std::uniform_real_distribution<double> component(-1, 1);
  for (std::size_t i = 0; i < times.size(); ++i)
    values.emplace_back(component(random), component(random), component(random));
  const SampledSpin one(samples_of(times, values), Interpolation::kCubic);
  const SampledSpin other(samples_of(times, values), Interpolation::kCubic);
  std::uniform_real_distribution<double> within(times.front(), times.back());
  for (int i = 0; i < 2000; ++i) {
    const double t = within(random);
    const Vector before = one.value(t);
    other.value(times.front());
    CHECK(other.value(t) == before);
    // On and back by a little, as integrators go.
    CHECK(one.value(std::nextafter(t, 0.0)).allFinite());
    CHECK(one.value(t) == before);
  }
}

TEST_CASE("outside the samples omega is an error, unless it holds") {
  const Samples samples = samples_of({1, 2, 4}, {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}});
  for (const Interpolation way : {Interpolation::kLinear, Interpolation::kCubic}) {
    const SampledSpin omega(samples, way);
    for (const double t : {std::nextafter(1.0, 0.0), std::nextafter(4.0, 5.0), -1e300, kNaN}) {
      refused([&] { omega.value(t); }, {"t = " + text(t), "1.0 .. 4.0", "extrapolate = true"});
      refused([&] { omega.jet(t); }, {"1.0 .. 4.0"});
    }
    const SampledSpin held(samples, way, true);
    CHECK(held.value(-1e300) == Vector(1, 0, 0));
    CHECK(held.value(5) == Vector(3, 0, 0));
    CHECK(held.jet(5)[0].c[0] == 3);
    CHECK(held.jet(5)[0].c[1] == 0);
    refused([&] { held.value(kNaN); }, {"t = nan"});
  }
}

TEST_CASE("samples break at their times, where a derivative jumps") {
  const Samples samples = samples_of({1, 2, 4}, {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}});
  using Times = std::vector<double>;
  for (const Interpolation way : {Interpolation::kLinear, Interpolation::kCubic}) {
    const SampledSpin omega(samples, way);
    CHECK(omega.breaks(1, 4) == Times{2});
    CHECK(omega.breaks(0, 5) == Times{1, 2, 4});
    CHECK(omega.breaks(2, 4) == Times{});
    CHECK(omega.breaks(1.5, 1.75) == Times{});
    CHECK(omega.breaks(4, 1) == Times{});
    CHECK_THROWS_AS(omega.jet(2), NotDifferentiable);
    CHECK_NOTHROW(omega.jet(1));
    CHECK_NOTHROW(omega.jet(4));
    CHECK_THROWS_AS(SampledSpin(samples, way, true).jet(1), NotDifferentiable);
    CHECK_THROWS_AS(SampledSpin(samples, way, true).jet(4), NotDifferentiable);
  }
  CHECK_FALSE(SampledSpin(samples, Interpolation::kLinear).dear());
}

TEST_CASE("samples at the ends of the doubles") {
  const double tiny = 5e-324, huge = 0x1p1023;
  for (const Interpolation way : {Interpolation::kLinear, Interpolation::kCubic}) {
    const SampledSpin near(samples_of({0, tiny, 1}, {{1, 0, 0}, {1, 0, 0}, {1, 0, 0}}), way);
    for (const double t : {0.0, tiny, 0.5, 1.0}) CHECK(near.value(t) == Vector(1, 0, 0));
    const SampledSpin far(samples_of({-0x1p1022, 0x1p1022}, {{huge, 0, 0}, {-huge, 0, 0}}), way);
    CHECK(far.value(0) == Vector(0, 0, 0));
    CHECK(far.value(-0x1p1022) == Vector(huge, 0, 0));
    CHECK(far.value(0x1p1021).x() == -huge / 2);
  }
  refused(
      [&] {
        SampledSpin(samples_of({-huge, huge}, {{1, 0, 0}, {1, 0, 0}}), {});
      },
      {"further apart"});
  // The bend of the long interval that the jump in the short one asks for.
  refused(
      [&] {
        SampledSpin(samples_of({0, tiny, 1, 2}, {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 0, 0}}),
                    Interpolation::kCubic);
      },
      {"overflows", "interpolation = \"linear\""});
}

TEST_CASE("samples say what they are") {
  Samples samples = samples_of({0, 1}, {{1, 0, 0}, {1, 0, 0}});
  CHECK(SampledSpin(samples, Interpolation::kCubic).description() == "samples (2 rows, cubic)");
  samples.name = "gyro.csv";
  CHECK(SampledSpin(samples, Interpolation::kLinear).description() ==
        "samples of gyro.csv (2 rows, linear)");
}
