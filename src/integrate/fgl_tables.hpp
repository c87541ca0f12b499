// Matrices on the nodes of the fast integrator, worked out by the compiler.
#pragma once

#include <array>
#include <cstddef>

#include "integrate/gauss_tables.hpp"
#include "rotation/rotation.hpp"

namespace rotor {

/// P_0(x) ... P_(Count - 1)(x), Legendre's polynomials.
template <std::size_t Count>
constexpr std::array<Extended, Count> legendre(Extended x) {
  std::array<Extended, Count> p{1, x};
  for (std::size_t n = 1; n + 1 < Count; ++n) {
    const auto k = static_cast<Extended>(n);
    p[n + 1] = ((2 * k + 1) * x * p[n] - k * p[n - 1]) / (k + 1);
  }
  return p;
}

/// A node on [-1, 1]: the double nearest to it, and by how much that is more than the node.
struct Node {
  double place;
  double more;
};

/// Nodes at +x_j, then at -x_j.
template <std::size_t N>
constexpr std::array<Node, 2 * N> both_sides(const std::array<Extended, N>& x) {
  std::array<Node, 2 * N> nodes{};
  for (std::size_t j = 0; j < N; ++j) {
    const auto place = static_cast<double>(x[j]);
    const auto more = static_cast<double>(Extended{place} - x[j]);
    nodes[j] = {place, more};
    nodes[N + j] = {-place, -more};
  }
  return nodes;
}

/// The places of the lanes (NodeVectors).
inline constexpr std::array<Node, 16> kFglNodePlaces = both_sides(kGauss16Nodes);

/// Matrices for a polynomial of degree 15 given at the 16 nodes, columns first: column j goes with
/// node x_j and multiplies f(x_j) + f(-x_j) where n is even, f(x_j) - f(-x_j) where it is odd, so
/// that c_n = (2 n + 1)/2 sum_j W_j P_n(x_j) (f(x_j) +- f(-x_j)).
struct FglTables {
  using Square = std::array<std::array<double, 8>, 8>;
  struct Parity {
    Square integral;                          // from 0 to x_r
    std::array<double, 8> integral_to_1;      // from 0 to 1
    std::array<double, 8> integral_to_1_low;  // what rounding has taken from that
    std::array<double, 8> value_at_1;
    Square terms;                                // of the Chebyshev series: T_n, n even or odd
    Square slope;                                // d/dz at x_r
    std::array<std::array<double, 4>, 8> sizes;  // c_n/sqrt(2 n + 1), n = 4, 8, 12, 14 or one more
  };
  std::array<Parity, 2> of;      // of the even n, of the odd n
  std::array<double, 16> nodes;  // by lanes
  // P_16, and at odd n z P_16, which are 0 at all nodes and 1 at z = 1, as Chebyshev series.
  std::array<double, 18> vanishing;
};

namespace detail {

constexpr Extended root(Extended x) {
  Extended r = x;
  for (int i = 0; i < 40; ++i) r = (r + x / r) / 2;
  return r;
}

// The integral of P_n from 0, and its derivative, from the values p of the P at x, zero of those at
// 0.
constexpr Extended integral(std::size_t n, const std::array<Extended, 17>& p,
                            const std::array<Extended, 17>& zero) {
  if (n == 0) return p[1];
  return ((p[n + 1] - p[n - 1]) - (zero[n + 1] - zero[n - 1])) / static_cast<Extended>(2 * n + 1);
}
constexpr Extended slope(std::size_t n, Extended x, const std::array<Extended, 17>& p) {
  return n == 0 ? 0 : static_cast<Extended>(n) * (p[n - 1] - x * p[n]) / (1 - x * x);
}

// P_0 ... P_16, and z P_16, as sums of Chebyshev's polynomials: z T_n = (T_(n+1) + T_(n-1))/2.
constexpr std::array<std::array<Extended, 18>, 18> in_chebyshev() {
  std::array<std::array<Extended, 18>, 18> p{};
  p[0][0] = 1;
  for (std::size_t n = 0; n < 17; ++n) {
    std::array<Extended, 18> z_p{};
    for (std::size_t k = 0; k <= n; ++k) {
      z_p[k + 1] += k == 0 ? p[n][k] : p[n][k] / 2;
      if (k > 0) z_p[k - 1] += p[n][k] / 2;
    }
    const auto size = static_cast<Extended>(n);
    for (std::size_t k = 0; k < 18; ++k) {
      if (n == 16) {
        p[17][k] = z_p[k];
      } else {
        p[n + 1][k] = ((2 * size + 1) * z_p[k] - (n == 0 ? 0 : size * p[n - 1][k])) / (size + 1);
      }
    }
  }
  return p;
}

constexpr FglTables fgl_tables() {
  FglTables tables{};
  const auto chebyshev = in_chebyshev();
  for (std::size_t n = 0; n < 18; ++n) {
    tables.vanishing[n] = static_cast<double>(chebyshev[16 + n % 2][n]);
  }
  std::array<std::array<Extended, 17>, 8> p{};
  for (std::size_t j = 0; j < 8; ++j) {
    p[j] = legendre<17>(kGauss16Nodes[j]);
    tables.nodes[j] = static_cast<double>(kGauss16Nodes[j]);
    tables.nodes[8 + j] = -tables.nodes[j];
  }
  const auto zero = legendre<17>(0);
  const auto one = legendre<17>(1);
  for (std::size_t parity = 0; parity < 2; ++parity) {
    auto& table = tables.of[parity];
    for (std::size_t j = 0; j < 8; ++j) {
      std::array<Extended, 8> integrals{};
      std::array<Extended, 8> slopes{};
      std::array<Extended, 8> terms{};
      Extended to_1 = 0;
      Extended at_1 = 0;
      for (std::size_t n = parity; n < 16; n += 2) {
        const Extended size = static_cast<Extended>(2 * n + 1);
        const Extended c = size / 2 * kGauss16Weights[j] * p[j][n];
        to_1 += c * integral(n, one, zero);
        at_1 += c;
        for (std::size_t k = parity; k <= n; k += 2) terms[k / 2] += c * chebyshev[n][k];
        if (n >= 12 || n / 2 == 2 || n / 2 == 4) {
          table.sizes[j][n < 12 ? n / 4 - 1 : n / 2 - 4] = static_cast<double>(c / root(size));
        }
        for (std::size_t r = 0; r < 8; ++r) {
          integrals[r] += c * integral(n, p[r], zero);
          slopes[r] += c * slope(n, kGauss16Nodes[r], p[r]);
        }
      }
      table.integral_to_1[j] = static_cast<double>(to_1);
      table.integral_to_1_low[j] = static_cast<double>(to_1 - Extended{table.integral_to_1[j]});
      table.value_at_1[j] = static_cast<double>(at_1);
      for (std::size_t r = 0; r < 8; ++r) {
        table.integral[j][r] = static_cast<double>(integrals[r]);
        table.slope[j][r] = static_cast<double>(slopes[r]);
        table.terms[j][r] = static_cast<double>(terms[r]);
      }
    }
  }
  return tables;
}

}  // namespace detail

alignas(32) inline constexpr FglTables kFglTables = detail::fgl_tables();

}  // namespace rotor
