#include "dynamics/spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include "dynamics/fft.hpp"
#include "rotation/text.hpp"

namespace rotor {
namespace {

void require_samples(std::span<const double> y, double every) {
  if (y.size() < 4) {
    throw std::invalid_argument("spectrum: expected at least 4 samples, got " +
                                std::to_string(y.size()));
  }
  if (!(every > 0 && std::isfinite(every))) {
    throw std::invalid_argument("spectrum: every must be positive and finite, got " + text(every));
  }
  for (std::size_t i = 0; i < y.size(); ++i) {
    if (!std::isfinite(y[i])) {
      throw std::invalid_argument("spectrum: expected finite samples, got " + text(y[i]) +
                                  " as number " + std::to_string(i + 1) + " of " +
                                  std::to_string(y.size()));
    }
  }
}

// y without its mean, or without the straight line of least squares. What is left of a mean or a
// line that y is, which is rounding, is zero.
std::vector<double> detrended(std::span<const double> y, Detrend detrend) {
  std::vector<double> rest(y.begin(), y.end());
  if (detrend == Detrend::kNone) return rest;
  const auto n = static_cast<long double>(y.size());
  long double mean = 0;
  long double moment = 0;
  double largest = 0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    mean += y[i] / n;
    // (i - (n - 1)/2) y_i over the sum of (i - (n - 1)/2)^2, which is n (n^2 - 1)/12
    moment += (static_cast<long double>(i) - (n - 1) / 2) * y[i] * (12 / (n * (n * n - 1)));
    largest = std::max(largest, std::abs(y[i]));
  }
  const long double slope = detrend == Detrend::kLinear ? moment : 0;
  double left = 0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    const long double trend = mean + slope * (static_cast<long double>(i) - (n - 1) / 2);
    rest[i] = static_cast<double>(y[i] - trend);
    left = std::max(left, std::abs(rest[i]));
  }
  if (left <= 2 * std::numeric_limits<double>::epsilon() * largest)
    std::fill(rest.begin(), rest.end(), 0.0);
  return rest;
}

// The coefficients of 1, -cos x, cos 2x, -cos 3x, ...: Harris 1978 (Proceedings of the IEEE 66),
// the flat top as SciPy and MATLAB have it.
std::vector<double> cosines(Window window) {
  switch (window) {
    case Window::kHann:
      return {0.5, 0.5};
    case Window::kNone:
      return {1};
    case Window::kBlackmanHarris:
      return {0.35875, 0.48829, 0.14128, 0.01168};
    case Window::kFlatTop:
      return {0.21557895, 0.41663158, 0.277263158, 0.083578947, 0.006947368};
  }
  return {1};
}

}  // namespace

std::vector<double> window_values(Window window, std::size_t n) {
  const std::vector<double> coefficients = cosines(window);
  std::vector<double> w(n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    const double x = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    for (std::size_t k = 0; k < coefficients.size(); ++k)
      w[i] += (k % 2 == 0 ? 1 : -1) * coefficients[k] * std::cos(static_cast<double>(k) * x);
  }
  return w;
}

Spectrum power_spectral_density(std::span<const double> y, double every,
                                const SpectrumOptions& options) {
  require_samples(y, every);
  const std::size_t n = y.size();
  const std::vector<double> rest = detrended(y, options.detrend);
  const std::vector<double> w = window_values(options.window, n);
  std::vector<std::complex<double>> weighted(n);
  double squares = 0;
  for (std::size_t i = 0; i < n; ++i) {
    weighted[i] = w[i] * rest[i];
    squares += w[i] * w[i];
  }
  const auto transform = fourier_transform(weighted);
  Spectrum spectrum;
  spectrum.every = every;
  for (std::size_t k = 0; 2 * k <= n; ++k) {
    const bool alone = k == 0 || 2 * k == n;  // the others stand for -f as well
    spectrum.frequency.push_back(static_cast<double>(k) / (static_cast<double>(n) * every));
    spectrum.density.push_back((alone ? 1 : 2) * every * std::norm(transform[k]) / squares);
  }
  return spectrum;
}

std::size_t samples_for(const Run& run) {
  return std::clamp<std::size_t>(16 * run.propagator().flow->mesh().size(), 4096, 131072);
}

std::vector<SpectrumPeak> Spectrum::peaks(std::size_t most) const {
  std::vector<SpectrumPeak> found;
  for (std::size_t k = 1; k + 1 < density.size(); ++k) {
    if (!(density[k] > density[k - 1] && density[k] >= density[k + 1])) continue;
    SpectrumPeak peak = {frequency[k], density[k]};
    if (density[k - 1] > 0 && density[k + 1] > 0) {
      const double below = std::log(density[k - 1] / density[k]);
      const double above = std::log(density[k + 1] / density[k]);
      const double shift = (above - below) / (-2 * (above + below));  // in bins, at most 1/2
      peak.frequency += shift * (frequency[1] - frequency[0]);
      peak.density *= std::exp((above - below) * shift / 4);
    }
    found.push_back(peak);
  }
  std::stable_sort(found.begin(), found.end(), [](const SpectrumPeak& a, const SpectrumPeak& b) {
    return a.density > b.density;
  });
  if (found.size() > most) found.resize(most);
  return found;
}

}  // namespace rotor
