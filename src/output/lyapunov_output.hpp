// Finite-time Lyapunov exponents as a CSV file and as a picture.
#pragma once

#include <filesystem>
#include <string>

#include "dynamics/lyapunov.hpp"
#include "output/canvas.hpp"

namespace rotor {

/// Columns t, largest, middle, least, a row a time. Throws std::system_error if the file cannot be
/// written.
void write_csv(const LyapunovSpectrum& spectrum, const std::filesystem::path& file);

/// |exponent| of the three over |t - t0|, on logarithmic axes; what is 0 to rounding is left out.
/// Throws std::invalid_argument where all are.
std::string plot(const LyapunovSpectrum& spectrum, double t0, PlotOptions options = {});

}  // namespace rotor
