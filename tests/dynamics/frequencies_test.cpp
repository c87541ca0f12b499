#include "dynamics/frequencies.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

#include "catch.hpp"
#include "integrate/loop.hpp"
#include "motion/run.hpp"
#include "motion/times.hpp"
#include "spin/models.hpp"

namespace {

using namespace rotor;
using Catch::Matchers::Contains;

constexpr double kTwoPi = 2 * std::numbers::pi;
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

struct Sine {
  double frequency;
  double amplitude;
  double phase;
};

std::vector<double> sum_of(const std::vector<Sine>& sines, double mean, double every,
                           std::size_t n) {
  std::vector<double> y(n);
  for (std::size_t i = 0; i < n; ++i) {
    long double sum = mean;
    for (const Sine& sine : sines) {
      sum += sine.amplitude *
             std::cos(2 * std::numbers::pi_v<long double> * sine.frequency *
                          static_cast<long double>(every) * static_cast<long double>(i) +
                      sine.phase);
    }
    y[i] = static_cast<double>(sum);
  }
  return y;
}

// `count` sines by amplitude, 0.01 to 1; frequencies at least six cycles over the record apart.
std::vector<Sine> random_sines(std::mt19937& random, std::size_t count, double every,
                               std::size_t n) {
  const double bin = 1 / (static_cast<double>(n) * every);
  std::uniform_real_distribution<double> frequency(6 * bin, 0.5 / every - 6 * bin);
  std::uniform_real_distribution<double> digits(-2, 0);
  std::uniform_real_distribution<double> phase(-std::numbers::pi, std::numbers::pi);
  std::vector<Sine> sines;
  while (sines.size() < count) {
    const double f = frequency(random);
    if (std::any_of(sines.begin(), sines.end(),
                    [&](const Sine& sine) { return std::abs(sine.frequency - f) < 6 * bin; }))
      continue;
    sines.push_back({f, std::pow(10, digits(random)), phase(random)});
  }
  std::sort(sines.begin(), sines.end(),
            [](const Sine& a, const Sine& b) { return a.amplitude > b.amplitude; });
  return sines;
}

std::vector<double> euler_x(double period, double t1, std::size_t n) {
  const auto omega =
      std::make_shared<TurningSpin>(Vector(1, 0, 0), Vector(0, 0, 1), kTwoPi / period);
  const Run run = evolve({AngularVelocity(omega), 0, t1}, Rotation(Vector(1, 1, 1), 1));
  std::vector<double> y;
  for (const double t : times_in(0, t1, n)) y.push_back(run(t).euler_vector().x());
  return y;
}

}  // namespace

TEST_CASE("one to six sines are found to rounding, and the errors say so") {
  for (unsigned seed = 1; seed <= 30; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const std::size_t count = 1 + seed % 6;
    const double every = 0.37;
    const std::size_t n = 1500;
    const auto sines = random_sines(random, count, every, n);
    const Frequencies found = frequencies(sum_of(sines, 0.7, every, n), every, count);
    REQUIRE(found.lines.size() == count);
    // Rounding of the samples and of the waves subtracted, some ten ulp of at most six waves of
    // amplitude 1 or less: 1e-14 in a and b, less than that beside A over the record in f, and pi
    // times that in the phase, which is at the record's end. Beside it the rounding of f itself,
    // two ulp, and what that is in the phase.
    const double length = static_cast<double>(n) * every;
    for (std::size_t i = 0; i < count; ++i) {
      const Line& line = found.lines[i];
      const double of_f = 2 * kEpsilon * line.frequency;
      CHECK(std::abs(line.frequency - sines[i].frequency) <=
            1e-14 / length / sines[i].amplitude + of_f);
      CHECK(std::abs(line.amplitude - sines[i].amplitude) <= 1e-14);
      CHECK(std::abs(std::remainder(line.phase - sines[i].phase, kTwoPi)) <=
            4e-14 / sines[i].amplitude + std::numbers::pi * length * of_f);
      CHECK(std::abs(line.frequency - sines[i].frequency) <= line.error);
      CHECK(std::abs(line.amplitude - sines[i].amplitude) <= line.amplitude_error);
      CHECK(std::abs(std::remainder(line.phase - sines[i].phase, kTwoPi)) <= line.phase_error);
      CHECK(line.error <= 1e-12 / length / sines[i].amplitude + 2 * of_f);
    }
    CHECK(std::abs(found.mean - 0.7) <= 1e-14);
  }
}

TEST_CASE("in noise the errors hold, and are not idle") {
  int inside = 0;
  int all = 0;
  double tightest = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    std::mt19937 random(seed);
    const auto sines = random_sines(random, 3, 1, 1000);
    std::vector<double> y = sum_of(sines, 0, 1, 1000);
    std::normal_distribution<double> noise(0, 0.003);
    for (double& value : y) value += noise(random);
    const Frequencies found = frequencies(y, 1, 3);
    REQUIRE(found.lines.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
      const double miss = std::abs(found.lines[i].frequency - sines[i].frequency);
      inside += miss <= found.lines[i].error ? 1 : 0;
      tightest = std::max(tightest, miss / found.lines[i].error);
      ++all;
    }
  }
  INFO("inside " << inside << " of " << all << ", nearest to the bound " << tightest);
  // The greatest of some four independent neighbours is 1.45 times the rms of their moments, and
  // the error, one of two components, has half of that variance: two sigma, 95 in a hundred. Of 180
  // that is 171 +- 2.9, hardly below 156.
  CHECK(inside >= 156);
  CHECK(tightest > 0.5);
}

TEST_CASE("[P15] has the frequencies of theory 4.4") {
  for (const double period : {40.0, std::numbers::pi}) {
    const double alpha = kTwoPi / period;
    const double slow = (std::sqrt(1 + alpha * alpha) - alpha) / (2 * kTwoPi);
    const double fast = (std::sqrt(1 + alpha * alpha) + alpha) / (2 * kTwoPi);
    const std::size_t n = 8193;
    const Frequencies found = frequencies(euler_x(period, 4200, n), 4200.0 / (n - 1), 6);
    REQUIRE(found.lines.size() == 6);
    for (const double exact : {slow, fast}) {
      const auto nearest = std::min_element(
          found.lines.begin(), found.lines.end(), [&](const Line& a, const Line& b) {
            return std::abs(a.frequency - exact) < std::abs(b.frequency - exact);
          });
      INFO("exact " << exact << ", found " << nearest->frequency << ", error " << nearest->error);
      CHECK(std::abs(nearest->frequency - exact) <= 1e-8);
      CHECK(std::abs(nearest->frequency - exact) <= nearest->error);
      // At T = pi what is left has 18 f_F - drive, 4.4 cycles over the record from f_F.
      CHECK(nearest->error <= 2e-8);
      // Of E_x the two are the strongest, at T = pi with 2 f_F between them.
      CHECK(nearest - found.lines.begin() < 3);
    }
  }
}

TEST_CASE("no more lines are found than stand out of the noise") {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, 0.1);
  std::vector<double> y = sum_of({{0.1, 1, 0}, {0.23, 0.5, 1}}, 0, 1, 2000);
  for (double& value : y) value += noise(random);
  CHECK(frequencies(y, 1, 10).lines.size() == 2);
  CHECK(frequencies(y, 1, 1).lines.size() == 1);
  // The transform of the noise is 2 0.1 sqrt(sum w^2) = 0.2 sqrt(35/18/2000) in each bin (rms), and
  // the threshold sqrt(log(1e4 1000)) = 4.01 of it: 0.0250. The median of 1000 bins, of which every
  // two are one, is good to 3.6 % (one sigma).
  CHECK(frequencies(y, 1, 10).least_amplitude == Approx(0.025).epsilon(0.18));
  CHECK(frequencies(std::vector<double>(100, 3.0), 1, 5).lines.empty());
  CHECK(frequencies(std::vector<double>(100, 3.0), 1, 5).mean == Approx(3).epsilon(1e-15));
  CHECK(frequencies(std::vector<double>(100, 0.0), 1, 5).lines.empty());
  for (const double f : {0.013, 0.0796, 0.25, 0.4}) {
    INFO("f = " << f);
    CHECK(frequencies(sum_of({{f, 1, 0}}, 0, 1, 4096), 1, 5).lines.size() == 1);
  }
}

TEST_CASE("a frequency that changes on the way has an error that shows it") {
  std::vector<double> y(2000);
  for (std::size_t i = 0; i < y.size(); ++i) {
    const auto t = static_cast<double>(i);
    y[i] = std::cos(kTwoPi * (0.1 * t + 1e-6 * t * t));  // 0.1 to 0.104
  }
  const Frequencies found = frequencies(y, 1, 1);
  REQUIRE(found.lines.size() == 1);
  CHECK(found.lines[0].frequency + found.lines[0].error > 0.1);
  CHECK(found.lines[0].error > 1e-5);  // of a steady one it is 1e-16
}

TEST_CASE("frequencies refuse what they cannot be of") {
  const std::vector<double> y(100, 1.0);
  CHECK_THROWS_WITH(frequencies(y, 1, 0), Contains("n must be from 1 to 100, got 0"));
  CHECK_THROWS_WITH(frequencies(y, 1, 101), Contains("got 101"));
  CHECK_THROWS_WITH(frequencies(std::vector<double>(31, 1.0), 1, 1), Contains("got 31"));
  CHECK_THROWS_WITH(frequencies(y, 0, 1), Contains("every must be positive"));
  std::vector<double> broken = y;
  broken[40] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(frequencies(broken, 1, 1), Contains("got nan as number 41 of 100"));
  FrequencyOptions options;
  options.observer = [](double) { return false; };
  CHECK_THROWS_AS(frequencies(y, 1, 1, options), Interrupted);
}
