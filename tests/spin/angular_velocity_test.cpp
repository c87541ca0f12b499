#include "spin/models.hpp"

#include <cmath>
#include <limits>
#include <string>

#include "catch.hpp"

namespace {

using Catch::Matchers::Contains;
using rotor::AngularVelocity, rotor::NonFiniteOmega, rotor::Vector;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

struct ScriptError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace

TEST_CASE("a constant angular velocity has its value at every t, to the bit") {
  for (const double size : {0.0, 5e-324, 1e-300, 1.0, 1e300, 1.7e308}) {
    const Vector value(size, -size, size / 3);
    const AngularVelocity omega(value);
    REQUIRE(omega.as<rotor::ConstantSpin>() != nullptr);
    for (const double t : {-1e9, 0.0, 1e300}) CHECK(omega(t) == value);
  }
}

TEST_CASE("a constant angular velocity that is not finite is refused, and shown") {
  for (const double bad : {kInfinity, -kInfinity, kNaN}) {
    CHECK_THROWS_AS(AngularVelocity(Vector(0, bad, 1)), std::invalid_argument);
  }
  CHECK_THROWS_WITH(AngularVelocity(Vector(0, kInfinity, 1)),
                    Contains("(0.0, inf, 1.0)") && Contains("expected"));
}

TEST_CASE("a function of t is called once for each value, with the very t") {
  int calls = 0;
  double last = 0;
  const AngularVelocity omega([&](double t) {
    ++calls;
    last = t;
    return Vector(t, 2 * t, -1);
  });
  CHECK(omega.as<rotor::ConstantSpin>() == nullptr);
  CHECK(omega(0.1) == Vector(0.1, 0.2, -1));
  CHECK(last == 0.1);
  CHECK(calls == 1);
}

TEST_CASE("a function that gives NaN or infinity is named, with t and what it gave") {
  for (const double bad : {kInfinity, -kInfinity, kNaN}) {
    const AngularVelocity omega(
        [bad](double t) { return t < 2 ? Vector(1, 0, 0) : Vector(1, bad, 0); }, "spin_up");
    CHECK(omega(1) == Vector(1, 0, 0));
    CHECK_THROWS_AS(omega(2.5), NonFiniteOmega);
    const std::string value = bad > 0 ? "inf" : bad < 0 ? "-inf" : "nan";
    CHECK_THROWS_WITH(omega(2.5), Contains("spin_up") && Contains("t = 2.5") &&
                                      Contains("(1.0, " + value + ", 0.0)") &&
                                      Contains("expected"));
  }
  const AngularVelocity unnamed([](double) { return Vector(kNaN, 0, 0); });
  CHECK_THROWS_WITH(unnamed(0), Contains("omega gave"));
}

TEST_CASE("what a function throws passes through unchanged") {
  const AngularVelocity omega([](double) -> Vector { throw ScriptError("line 3"); });
  CHECK_THROWS_AS(omega(0), ScriptError);
  const AngularVelocity other([](double) -> Vector { throw 42; });  // not a std::exception
  CHECK_THROWS_AS(other(0), int);
}
