// Finite-time Lyapunov exponents as a CSV file and as a picture.
#pragma once

#include <filesystem>

#include "dynamics/lyapunov.hpp"
#include "output/picture.hpp"

namespace rotor {

/// Writes FILE with the columns t, largest, middle, least, a row a time, and FILE.json as
/// write_provenance does (with its answer). Throws std::system_error if a file cannot be written.
bool write_csv(const LyapunovSpectrum& spectrum, const std::filesystem::path& file,
               const std::string& scene, const std::string& chart, const std::string& method);

/// |exponent| of the three over |t - t0|, on logarithmic axes; what is 0 to rounding is left out.
Picture picture(const LyapunovSpectrum& spectrum, double t0, PlotOptions look = {});

}  // namespace rotor
