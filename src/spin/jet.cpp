#include "spin/jet.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "rotation/text.hpp"

// Of a = sum a_k s^k the derivative is a' = sum (k + 1) a_(k+1) s^k. A function f with f' = g(f) a'
// has its coefficients one after the other: (k + 1) f_(k+1) is coefficient k of g(f) a', which
// needs f_0 to f_k only. The last coefficient of a' is beyond what is kept, and is not needed.
namespace rotor {
namespace {

constexpr std::size_t kSize = Jet::kOrder + 1;

[[noreturn]] void refuse(const std::string& function, const std::string& place) {
  throw NotDifferentiable(function + ": no derivatives at " + place);
}
[[noreturn]] void refuse(const std::string& function, double x) {
  refuse(function, "x = " + text(x));
}
[[noreturn]] void refuse(const std::string& function, const Jet& x, const Jet& y) {
  refuse(function, "x = " + text(x.c[0]) + ", y = " + text(y.c[0]));
}

Jet derivative(const Jet& a) {
  Jet result;
  for (std::size_t k = 1; k < kSize; ++k) result.c[k - 1] = static_cast<double>(k) * a.c[k];
  return result;
}

// The function of this derivative that has this value.
Jet integral(double value, const Jet& rate) {
  Jet result = Jet::constant(value);
  for (std::size_t k = 1; k < kSize; ++k) result.c[k] = rate.c[k - 1] / static_cast<double>(k);
  return result;
}

Jet with_value(Jet jet, double value) {
  jet.c[0] = value;
  return jet;
}

// Coefficient k of a product.
double coefficient(const Jet& a, const Jet& b, std::size_t k) {
  double sum = 0;
  for (std::size_t j = 0; j <= k; ++j) sum += a.c[j] * b.c[k - j];
  return sum;
}

double power(double x, double exponent) { return exponent == 2 ? x * x : std::pow(x, exponent); }

// x^r about x = a_0: sum_m C(r, m) a_0^(r - m) (a - a_0)^m, by Horner. A power that is not there
// (r a whole number below m) is not computed: it would be infinite at 0.
Jet power(const Jet& a, const Jet& exponent) {
  const double x = a.c[0];
  const double r = exponent.c[0];
  const bool whole = r == std::floor(r) && std::isfinite(r);
  if (!(x > 0) && !(whole && (r >= 0 || x < 0))) refuse("x ^ y", a, exponent);
  Jet terms;
  double binomial = 1;
  for (std::size_t m = 0; m < kSize && binomial != 0; ++m) {
    const auto order = static_cast<double>(m);
    terms.c[m] = binomial * std::pow(x, r - order);
    binomial *= (r - order) / (order + 1);
  }
  const Jet step = with_value(a, 0);
  Jet result = Jet::constant(terms.c[Jet::kOrder]);
  for (std::size_t m = Jet::kOrder; m-- > 0;) {
    result = result * step;
    result.c[0] += terms.c[m];
  }
  return with_value(result, power(x, r));
}

struct SineCosine {
  Jet sine;
  Jet cosine;
};

// s' = c a', c' = -s a'.
SineCosine sine_cosine(const Jet& a) {
  SineCosine f{Jet::constant(std::sin(a.c[0])), Jet::constant(std::cos(a.c[0]))};
  const Jet rate = derivative(a);
  for (std::size_t k = 0; k < Jet::kOrder; ++k) {
    const auto next = static_cast<double>(k + 1);
    f.sine.c[k + 1] = coefficient(f.cosine, rate, k) / next;
    f.cosine.c[k + 1] = -coefficient(f.sine, rate, k) / next;
  }
  return f;
}

Jet arc_sine_rate(const Jet& a, const char* function) {
  if (!(std::abs(a.c[0]) < 1)) refuse(function, a.c[0]);
  const Jet one = Jet::constant(1);
  return derivative(a) / sqrt((one - a) * (one + a));
}

Jet scaled(Jet a, int exponent) {
  for (double& c : a.c) c = std::ldexp(c, exponent);
  return a;
}

}  // namespace

double Jet::derivative(std::size_t k) const {
  double result = c[k];
  for (std::size_t j = 2; j <= k; ++j) result *= static_cast<double>(j);
  return result;
}

bool Jet::is_constant() const {
  return std::all_of(c.begin() + 1, c.end(), [](double x) { return x == 0; });
}

Jet operator-(const Jet& a) {
  Jet result;
  for (std::size_t k = 0; k < kSize; ++k) result.c[k] = -a.c[k];
  return result;
}

Jet operator+(const Jet& a, const Jet& b) {
  Jet result;
  for (std::size_t k = 0; k < kSize; ++k) result.c[k] = a.c[k] + b.c[k];
  return result;
}

Jet operator-(const Jet& a, const Jet& b) {
  Jet result;
  for (std::size_t k = 0; k < kSize; ++k) result.c[k] = a.c[k] - b.c[k];
  return result;
}

Jet operator*(const Jet& a, const Jet& b) {
  Jet result;
  for (std::size_t k = 0; k < kSize; ++k) result.c[k] = coefficient(a, b, k);
  return with_value(result, a.c[0] * b.c[0]);  // the sum would lose the sign of a zero
}

Jet operator*(const Jet& a, double x) {
  Jet result;
  for (std::size_t k = 0; k < kSize; ++k) result.c[k] = a.c[k] * x;
  return result;
}

// a = q b.
Jet operator/(const Jet& a, const Jet& b) {
  if (b.c[0] == 0) refuse("x / y", a, b);
  Jet q;
  for (std::size_t k = 0; k < kSize; ++k) q.c[k] = (a.c[k] - coefficient(q, b, k)) / b.c[0];
  return with_value(q, a.c[0] / b.c[0]);
}

// a = r^2: the two products with r_k, which coefficient() still takes for zero, are 2 r_0 r_k.
Jet sqrt(const Jet& a) {
  if (!(a.c[0] > 0)) refuse("sqrt", a.c[0]);
  Jet r = Jet::constant(std::sqrt(a.c[0]));
  for (std::size_t k = 1; k < kSize; ++k) {
    r.c[k] = (a.c[k] - coefficient(r, r, k)) / (2 * r.c[0]);
  }
  return r;
}

Jet exp(const Jet& a) {
  Jet e = Jet::constant(std::exp(a.c[0]));
  const Jet rate = derivative(a);
  for (std::size_t k = 0; k < Jet::kOrder; ++k) {
    e.c[k + 1] = coefficient(e, rate, k) / static_cast<double>(k + 1);
  }
  return e;
}

Jet log(const Jet& a) {
  if (!(a.c[0] > 0)) refuse("log", a.c[0]);
  return integral(std::log(a.c[0]), derivative(a) / a);
}

double log_to_base(double x, double base) {
  if (base == 2) return std::log2(x);
  if (base == 10) return std::log10(x);
  return std::log(x) / std::log(base);
}
Jet log(const Jet& a, const Jet& base) {
  return with_value(log(a) / log(base), log_to_base(a.c[0], base.c[0]));
}

Jet pow(const Jet& a, const Jet& exponent) {
  if (exponent.is_constant()) return power(a, exponent);
  if (!(a.c[0] > 0)) refuse("x ^ y", a, exponent);
  return with_value(exp(exponent * log(a)), power(a.c[0], exponent.c[0]));
}

Jet sin(const Jet& a) { return sine_cosine(a).sine; }
Jet cos(const Jet& a) { return sine_cosine(a).cosine; }

// f' = (1 + f^2) a'.
Jet tan(const Jet& a) {
  Jet f = Jet::constant(std::tan(a.c[0]));
  Jet slope;
  const Jet rate = derivative(a);
  for (std::size_t k = 0; k < Jet::kOrder; ++k) {
    slope.c[k] = coefficient(f, f, k) + (k == 0 ? 1 : 0);
    f.c[k + 1] = coefficient(slope, rate, k) / static_cast<double>(k + 1);
  }
  return f;
}

Jet asin(const Jet& a) { return integral(std::asin(a.c[0]), arc_sine_rate(a, "asin")); }
Jet acos(const Jet& a) { return integral(std::acos(a.c[0]), -arc_sine_rate(a, "acos")); }

// (x y' - y x')/(x^2 + y^2), both scaled to about 1.
Jet atan(const Jet& y, const Jet& x) {
  const double largest = std::max(std::abs(x.c[0]), std::abs(y.c[0]));
  const bool jumps = y.c[0] == 0 && x.c[0] < 0 && !y.is_constant();
  if (largest == 0 || jumps) refuse("atan", x, y);
  const int exponent = std::isfinite(largest) ? -std::ilogb(largest) : 0;
  const Jet u = scaled(x, exponent);
  const Jet v = scaled(y, exponent);
  return integral(std::atan2(y.c[0], x.c[0]),
                  (u * derivative(v) - v * derivative(u)) / (u * u + v * v));
}

Jet abs(const Jet& a) {
  if (a.c[0] == 0) refuse("abs", a.c[0]);
  return a.c[0] < 0 ? -a : a;
}

double floor(const Jet& a) {
  const double value = std::floor(a.c[0]);
  if (value == a.c[0]) refuse("floor", value);
  return value;
}

double ceil(const Jet& a) {
  const double value = std::ceil(a.c[0]);
  if (value == a.c[0]) refuse("ceil", value);
  return value;
}

double floor_divide(const Jet& a, const Jet& b) {
  if (b.c[0] == 0 || std::fmod(a.c[0], b.c[0]) == 0) refuse("x // y", a, b);
  return std::floor(a.c[0] / b.c[0]);
}

// fmod is exact, and the quotient that it left out is the nearest whole number to (a - rest)/b.
Jet mod(const Jet& a, const Jet& b) {
  double rest = std::fmod(a.c[0], b.c[0]);
  if (rest == 0 || std::isnan(rest)) refuse("x % y", a, b);
  if ((rest < 0) != (b.c[0] < 0)) rest += b.c[0];
  return with_value(a - b * std::nearbyint((a.c[0] - rest) / b.c[0]), rest);
}

}  // namespace rotor
