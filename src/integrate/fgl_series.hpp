// Legendre series on a panel, their values at the nodes of a step, and slopes.
#pragma once

#include <array>
#include <cstddef>

#include "integrate/fgl_lanes.hpp"

namespace rotor::fgl {

// (2n + 1)/(n + 1) and n/(n + 1): P_(n+1) = a z P_n - b P_(n-1).
struct LegendreRecurrence {
  std::array<double, 64> a{};
  std::array<double, 64> b{};
};
constexpr LegendreRecurrence legendre_recurrence() {
  LegendreRecurrence r;
  for (std::size_t n = 0; n < r.a.size(); ++n) {
    const auto k = static_cast<double>(n);
    r.a[n] = (2 * k + 1) / (k + 1);
    r.b[n] = k / (k + 1);
  }
  return r;
}
inline constexpr LegendreRecurrence kLegendre = legendre_recurrence();

// P_n and P_(n-1) at four places z; then P_(n+2) and P_(n+1), P_n and P_(n+1) stored.
struct LegendrePair {
  Four z;
  Four even;
  Four odd;
};
ROTOR_INLINE LegendrePair legendre_start(double middle, double half, std::size_t lane) {
  return {broadcast(middle) + load(&kFglTables.nodes[lane]) * broadcast(half), broadcast(1),
          broadcast(0)};
}
ROTOR_INLINE void legendre_next(std::size_t n, std::size_t lane, LegendrePair& p,
                                LegendreLanes& out) {
  p.odd = broadcast(kLegendre.a[n]) * (p.z * p.even) - broadcast(kLegendre.b[n]) * p.odd;
  store(&out.p[n][lane], p.even);
  store(&out.p[n + 1][lane], p.odd);
  p.even = broadcast(kLegendre.a[n + 1]) * (p.z * p.odd) - broadcast(kLegendre.b[n + 1]) * p.even;
}

// By name, not in an array, the pairs stay in registers: twice as fast.
ROTOR_INLINE void legendre_body(double middle, double half, LegendreLanes& out) {
  LegendrePair p0 = legendre_start(middle, half, 0);
  LegendrePair p1 = legendre_start(middle, half, 4);
  LegendrePair p2 = legendre_start(middle, half, 8);
  LegendrePair p3 = legendre_start(middle, half, 12);
  for (std::size_t n = 0; n < out.p.size(); n += 2) {
    legendre_next(n, 0, p0, out);
    legendre_next(n, 4, p1, out);
    legendre_next(n, 8, p2, out);
    legendre_next(n, 12, p3, out);
  }
}

ROTOR_INLINE void restrict_body(const LegendreLanes& legendre, const PanelTerms& c, Extended scale,
                                NodeVectors& out, NodeVectors& mirrored) {
  const auto rounded = static_cast<double>(scale);
  const Four high = broadcast(rounded);
  const Four low = broadcast(static_cast<double>(scale - Extended{rounded}));
  for (std::size_t k = 0; k < 3; ++k) {
    FourLanes even{};
    FourLanes odd{};
    for (std::size_t n = 0; n < legendre.p.size(); n += 2) {
      const Four a = broadcast(c[k][n]);
      const Four b = broadcast(c[k][n + 1]);
      for (std::size_t i = 0; i < 4; ++i) {
        even[i] += a * load(&legendre.p[n][4 * i]);
        odd[i] += b * load(&legendre.p[n + 1][4 * i]);
      }
    }
    for (std::size_t i = 0; i < 4; ++i) {
      const Four here = even[i] + odd[i];
      const Four there = even[i] - odd[i];
      store(&out.v[k][4 * i], high * here + low * here);
      store(&mirrored.v[k][(4 * i + 8) % 16], high * there + low * there);
    }
  }
}

ROTOR_INLINE void parity_product_body(const double* even, const double* odd, const PanelTerms& f,
                                      PanelTerms& out) {
  for (std::size_t c = 0; c < 3; ++c) {
    const double* matrix = even;
    for (std::size_t parity = 0; parity < 2; ++parity, matrix = odd) {
      std::array<Four, 8> sum{};
      for (std::size_t j = 0; j < 32; ++j) {
        const double part = parity == 0 ? f[c][j] + f[c][32 + j] : f[c][j] - f[c][32 + j];
        for (std::size_t i = 0; i < 8; ++i)
          sum[i] += broadcast(part) * load(matrix + 32 * j + 4 * i);
      }
      for (std::size_t i = 0; i < 8; ++i) store(&out[c][32 * parity + 4 * i], sum[i]);
    }
  }
}

ROTOR_INLINE void slope_body(const NodeVectors& w, NodeSlopes& out) {
  const Parts p = parts(loaded(w));
  // The derivative of the even part is odd, and the other way round.
  const Vectors f =
      joined(product(kFglTables.of[0].slope, p.of[0]), product(kFglTables.of[1].slope, p.of[1]));
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t i = 0; i < 4; ++i) store(&out.slopes.v[c][4 * i], f[c][i]);
  }
  out.ends = at_ends(p, {&kFglTables.of[0].value_at_1, &kFglTables.of[1].value_at_1}, 1);
}

}  // namespace rotor::fgl
