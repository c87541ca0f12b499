#include "dynamics/spectrum.hpp"

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

#include "catch.hpp"
#include "dynamics/fft.hpp"

namespace {

using namespace rotor;
using Catch::Matchers::Contains;

constexpr double kTwoPi = 2 * std::numbers::pi;
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

std::vector<double> noise(unsigned seed, std::size_t n) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<double> y(n);
  for (double& value : y) value = number(random);
  return y;
}

std::vector<double> wave(double amplitude, double frequency, double every, std::size_t n) {
  std::vector<double> y(n);
  for (std::size_t i = 0; i < n; ++i)
    y[i] = amplitude * std::cos(kTwoPi * frequency * every * static_cast<double>(i) + 0.3);
  return y;
}

double integral(const Spectrum& spectrum) {
  double sum = 0;
  for (const double density : spectrum.density) sum += density;
  return sum * spectrum.frequency[1];
}

}  // namespace

TEST_CASE("the Fourier transform is its definition at every length") {
  for (const std::size_t n : {4U, 5U, 64U, 67U, 73U, 97U, 120U, 201U, 206U, 211U, 509U}) {
    INFO("n = " << n);
    const std::vector<double> real = noise(1, n);
    const std::vector<double> imaginary = noise(2, n);
    std::vector<std::complex<double>> x(n);
    for (std::size_t i = 0; i < n; ++i) x[i] = {real[i], imaginary[i]};
    const auto transform = fourier_transform(x);
    REQUIRE(transform.size() == n);
    for (std::size_t k = 0; k < n; ++k) {
      std::complex<long double> sum = 0;
      for (std::size_t i = 0; i < n; ++i) {
        sum +=
            std::complex<long double>(x[i]) *
            std::polar(1.0L, -2 * std::numbers::pi_v<long double> *
                                 static_cast<long double>(i * k % n) / static_cast<long double>(n));
      }
      // Each of some 3 log2(4 n) levels rounds |X| <= sqrt(2 n) |x|, sqrt(2) the largest |x|.
      const double tolerance = 3 * std::log2(4.0 * static_cast<double>(n)) * kEpsilon * 2 *
                               std::sqrt(static_cast<double>(n));
      CHECK(std::abs(transform[k] - std::complex<double>(sum)) <= tolerance);
    }
  }
}

TEST_CASE("without a window the density integrates to the mean square") {
  for (const std::size_t n : {4U, 5U, 100U, 101U, 4201U}) {
    INFO("n = " << n);
    const std::vector<double> y = noise(3, n);
    double square = 0;
    for (const double value : y) square += value * value / static_cast<double>(n);
    const Spectrum spectrum = power_spectral_density(y, 0.25, {Window::kNone, Detrend::kNone});
    CHECK(spectrum.density.size() == n / 2 + 1);
    CHECK(spectrum.frequency.back() ==
          Approx(static_cast<double>(n / 2) / (static_cast<double>(n) * 0.25)));
    // As many roundings as the transform has levels, and the sums.
    CHECK(integral(spectrum) == Approx(square).epsilon(1e-13));
  }
}

TEST_CASE("a sine that fits the record is a line of half its squared amplitude in any window") {
  // Its transform is that of the window, which the sums of squares of both sides normalise alike:
  // the integral is sum (w y)^2 / sum w^2, A^2/2 where 2 f is beyond the window's few lines.
  const std::vector<double> y = wave(3, 0.5, 0.1, 1000);
  for (const Window window :
       {Window::kHann, Window::kNone, Window::kBlackmanHarris, Window::kFlatTop}) {
    const Spectrum spectrum = power_spectral_density(y, 0.1, {window});
    CHECK(integral(spectrum) == Approx(4.5).epsilon(1e-12));
    // A twentieth of a bin: without a window the neighbours are rounding, and its logarithm counts.
    CHECK(std::abs(spectrum.peaks(1).front().frequency - 0.5) <= 0.05 * spectrum.frequency[1]);
  }
}

TEST_CASE("a peak between the bins is found by the lobe of its window") {
  // The logarithm of the lobe is no parabola. With the lobe of a window sum a_k cos(2 pi k x), a
  // sum of sinc(x) and sinc(x +- k), the parabola misses by 0.0160, 0.0032 and 0.1409 of a bin at
  // worst.
  const double bin = 1 / (1000 * 0.1);
  for (const auto& [window, tolerance] : {std::pair{Window::kHann, 0.0161},
                                          {Window::kBlackmanHarris, 0.0033},
                                          {Window::kFlatTop, 0.141}}) {
    for (double part = 0; part < 1; part += 0.1) {
      const double f = (100 + part) * bin;
      const Spectrum spectrum = power_spectral_density(wave(1, f, 0.1, 1000), 0.1, {window});
      INFO("part of a bin " << part);
      CHECK(std::abs(spectrum.peaks(1).front().frequency - f) <= tolerance * bin);
    }
  }
}

TEST_CASE("peaks come highest first, and no more than there are") {
  std::vector<double> y = wave(1, 1, 0.1, 1000);
  const std::vector<double> other = wave(2, 3, 0.1, 1000);
  for (std::size_t i = 0; i < y.size(); ++i) y[i] += other[i];
  const auto peaks = power_spectral_density(y, 0.1).peaks(2);
  REQUIRE(peaks.size() == 2);
  CHECK(peaks[0].frequency == Approx(3).epsilon(1e-9));
  CHECK(peaks[1].frequency == Approx(1).epsilon(1e-9));
  CHECK(peaks[0].density == Approx(4 * peaks[1].density).epsilon(1e-6));
  CHECK(power_spectral_density(std::vector<double>{1, 1, 1, 1}, 1).peaks(5).empty());
}

TEST_CASE("a constant and a straight line have a density of zero when they are subtracted") {
  std::vector<double> constant(1001, 0.1);
  std::vector<double> line(1001);
  for (std::size_t i = 0; i < line.size(); ++i) line[i] = 0.1 * static_cast<double>(i) - 7;
  const auto is_zero = [](const Spectrum& spectrum) {
    return spectrum.density == std::vector<double>(spectrum.density.size(), 0.0);
  };
  CHECK(is_zero(power_spectral_density(constant, 1)));
  CHECK(is_zero(power_spectral_density(constant, 1, {Window::kHann, Detrend::kLinear})));
  CHECK(is_zero(power_spectral_density(line, 1, {Window::kHann, Detrend::kLinear})));
  CHECK_FALSE(is_zero(power_spectral_density(line, 1)));
  CHECK_FALSE(is_zero(power_spectral_density(constant, 1, {Window::kHann, Detrend::kNone})));
}

TEST_CASE("a spectrum needs samples that it can be of") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(power_spectral_density(std::vector<double>{1, 2, 3}, 1),
                    Contains("at least 4 samples, got 3"));
  CHECK_THROWS_WITH(power_spectral_density(std::vector<double>{1, 2, nan, 4}, 1),
                    Contains("got nan as number 3 of 4"));
  CHECK_THROWS_AS(power_spectral_density(std::vector<double>{1, 2, HUGE_VAL, 4}, 1),
                  std::invalid_argument);
  const std::vector<double> y = {1, 2, 3, 4};
  CHECK_THROWS_WITH(power_spectral_density(y, 0),
                    Contains("every must be positive") && Contains("0.0"));
  CHECK_THROWS_AS(power_spectral_density(y, -1), std::invalid_argument);
  CHECK_THROWS_AS(power_spectral_density(y, nan), std::invalid_argument);
  CHECK_THROWS_AS(power_spectral_density(y, HUGE_VAL), std::invalid_argument);
}
