// Jets against derivatives in 50 digits, closed forms, and the functions of numbers.
#include "spin/jet.hpp"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "catch.hpp"
#include "rotation/extended.hpp"

namespace {

using rotor::Jet;

constexpr double kUnit = std::numeric_limits<double>::epsilon() / 2;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Jet number(double x) { return Jet::constant(x); }

// As make_jets.py names them.
const std::map<std::string, std::function<Jet(const Jet&)>> kFunctions = {
    {"waves", [](const Jet& t) { return sin(t * 3) + cos(t * 17) * 0.3; }},
    {"chirp", [](const Jet& t) { return exp(-t / number(50)) * cos(t * t / number(40)); }},
    {"log1p", [](const Jet& t) { return log(number(1) + t) * 0.5; }},
    {"log10", [](const Jet& t) { return log(t, number(10)); }},
    {"log_to_t", [](const Jet& t) { return log(number(3), t); }},
    {"root", [](const Jet& t) { return sqrt(number(1) + t * t); }},
    {"tan", [](const Jet& t) { return tan(t); }},
    {"asin", [](const Jet& t) { return asin(t); }},
    {"acos", [](const Jet& t) { return acos(t); }},
    {"atan", [](const Jet& t) { return atan(t); }},
    {"atan2", [](const Jet& t) { return atan(sin(t) * 0.5, cos(t)); }},
    {"power", [](const Jet& t) { return pow(t, number(2.5)); }},
    {"inverse_cube", [](const Jet& t) { return pow(t, number(-3)); }},
    {"exponential", [](const Jet& t) { return pow(number(2), t); }},
    {"tower", [](const Jet& t) { return pow(t, t); }},
    {"witch", [](const Jet& t) { return number(1) / (number(1) + t * t); }},
};

// The jet of the polynomial t^n, from Pascal's rows.
double binomial(int n, std::size_t k) {
  double result = 1;
  for (std::size_t j = 0; j < k; ++j) result *= (n - double(j)) / (double(j) + 1);
  return result;
}

std::string refusal(const std::function<void()>& call) {
  try {
    call();
  } catch (const rotor::NotDifferentiable& e) {
    return e.what();
  }
  return "(accepted)";
}

}  // namespace

// Coefficient k of a product is a sum of k + 1 terms, each at most M_a M_b/r^k by Cauchy's bound:
// its rounding is at most (k + 1)^2 u times that, and so for each step of a recurrence. The table's
// functions take fewer than eight such operations.
TEST_CASE("jets have the derivatives that 50 digits have") {
  std::ifstream file(ROTOR_SOURCE_DIR "/tests/spin/jets.csv");
  std::string line;
  REQUIRE(std::getline(file, line));
  std::size_t rows = 0;
  for (; std::getline(file, line); ++rows) {
    std::istringstream fields(line);
    std::string name;
    std::string field;
    std::getline(fields, name, ',');
    std::getline(fields, field, ',');
    const double t = std::strtod(field.c_str(), nullptr);
    const Jet jet = kFunctions.at(name)(Jet::variable(t));
    for (std::size_t k = 0; k <= Jet::kOrder; ++k) {
      std::getline(fields, field, ',');
      const rotor::Extended expected = std::strtold(field.c_str(), nullptr);
      REQUIRE(std::getline(fields, field, ','));
      const double scale = std::strtod(field.c_str(), nullptr);
      const auto error = double(std::abs(jet.c[k] - expected));
      CAPTURE(name, t, k, jet.c[k], error / scale / kUnit);
      CHECK(error <= 8 * double((k + 1) * (k + 1)) * kUnit * scale);
    }
  }
  CHECK(rows > 50);
}

TEST_CASE("the value of a jet is to the bit what the function of a number gives") {
  std::mt19937_64 random(7);
  const auto check = [&](double low, double high, const auto& of_jet, const auto& of_number) {
    for (int i = 0; i < 200; ++i) {
      const double x = std::uniform_real_distribution(low, high)(random);
      CAPTURE(x);
      CHECK(of_jet(Jet::variable(x)).c[0] == of_number(x));
    }
  };
  const auto one = [&](double low, double high, Jet (*of_jet)(const Jet&), double (*f)(double)) {
    check(low, high, of_jet, f);
  };
  one(-9, 9, rotor::sin, std::sin);
  one(-9, 9, rotor::cos, std::cos);
  one(-9, 9, rotor::tan, std::tan);
  one(-9, 9, rotor::exp, std::exp);
  one(0, 9, rotor::log, std::log);
  one(0, 9, rotor::sqrt, std::sqrt);
  one(-1, 1, rotor::asin, std::asin);
  one(-1, 1, rotor::acos, std::acos);
  one(-9, 9, rotor::abs, std::fabs);
  check(
      -9, 9, [](const Jet& x) { return atan(x); }, [](double x) { return std::atan2(x, 1); });
  check(
      -9, 9, [](const Jet& x) { return atan(x, number(-2)); },
      [](double x) { return std::atan2(x, -2); });
  check(
      0, 9, [](const Jet& x) { return log(x, number(2)); }, [](double x) { return std::log2(x); });
  check(
      -9, 9, [](const Jet& x) { return pow(x, number(2)); }, [](double x) { return x * x; });
  check(
      -9, 9, [](const Jet& x) { return pow(x, number(-5)); },
      [](double x) { return std::pow(x, -5); });
  check(
      0, 9, [](const Jet& x) { return pow(x, x); }, [](double x) { return std::pow(x, x); });
  check(
      -9, 9, [](const Jet& x) { return number(3) / x; }, [](double x) { return 3 / x; });
  check(
      -9, 9, [](const Jet& x) { return x * x * 0.1 - x; },
      [](double x) { return x * x * 0.1 - x; });
  // Lua's rest has the sign of the divisor.
  check(
      -9, 9, [](const Jet& x) { return mod(x, number(0.7)); },
      [](double x) { return std::fmod(x, 0.7) + (x < 0 ? 0.7 : 0.0); });
  check(
      -9, 9, [](const Jet& x) { return mod(x, number(-0.7)); },
      [](double x) { return std::fmod(x, 0.7) - (x > 0 ? 0.7 : 0.0); });
  CHECK(std::signbit((Jet::variable(-0.0) * Jet::variable(3)).c[0]));
}

TEST_CASE("whole powers are good to the last digits at 0, near it and far from it") {
  for (const int n : {0, 1, 2, 3, 7, 8, 9, 12, 40}) {
    for (const double t : {0.0, -0.0, 1e-30, -1e-30, 1.0, -3.0, 1e6}) {
      const Jet jet = pow(Jet::variable(t), number(n));
      for (std::size_t k = 0; k <= Jet::kOrder; ++k) {
        CAPTURE(n, t, k);
        const int rest = n - int(k);
        const double expected = rest < 0 ? 0 : binomial(n, k) * std::pow(t, rest);
        // binomial: k roundings each there and here; std::pow one ulp.
        CHECK(std::abs(jet.c[k] - expected) <= 20 * kUnit * std::abs(expected));
      }
    }
  }
}

TEST_CASE("functions undo one another") {
  std::mt19937_64 random(11);
  // Each coefficient of x is of size 1 at most; the compositions' are below 50 (measured), and the
  // error of coefficient k below 8 (k + 1)^2 u times that: 8 * 81 * 50.
  const double tolerance = 8 * 81 * 50 * kUnit;
  for (int i = 0; i < 50; ++i) {
    Jet x;
    for (double& c : x.c) c = std::uniform_real_distribution(-0.5, 0.5)(random);
    const auto same = [&](const char* what, const Jet& y) {
      for (std::size_t k = 0; k <= Jet::kOrder; ++k) {
        CAPTURE(i, what, k);
        CHECK(std::abs(y.c[k] - x.c[k]) <= tolerance);
      }
    };
    same("exp and log", log(exp(x)));
    same("sin and asin", asin(sin(x)));
    same("cos and acos", number(std::acos(0.0)) - acos(cos(number(std::acos(0.0)) - x)));
    same("tan and atan", atan(tan(x)));
    same("sin, cos and atan", atan(sin(x) * 1e300, cos(x) * 1e300));
    same("sin, cos and atan, small", atan(sin(x) * 1e-300, cos(x) * 1e-300));
    same("root of square", sqrt(pow(x + number(2), number(2))) - number(2));
    same("cube root of cube", pow(pow(x + number(2), number(3)), number(1.0 / 3)) - number(2));
    same("times and by", x * exp(x) / exp(x));
    same("rest and quotient", mod(x, number(0.3)) + number(0.3 * floor_divide(x, number(0.3))));
  }
}

TEST_CASE("what does not vary between its jumps is a number") {
  CHECK(floor(Jet::variable(2.5)) == 2);
  CHECK(floor(Jet::variable(-2.5)) == -3);
  CHECK(ceil(Jet::variable(2.5)) == 3);
  CHECK(floor_divide(Jet::variable(7), number(-2)) == -4);
  const Jet rest = mod(Jet::variable(7), number(-2));
  CHECK(rest.c[0] == -1);
  CHECK(rest.c[1] == 1);
  const Jet by = mod(number(7), Jet::variable(2));  // 7 - 3 t
  CHECK(by.c[0] == 1);
  CHECK(by.c[1] == -3);
  CHECK(mod(Jet::variable(1e300), number(0.7)).c[0] == std::fmod(1e300, 0.7));
}

TEST_CASE("places without derivatives are named") {
  const auto at = [](double x) { return Jet::variable(x); };
  CHECK(refusal([&] { sqrt(at(0)); }) == "sqrt: no derivatives at x = 0.0");
  CHECK(refusal([&] { sqrt(at(-1)); }) == "sqrt: no derivatives at x = -1.0");
  CHECK(refusal([&] { sqrt(at(kNaN)); }) == "sqrt: no derivatives at x = nan");
  CHECK(refusal([&] { log(at(0)); }) == "log: no derivatives at x = 0.0");
  CHECK(refusal([&] { log(at(2), number(0)); }) == "log: no derivatives at x = 0.0");
  CHECK(refusal([&] { abs(at(-0.0)); }) == "abs: no derivatives at x = -0.0");
  CHECK(refusal([&] { asin(at(1)); }) == "asin: no derivatives at x = 1.0");
  CHECK(refusal([&] { acos(at(-1)); }) == "acos: no derivatives at x = -1.0");
  CHECK(refusal([&] { atan(at(0), at(0)); }) == "atan: no derivatives at x = 0.0, y = 0.0");
  CHECK(refusal([&] { atan(at(0), number(-1)); }) == "atan: no derivatives at x = -1.0, y = 0.0");
  CHECK(refusal([&] { atan(number(0), at(-1)); }) == "(accepted)");
  CHECK(refusal([&] { at(1) / at(0); }) == "x / y: no derivatives at x = 1.0, y = 0.0");
  CHECK(refusal([&] { pow(at(0), number(0.5)); }) == "x ^ y: no derivatives at x = 0.0, y = 0.5");
  CHECK(refusal([&] { pow(at(0), number(-1)); }) == "x ^ y: no derivatives at x = 0.0, y = -1.0");
  CHECK(refusal([&] { pow(at(-1), number(0.5)); }) == "x ^ y: no derivatives at x = -1.0, y = 0.5");
  CHECK(refusal([&] { pow(at(2), number(kInfinity)); }) == "(accepted)");
  CHECK(refusal([&] { pow(at(-2), number(kInfinity)); }) ==
        "x ^ y: no derivatives at x = -2.0, y = inf");
  CHECK(refusal([&] { pow(number(0), at(2)); }) == "x ^ y: no derivatives at x = 0.0, y = 2.0");
  CHECK(refusal([&] { floor(at(3)); }) == "floor: no derivatives at x = 3.0");
  CHECK(refusal([&] { ceil(at(3)); }) == "ceil: no derivatives at x = 3.0");
  CHECK(refusal([&] { mod(at(6), number(3)); }) == "x % y: no derivatives at x = 6.0, y = 3.0");
  CHECK(refusal([&] { mod(at(6), number(0)); }) == "x % y: no derivatives at x = 6.0, y = 0.0");
  CHECK(refusal([&] { floor_divide(at(6), number(3)); }) ==
        "x // y: no derivatives at x = 6.0, y = 3.0");
  CHECK(refusal([&] { floor_divide(at(6), number(0)); }) ==
        "x // y: no derivatives at x = 6.0, y = 0.0");
}
