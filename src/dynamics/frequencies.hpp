// The lines of a quasiperiodic signal, far beyond the resolution of its spectrum.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace rotor {

/// amplitude cos(2 pi frequency s + phase), s from the first sample on.
struct Line {
  double frequency;  // cycles per unit of t, positive
  double amplitude;  // positive
  double phase;      // rad, (-pi, pi]
  double error;      // of the frequency
  double amplitude_error;
  double phase_error;
};

struct FrequencyOptions {
  /// A bound on what the samples are wrong by: a part of the errors.
  double sample_error = 0;
  /// Called with the number of lines found, before the next one is looked for; false ends it with
  /// Interrupted.
  std::function<bool(double)> observer = {};
};

struct Frequencies {
  double mean = 0;          // the constant
  std::vector<Line> lines;  // by amplitude, greatest first
  /// The amplitude that a line would need to be seen beside what is left.
  double least_amplitude = 0;
};

/// The n strongest lines of real samples `every` apart, or as many as stand out of what is left
/// when they are subtracted (the noise, or lines that are closer than 2 cycles over the record to
/// one found, or to 0).
///
/// Each is taken from the highest peak of the remainder's transform under the window Hann^2, as
/// Laskar's NAFF does (Physica D 67, 1993); then all frequencies, amplitudes and phases found, and
/// the mean, are fitted together by least squares under the same window (Gauss-Newton), which is
/// what his orthogonalisation comes to, and takes each conjugate pair as one. More lines are
/// subtracted than are asked for.
///
/// The errors are those of first order that the transform of the remainder within 3 cycles over the
/// record of the line, and `sample_error`, would explain; a line nearer than that, or a frequency
/// that changes on the way, shows in them.
///
/// Throws std::invalid_argument for n = 0 or n > 100, fewer than 32 samples, unless `every` is
/// positive and finite, and for samples that are not finite.
Frequencies frequencies(std::span<const double> y, double every, std::size_t n,
                        const FrequencyOptions& options = {});

}  // namespace rotor
