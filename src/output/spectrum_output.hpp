// A spectrum, and the frequencies of a motion, as text, picture and file.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dynamics/floquet.hpp"
#include "dynamics/frequencies.hpp"
#include "dynamics/spectrum.hpp"
#include "output/columns.hpp"
#include "output/picture.hpp"

namespace rotor {

/// What a signal is called and measured in: "euler_vector_x", "rad" ("" where it has no unit).
struct Signal {
  std::string name;
  std::string unit;
};

/// The signal of that one column; throws std::invalid_argument where there are more.
Signal signal_of(const StateColumns& columns);

/// A column of a run at evenly spaced times. Throws std::invalid_argument, with the time, where it
/// is not finite, and Interrupted where the observer says so.
std::vector<double> samples(const Run& run, const StateColumns& column,
                            std::span<const double> times, const Observer& observer = {});

struct SignalSpectrum {
  Signal signal;
  SpectrumOptions options;
  std::size_t samples;
  Spectrum spectrum;
  /// "rad^2/(cycle/t)".
  std::string unit() const;
  /// A quarter more than the frequency up to which all but a ten-thousandth of the power is; no
  /// more than there is.
  double reach() const;
};

/// "hann", ... and "mean", ..., in the order of Window and Detrend.
std::vector<std::string> window_names();
std::vector<std::string> detrend_names();

/// The density from frequency `from` to `to` over logarithmic y; what is below 1e-20 of the highest
/// is a gap. Throws std::invalid_argument where there is nothing between them.
Picture picture(const SignalSpectrum& spectrum, double from, double to, PlotOptions look = {});

/// Writes FILE with the columns frequency and density, and FILE.json as write_provenance does (with
/// its answer). Throws std::system_error if a file cannot be written.
bool write_csv(const SignalSpectrum& spectrum, const std::filesystem::path& file,
               const std::string& scene);

/// The lines of a signal, with what they are of the drive and the Floquet frequency.
struct NamedFrequencies {
  Signal signal;
  std::size_t asked;
  Frequencies found;
  std::optional<FloquetFrequencies> basis;
  std::vector<std::optional<Combination>> names;  // one a line

  /// Why there are fewer than asked for; "" where there are not.
  std::string note() const;
};

/// Names them, where a basis is known: within four times the error of each.
NamedFrequencies named(const Signal& signal, std::size_t asked, Frequencies found,
                       const std::optional<FloquetFrequencies>& basis);

/// A table of 80 columns for people, of at most `digits` significant digits.
std::string table(const NamedFrequencies& frequencies, int digits);

}  // namespace rotor
