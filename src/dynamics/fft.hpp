// The discrete Fourier transform of any length.
#pragma once

#include <complex>
#include <span>
#include <vector>

namespace rotor {

/// X_k = sum over i of x_i exp(-2 pi i k i / n), k = 0 .. n - 1, nothing padded; the cost is that
/// of n log n for every n, primes too.
std::vector<std::complex<double>> fourier_transform(std::span<const std::complex<double>> x);

}  // namespace rotor
