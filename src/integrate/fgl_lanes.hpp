// Vectors at the 16 nodes of a step, in registers, and their linear algebra.
//
// Every function is inlined into one that says for which machine: attributes of
// targets do not reach into calls.
#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <limits>

#include "integrate/fgl_kernel.hpp"
#include "integrate/fgl_tables.hpp"

#define ROTOR_INLINE [[gnu::always_inline]] inline
#pragma GCC diagnostic ignored "-Wpsabi"  // how they would pass vectors

namespace rotor::fgl {

// Four doubles at once: one register of AVX2, two of SSE2.
using Four [[gnu::vector_size(32)]] = double;
using FourLanes = std::array<Four, 4>;  // the 16 nodes
using TwoLanes = std::array<Four, 2>;   // the 8 nodes of one side
using Vectors = std::array<FourLanes, 3>;

constexpr std::size_t kMostLevels = 6;
// What rounding may do to the last terms of w and its likes of later levels, in units of |w|.
constexpr double kRounding = 4 * std::numeric_limits<double>::epsilon();

ROTOR_INLINE Four broadcast(double x) { return Four{x, x, x, x}; }
ROTOR_INLINE Four load(const double* p) {
  Four x;
  std::memcpy(&x, p, sizeof x);
  return x;
}
ROTOR_INLINE void store(double* p, const Four& x) { std::memcpy(p, &x, sizeof x); }
ROTOR_INLINE double sum(const Four& x) { return (x[0] + x[2]) + (x[1] + x[3]); }
ROTOR_INLINE Four larger(const Four& a, const Four& b) { return a > b ? a : b; }
ROTOR_INLINE double greatest(const FourLanes& x) {
  const Four m = larger(larger(x[0], x[1]), larger(x[2], x[3]));
  const double a = m[0] > m[2] ? m[0] : m[2];
  const double b = m[1] > m[3] ? m[1] : m[3];
  return a > b ? a : b;
}

ROTOR_INLINE Vectors loaded(const NodeVectors& nodes) {
  Vectors w;
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t i = 0; i < 4; ++i) w[c][i] = load(&nodes.v[c][4 * i]);
  }
  return w;
}

// Even and odd parts, twice: f(x) + f(-x), f(x) - f(-x).
template <std::size_t N>
struct PartsOf {
  alignas(32) std::array<std::array<std::array<double, 8>, N>, 2> of;
};
using Parts = PartsOf<3>;
template <std::size_t N>
ROTOR_INLINE PartsOf<N> parts(const std::array<FourLanes, N>& w) {
  PartsOf<N> p;
  for (std::size_t c = 0; c < N; ++c) {
    for (std::size_t i = 0; i < 2; ++i) {
      store(&p.of[0][c][4 * i], w[c][i] + w[c][2 + i]);
      store(&p.of[1][c][4 * i], w[c][i] - w[c][2 + i]);
    }
  }
  return p;
}

// The product of one of the squares with one of the parts.
template <std::size_t N>
ROTOR_INLINE std::array<TwoLanes, N> product(const FglTables::Square& m,
                                             const std::array<std::array<double, 8>, N>& f) {
  std::array<TwoLanes, N> sum{};
  for (std::size_t j = 0; j < 8; ++j) {
    const Four low = load(m[j].data());
    const Four high = load(m[j].data() + 4);
    for (std::size_t c = 0; c < N; ++c) {
      const Four x = broadcast(f[c][j]);
      sum[c][0] += low * x;
      sum[c][1] += high * x;
    }
  }
  return sum;
}

// Values at x_r and at -x_r from those of an odd and an even function at x_r.
ROTOR_INLINE Vectors joined(const std::array<TwoLanes, 3>& odd,
                            const std::array<TwoLanes, 3>& even) {
  Vectors f;
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t i = 0; i < 2; ++i) {
      f[c][i] = even[c][i] + odd[c][i];
      f[c][2 + i] = even[c][i] - odd[c][i];
    }
  }
  return f;
}

// The integral of w from 0 to each node.
ROTOR_INLINE Vectors integral(const Parts& p) {
  return joined(product(kFglTables.of[0].integral, p.of[0]),
                product(kFglTables.of[1].integral, p.of[1]));
}

// Sums over the even and the odd part, joined at z = 1 and at z = -1; there the sum over the part
// `odd` changes its sign.
using Ends = std::array<std::array<double, 2>, 3>;  // [component][end]
ROTOR_INLINE Ends at_ends(const Parts& p, const std::array<const std::array<double, 8>*, 2>& rows,
                          std::size_t odd) {
  Ends ends;
  for (std::size_t c = 0; c < 3; ++c) {
    std::array<double, 2> part{};
    for (std::size_t parity = 0; parity < 2; ++parity) {
      const double* m = rows[parity]->data();
      const double* f = p.of[parity][c].data();
      part[parity] = sum(load(m) * load(f) + load(m + 4) * load(f + 4));
    }
    ends[c] = {part[1 - odd] + part[odd], part[1 - odd] - part[odd]};
  }
  return ends;
}

// The integral of w from 0 to z = 1 and to z = -1. Were the weights rounded, all steps would err in
// one direction.
ROTOR_INLINE Ends integral_to_ends(const Parts& p) {
  const auto& even = kFglTables.of[0];
  const auto& odd = kFglTables.of[1];
  const Ends low = at_ends(p, {&even.integral_to_1_low, &odd.integral_to_1_low}, 0);
  Ends ends = at_ends(p, {&even.integral_to_1, &odd.integral_to_1}, 0);
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t end = 0; end < 2; ++end) ends[c][end] += low[c][end];
  }
  return ends;
}

// Squares of sizes in w's Legendre series, root mean squares of the terms 4 and 5, 8 and 9, 12 ...
// 15, times the same number.
struct Tail {
  double early;
  double before;
  double last;
};
ROTOR_INLINE Tail tail(const Parts& p) {
  Four squares{};
  for (std::size_t parity = 0; parity < 2; ++parity) {
    std::array<Four, 3> sizes{};
    for (std::size_t j = 0; j < 8; ++j) {
      const Four m = load(kFglTables.of[parity].sizes[j].data());
      for (std::size_t c = 0; c < 3; ++c) sizes[c] += m * broadcast(p.of[parity][c][j]);
    }
    for (const Four& s : sizes) squares += s * s;
  }
  return {2 * squares[0], 2 * squares[1], squares[2] + squares[3]};
}

}  // namespace rotor::fgl
