#include "integrate/fgl_kernel.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "integrate/fgl_lanes.hpp"
#include "integrate/fgl_series.hpp"
#include "integrate/fgl_tables.hpp"
#include "integrate/gauss_tables.hpp"

namespace rotor {
namespace {

using namespace fgl;

// A pair of polynomials that holds up to `greatest`, or null.
template <class Fits>
ROTOR_INLINE const typename Fits::value_type* fit_for(const Fits& fits, double greatest) {
  for (const auto& fit : fits) {
    if (greatest <= fit.range) return &fit;
  }
  return nullptr;
}

template <class Fit, std::size_t N>
ROTOR_INLINE void evaluate(const Fit& fit, const std::array<Four, N>& x, std::array<Four, N>& first,
                           std::array<Four, N>& second) {
  std::array<Four, N> u;
  for (std::size_t i = 0; i < N; ++i) {
    u[i] = x[i] * broadcast(2 / fit.range) - broadcast(1);
    first[i] = broadcast(fit.first[fit.degree]);
    second[i] = broadcast(fit.second[fit.degree]);
  }
  for (std::size_t k = fit.degree; k-- > 0;) {
    const Four a = broadcast(fit.first[k]);
    const Four b = broadcast(fit.second[k]);
    for (std::size_t i = 0; i < N; ++i) {
      first[i] = first[i] * u[i] + a;
      second[i] = second[i] * u[i] + b;
    }
  }
}

ROTOR_INLINE FourLanes square(const Vectors& a) {
  FourLanes s;
  for (std::size_t i = 0; i < 4; ++i) {
    s[i] = a[0][i] * a[0][i] + a[1][i] * a[1][i] + a[2][i] * a[2][i];
  }
  return s;
}

// f1 F x w + f2 F x (F x w): what is left of w after exp(F). False where F is too long.
ROTOR_INLINE bool pass_on(const Vectors& f, Vectors& w) {
  const FourLanes x = square(f);
  const auto* fit = fit_for(kFerFits, greatest(x));
  if (fit == nullptr) return false;
  FourLanes f1;
  FourLanes f2;
  evaluate(*fit, x, f1, f2);
  for (std::size_t i = 0; i < 4; ++i) {
    const Four ax = f[1][i] * w[2][i] - f[2][i] * w[1][i];
    const Four ay = f[2][i] * w[0][i] - f[0][i] * w[2][i];
    const Four az = f[0][i] * w[1][i] - f[1][i] * w[0][i];
    w[0][i] = f1[i] * ax + f2[i] * (f[1][i] * az - f[2][i] * ay);
    w[1][i] = f1[i] * ay + f2[i] * (f[2][i] * ax - f[0][i] * az);
    w[2][i] = f1[i] * az + f2[i] * (f[0][i] * ay - f[1][i] * ax);
  }
  return true;
}

using Quaternion4 = std::array<double, 4>;
ROTOR_INLINE Quaternion4 times(const Quaternion4& a, const Quaternion4& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
          a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] + a[2] * b[0] + a[3] * b[1] - a[1] * b[3],
          a[0] * b[3] + a[3] * b[0] + a[1] * b[2] - a[2] * b[1]};
}

// exp(F_1) exp(F_2) ... at both ends; F_k in lanes 2 k and 2 k + 1. Lanes beyond `lanes` are 0.
struct Factors {
  alignas(32) std::array<std::array<double, 2 * kMostLevels>, 3> ends;
  std::size_t count = 0;

  ROTOR_INLINE Factors() {
    for (auto& component : ends) {
      for (std::size_t i = 0; i < component.size(); i += 4) store(&component[i], broadcast(0));
    }
  }

  ROTOR_INLINE void append(const Ends& e) {
    for (std::size_t c = 0; c < 3; ++c) {
      ends[c][2 * count] = e[c][0];
      ends[c][2 * count + 1] = e[c][1];
    }
    ++count;
  }
};

ROTOR_INLINE Quaternion4 conjugate(const Quaternion4& q) { return {q[0], -q[1], -q[2], -q[3]}; }

using BothEnds = std::array<Quaternion4, 2>;
ROTOR_INLINE bool exponentials(const Factors& factors, BothEnds& v) {
  constexpr std::size_t kFours = 2 * kMostLevels / 4;
  std::array<std::array<Four, kFours>, 3> f;
  std::array<Four, kFours> x;
  Four most{};
  for (std::size_t i = 0; i < kFours; ++i) {
    for (std::size_t c = 0; c < 3; ++c) f[c][i] = load(&factors.ends[c][4 * i]);
    x[i] = f[0][i] * f[0][i] + f[1][i] * f[1][i] + f[2][i] * f[2][i];
    most = larger(most, x[i]);
  }
  const auto* fit = fit_for(kExpFits, greatest({most, most, most, most}));
  if (fit == nullptr) return false;
  std::array<Four, kFours> cosine;
  std::array<Four, kFours> sine;
  evaluate(*fit, x, cosine, sine);
  alignas(32) std::array<std::array<double, 2 * kMostLevels>, 4> q;
  for (std::size_t i = 0; i < kFours; ++i) {
    store(&q[0][4 * i], cosine[i]);
    for (std::size_t c = 0; c < 3; ++c) store(&q[c + 1][4 * i], f[c][i] * sine[i]);
  }
  for (std::size_t end = 0; end < 2; ++end) {
    v[end] = {q[0][end], q[1][end], q[2][end], q[3][end]};
    for (std::size_t k = 1; k < factors.count; ++k) {
      const std::size_t l = 2 * k + end;
      v[end] = times(v[end], {q[0][l], q[1][l], q[2][l], q[3][l]});
    }
  }
  return true;
}

// The errors of a step from the tails of its levels, which are taken to go on falling as they last
// did. At the end of the step two things are wrong at each level: the terms of w of degree 32 and
// more are lost, and those from 16 on act together with their like, of this level and the one
// before, over integrals that make them smaller. Within a half of the step those from 16 on act
// alone, as large as they are there. What noise explains is no error.
class ErrorSum {
 public:
  ROTOR_INLINE explicit ErrorSum(double noise) : noise_(4 * noise * noise) {}
  ROTOR_INLINE void add(const Tail& tail) {
    const bool plateau = tail.last <= 4 * noise_ && tail.before <= 4 * noise_;
    const double last = plateau || tail.last <= noise_ ? 0 : tail.last - noise_;
    // Squared, over five degrees. A bend of w, the first, may by chance leave little in the last.
    double fall = ratio(last, tail.before);
    if (levels_ == 0) fall = std::max(fall, std::sqrt(ratio(last, tail.early)));
    const double root = std::sqrt(std::sqrt(fall));
    const double size = std::sqrt(last);
    const double next = size * root;
    const double safety = 2 + (levels_ == 0 ? kRough : 2) * root;
    at_end_ += safety * (size * fall * root * root * root + next * (next + before_) / 32);
    // Half as long: by r^2 less where terms fall fast, but no less where they fall slowly. (Where
    // it does not resolve U, the dense output takes shorter parts.)
    between_ += safety * next * std::min(1.0, fall + 44 * fall * fall) / 32;
    before_ = next;
    if (levels_++ == 0) {
      left_out_ = next;
      fall_ = fall;
    }
  }
  // `rest` bounds what the levels that are not taken turn by: the integral of the next one's |w|.
  ROTOR_INLINE FglStep step(const Quaternion4& turn, double rest) const {
    return {turn, at_end_ + rest, between_, rest, left_out_, fall_};
  }

 private:
  ROTOR_INLINE static double ratio(double a, double b) { return a < b ? a / b : 1; }

  // Random sums of waves, poles and jumps have at most 1/5 of the error found; bends as a rule less
  // than that, one in a hundred 6 times it, near an end, which is what error_at_ends looks for.
  static constexpr double kRough = 256;
  double noise_;
  double at_end_ = 0;
  double between_ = 0;
  double before_ = 0;
  double left_out_ = 0;
  double fall_ = 0;
  int levels_ = 0;
};

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr FglStep kTooLong{{1, 0, 0, 0}, kInfinity, kInfinity, 0, 0, 0};

ROTOR_INLINE FglStep step_body(const NodeVectors& nodes, double negligible, double noise) {
  Vectors w = loaded(nodes);
  Factors factors;
  double most = greatest(square(w));
  ErrorSum error(noise + kRounding * std::sqrt(most));
  while (true) {
    const Parts p = parts(w);
    factors.append(integral_to_ends(p));
    error.add(tail(p));
    // |f1 F x w| <= |F||w|/2, and |F| <= |w|.
    if (factors.count == kMostLevels || most / 2 <= negligible) break;
    if (!pass_on(integral(p), w)) return kTooLong;
    most = greatest(square(w));
  }
  BothEnds v;
  if (!exponentials(factors, v)) return kTooLong;
  return error.step(times(v[0], conjugate(v[1])), most);
}

using Quaternions = std::array<FourLanes, 4>;
ROTOR_INLINE Quaternions times(const Quaternions& a, const Quaternions& b) {
  Quaternions q;
  for (std::size_t i = 0; i < 4; ++i) {
    q[0][i] = a[0][i] * b[0][i] - a[1][i] * b[1][i] - a[2][i] * b[2][i] - a[3][i] * b[3][i];
    q[1][i] = a[0][i] * b[1][i] + a[1][i] * b[0][i] + a[2][i] * b[3][i] - a[3][i] * b[2][i];
    q[2][i] = a[0][i] * b[2][i] + a[2][i] * b[0][i] + a[3][i] * b[1][i] - a[1][i] * b[3][i];
    q[3][i] = a[0][i] * b[3][i] + a[3][i] * b[0][i] + a[1][i] * b[2][i] - a[2][i] * b[1][i];
  }
  return q;
}

ROTOR_INLINE Quaternions everywhere(const Quaternion4& q) {
  Quaternions lanes;
  for (std::size_t c = 0; c < 4; ++c) lanes[c].fill(broadcast(q[c]));
  return lanes;
}

// exp(F) at the nodes. False where F is too long.
ROTOR_INLINE bool exponential(const Vectors& f, Quaternions& q) {
  const FourLanes x = square(f);
  const auto* fit = fit_for(kExpFits, greatest(x));
  if (fit == nullptr) return false;
  FourLanes sine;
  evaluate(*fit, x, q[0], sine);
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t i = 0; i < 4; ++i) q[c + 1][i] = f[c][i] * sine[i];
  }
  return true;
}

ROTOR_INLINE bool interior_body(const NodeVectors& nodes, FglInterior& out) {
  Vectors w = loaded(nodes);
  Factors factors;
  Quaternions v{};
  for (Four& x : v[0]) x = broadcast(1);
  while (true) {
    const Parts p = parts(w);
    const Vectors f = integral(p);
    factors.append(integral_to_ends(p));
    Quaternions turn;
    if (!exponential(f, turn)) return false;
    v = times(v, turn);
    if (factors.count == kMostLevels || greatest(square(w)) / 2 <= 1e-18) break;
    if (!pass_on(f, w)) return false;
  }
  BothEnds ends;
  if (!exponentials(factors, ends)) return false;
  const Quaternion4 back = conjugate(ends[1]);
  v = times(v, everywhere(back));
  for (std::size_t c = 0; c < 4; ++c) {
    for (std::size_t i = 0; i < 4; ++i) store(&out.nodes[c][4 * i], v[c][i]);
  }
  out.end = times(ends[0], back);
  return true;
}

// The interpolant at the 16 nodes, and (a + b z) P_16, which is 0 there, for the values at the
// ends.
ROTOR_INLINE void fit_body(const FglInterior& v, const Quaternion4& from, const Quaternion4& turn,
                           FglPiece& out) {
  Quaternions q;
  for (std::size_t c = 0; c < 4; ++c) {
    for (std::size_t i = 0; i < 4; ++i) q[c][i] = load(&v.nodes[c][4 * i]);
  }
  q = times(q, everywhere(from));
  const Quaternions off = times(everywhere(turn), q);
  for (std::size_t i = 0; i < 4; ++i) {
    const Four s = broadcast(0.5) + broadcast(0.5) * load(&kFglTables.nodes[4 * i]);
    for (std::size_t c = 0; c < 4; ++c) q[c][i] += s * off[c][i];
  }
  const PartsOf<4> p = parts(q);
  alignas(32) std::array<std::array<std::array<double, 8>, 4>, 2> terms;
  for (std::size_t parity = 0; parity < 2; ++parity) {
    const auto part = product(kFglTables.of[parity].terms, p.of[parity]);
    for (std::size_t c = 0; c < 4; ++c) {
      for (std::size_t i = 0; i < 2; ++i) store(&terms[parity][c][4 * i], part[c][i]);
    }
  }
  const Quaternion4 end = times(v.end, from);
  const Quaternion4 off_end = times(turn, end);
  for (std::size_t c = 0; c < 4; ++c) {
    const std::size_t to = (c + 3) % 4;
    std::array<double, 2> sum{};
    for (std::size_t n = 0; n < kFglNodes; ++n) {
      out.terms[n][to] = terms[n % 2][c][n / 2];
      sum[n % 2] += out.terms[n][to];
    }
    const double at_1 = end[c] + off_end[c];
    const double a = (at_1 + from[c]) / 2 - sum[0];
    const double b = (at_1 - from[c]) / 2 - sum[1];
    out.terms[16][to] = 0;
    out.terms[17][to] = 0;
    for (std::size_t n = 0; n < out.terms.size(); ++n) {
      out.terms[n][to] += kFglTables.vanishing[n] * (n % 2 == 0 ? a : b);
    }
  }
}

// Four short chains of operations, not a long one: the terms n = 4 k + r, which for each r follow
// T_(n+4) = 2 T_4 T_n - T_(n-4) (Clenshaw), and T_(-n) = T_n.
ROTOR_INLINE void value_body(const FglPiece& piece, double z, double* out) {
  const double t2 = 2 * z * z - 1;
  const double t3 = z * (2 * t2 - 1);
  const double t4 = 2 * t2 * t2 - 1;
  const auto& c = piece.terms;
  std::array<Four, 4> b1 = {load(c[16].data()), load(c[17].data()), broadcast(0), broadcast(0)};
  std::array<Four, 4> b2{};
  for (std::size_t n = 16; n > 0; n -= 4) {
    for (std::size_t r = 0; r < 4; ++r) {
      const Four b = (load(c[n - 4 + r].data()) - b2[r]) + broadcast(2 * t4) * b1[r];
      b2[r] = b1[r];
      b1[r] = b;
    }
  }
  const Four u =
      ((b1[0] - broadcast(t4) * b2[0]) + (broadcast(z) * b1[1] - broadcast(t3) * b2[1])) +
      (broadcast(t2) * (b1[2] - b2[2]) + (broadcast(t3) * b1[3] - broadcast(z) * b2[3]));
  const double off = sum(u * u) - 1;
  // 1/sqrt(1 + off), without the root where the next term, 5 off^3/16, is lost in rounding.
  const double scale =
      std::abs(off) < 1e-6 ? 1 - off * (0.5 - 0.375 * off) : 1 / std::sqrt(1 + off);
  store(out, broadcast(scale) * u);
}

// The same for every machine: only the instructions differ.
#define ROTOR_FGL_KERNEL(kernel, ...)                                                           \
  namespace kernel {                                                                            \
  __VA_ARGS__ FglStep step(const NodeVectors& w, double negligible, double noise) {             \
    return step_body(w, negligible, noise);                                                     \
  }                                                                                             \
  __VA_ARGS__ bool interior(const NodeVectors& w, FglInterior& out) {                           \
    return interior_body(w, out);                                                               \
  }                                                                                             \
  __VA_ARGS__ void fit(const FglInterior& v, const Quaternion4& from, const Quaternion4& turn,  \
                       FglPiece& out) {                                                         \
    fit_body(v, from, turn, out);                                                               \
  }                                                                                             \
  __VA_ARGS__ void value(const FglPiece& piece, double z, double* out) {                        \
    value_body(piece, z, out);                                                                  \
  }                                                                                             \
  __VA_ARGS__ void legendre(double middle, double half, LegendreLanes& out) {                   \
    legendre_body(middle, half, out);                                                           \
  }                                                                                             \
  __VA_ARGS__ void restrict_to(const LegendreLanes& lanes, const PanelTerms& c, Extended scale, \
                               NodeVectors& out, NodeVectors& mirrored) {                       \
    restrict_body(lanes, c, scale, out, mirrored);                                              \
  }                                                                                             \
  __VA_ARGS__ void parity_product(const double* even, const double* odd, const PanelTerms& f,   \
                                  PanelTerms& out) {                                            \
    parity_product_body(even, odd, f, out);                                                     \
  }                                                                                             \
  __VA_ARGS__ void slope(const NodeVectors& w, NodeSlopes& out) { slope_body(w, out); }         \
  constexpr FglKernel kKernel{step,        interior,       fit,  value, legendre,               \
                              restrict_to, parity_product, slope};                              \
  }

ROTOR_FGL_KERNEL(portable)
#if defined(__x86_64__)
ROTOR_FGL_KERNEL(avx2, [[gnu::target("avx2")]])
#endif

}  // namespace

const FglKernel& portable_fgl_kernel() { return portable::kKernel; }

const FglKernel& fgl_kernel() {
#if defined(__x86_64__)
  static const bool fast = [] {
    const char* portable = std::getenv("ROTOR_PORTABLE");
    return __builtin_cpu_supports("avx2") &&
           (portable == nullptr || std::strcmp(portable, "1") != 0);
  }();
  if (fast) return avx2::kKernel;
#endif
  return portable::kKernel;
}

}  // namespace rotor
