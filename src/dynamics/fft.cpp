#include "dynamics/fft.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <unsupported/Eigen/FFT>

namespace rotor {
namespace {

using Complex = std::complex<double>;

std::size_t largest_prime_factor(std::size_t n) {
  std::size_t largest = 1;
  for (std::size_t p = 2; p * p <= n; ++p) {
    for (; n % p == 0; n /= p) largest = p;
  }
  return n > 1 ? n : largest;
}

// Bluestein: 2 j k = j^2 + k^2 - (j - k)^2 makes it a convolution with exp(i pi j^2 / n), which a
// power of two that holds it without wrapping does.
std::vector<Complex> by_convolution(Eigen::FFT<double>& fft, std::span<const Complex> x) {
  const std::size_t n = x.size();
  std::size_t size = 1;
  while (size < 2 * n) size *= 2;
  std::vector<Complex> chirp(n);
  for (std::uint64_t j = 0; j < n; ++j) {
    // j^2 modulo 2 n: exact, where the square itself would lose the digits of the phase.
    const auto rest = static_cast<double>(j * j % (2 * n));
    chirp[j] = std::polar(1.0, std::numbers::pi * rest / static_cast<double>(n));
  }
  std::vector<Complex> a(size);
  std::vector<Complex> b(size);
  for (std::size_t j = 0; j < n; ++j) {
    a[j] = x[j] * std::conj(chirp[j]);
    b[j] = chirp[j];
    if (j > 0) b[size - j] = chirp[j];
  }
  std::vector<Complex> a_hat;
  std::vector<Complex> b_hat;
  fft.fwd(a_hat, a);
  fft.fwd(b_hat, b);
  for (std::size_t k = 0; k < size; ++k) a_hat[k] *= b_hat[k];
  fft.inv(a, a_hat);
  std::vector<Complex> result(n);
  for (std::size_t k = 0; k < n; ++k) result[k] = a[k] * std::conj(chirp[k]);
  return result;
}

}  // namespace

std::vector<Complex> fourier_transform(std::span<const Complex> x) {
  // A butterfly of p costs p^2: below this size less than three transforms of twice the length.
  constexpr std::size_t kLargestButterfly = 64;
  Eigen::FFT<double> fft;
  if (largest_prime_factor(x.size()) > kLargestButterfly) return by_convolution(fft, x);
  const std::vector<Complex> copy(x.begin(), x.end());
  std::vector<Complex> result;
  fft.fwd(result, copy);
  return result;
}

}  // namespace rotor
