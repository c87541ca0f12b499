// Numbers that carry their derivatives: truncated Taylor series, and their arithmetic.
#pragma once

#include <array>
#include <cstddef>
#include <stdexcept>

namespace rotor {

/// The Taylor coefficients of a function of t about some t0: f(t0 + s) = sum_k c[k] s^k + O(s^9),
/// so that its k-th derivative there is k! c[k].
struct Jet {
  static constexpr std::size_t kOrder = 8;
  std::array<double, kOrder + 1> c{};

  /// A constant.
  static Jet constant(double x) {
    Jet jet;
    jet.c[0] = x;
    return jet;
  }
  /// The variable itself, at t.
  static Jet variable(double t) {
    Jet jet = constant(t);
    jet.c[1] = 1;
    return jet;
  }

  /// k! c[k], k at most kOrder.
  double derivative(std::size_t k) const;
  /// Whether the derivatives are all zero.
  bool is_constant() const;
};

/// Three of them: an angular velocity with its derivatives.
using VectorJet = std::array<Jet, 3>;

/// A function has no derivatives where they were asked for; the message says why.
class NotDifferentiable : public std::domain_error {
 public:
  using std::domain_error::domain_error;
};

// c[0] of every result is to the bit what the same function of doubles gives. Where that function
// has a kink, a jump, an infinite derivative or no value, NotDifferentiable names it and the place.

Jet operator-(const Jet& a);
Jet operator+(const Jet& a, const Jet& b);
Jet operator-(const Jet& a, const Jet& b);
Jet operator*(const Jet& a, const Jet& b);
Jet operator/(const Jet& a, const Jet& b);
Jet operator*(const Jet& a, double x);

Jet sqrt(const Jet& a);
Jet exp(const Jet& a);
Jet log(const Jet& a);
/// Bases 2 and 10 as std::log2 and std::log10, as in Lua.
double log_to_base(double x, double base);
Jet log(const Jet& a, const Jet& base);
/// A power whose exponent does not vary is exact at a = 0 too, where it is a whole number, 0 or
/// more. The square is a product, as in Lua.
Jet pow(const Jet& a, const Jet& exponent);

Jet sin(const Jet& a);
Jet cos(const Jet& a);
Jet tan(const Jet& a);
Jet asin(const Jet& a);
Jet acos(const Jet& a);
/// std::atan2.
Jet atan(const Jet& y, const Jet& x = Jet::constant(1));

Jet abs(const Jet& a);

// What is constant between its jumps is a number.
double floor(const Jet& a);
double ceil(const Jet& a);
/// floor(a/b).
double floor_divide(const Jet& a, const Jet& b);
/// a - b floor(a/b): the sign is that of b.
Jet mod(const Jet& a, const Jet& b);

}  // namespace rotor
