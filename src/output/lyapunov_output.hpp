// Finite-time Lyapunov exponents as a CSV file and as a picture.
#pragma once

#include <filesystem>

#include "dynamics/lyapunov.hpp"
#include "output/picture.hpp"

namespace rotor {

/// Columns t, largest, middle, least, a row a time. Throws std::system_error if the file cannot be
/// written.
void write_csv(const LyapunovSpectrum& spectrum, const std::filesystem::path& file);

/// |exponent| of the three over |t - t0|, on logarithmic axes; what is 0 to rounding is left out.
Picture picture(const LyapunovSpectrum& spectrum, double t0, PlotOptions look = {});

}  // namespace rotor
