// How the power of a signal is spread over frequencies.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "motion/run.hpp"

namespace rotor {

/// What the samples are weighted with: the sums of cosines over one period of the record.
enum class Window {
  kHann,            // side lobes fall by 18 dB an octave
  kNone,            // resolves best, leaks most
  kBlackmanHarris,  // four terms: side lobes below -92 dB
  kFlatTop          // five terms: a peak's height is true wherever it lies between the bins
};

/// What is subtracted from the samples first.
enum class Detrend { kMean, kNone, kLinear };

struct SpectrumOptions {
  Window window = Window::kHann;
  Detrend detrend = Detrend::kMean;
};

struct SpectrumPeak {
  double frequency;
  double density;
};

/// A one-sided power spectral density: frequencies in cycles per unit of t from 0 to 1/(2 every),
/// the density in [y]^2 per unit of frequency.
struct Spectrum {
  double every = 0;
  std::vector<double> frequency;
  std::vector<double> density;

  /// The local maxima, highest first, `most` of them at most. Frequency and density are those of
  /// the parabola through the logarithms of the maximum and its neighbours.
  std::vector<SpectrumPeak> peaks(std::size_t most) const;
};

/// w_i of n samples, i = 0 .. n - 1: periodic in n.
std::vector<double> window_values(Window window, std::size_t n);

/// S(f_k) = 2 every |sum w_i y_i exp(-2 pi i k i/n)|^2 / sum w_i^2, f_k = k/(n every); not doubled
/// at 0 and at 1/(2 every). Without a window its integral, the sum of S(f_k)/(n every), is the mean
/// square of what is transformed (Parseval). Throws std::invalid_argument for fewer than 4 samples,
/// unless `every` is positive and finite, and for samples that are not finite.
Spectrum power_spectral_density(std::span<const double> y, double every,
                                const SpectrumOptions& options = {});

/// How many evenly spaced samples leave nothing out that the motion does in general: 16 in each
/// stretch of the flow's mesh, in which the body turns by no more than some 6 rad; from 4096 to
/// 131072.
std::size_t samples_for(const Run& run);

}  // namespace rotor
