#include "dynamics/fraction.hpp"

#include <cmath>
#include <numeric>

#include "catch.hpp"

using namespace rotor;

TEST_CASE("the fraction of the least denominator within the error") {
  const auto check = [](double number, double error, long numerator, long denominator) {
    const auto found = fraction_within(number, error);
    CAPTURE(number, error);
    REQUIRE(found);
    CHECK(found->numerator == numerator);
    CHECK(found->denominator == denominator);
  };
  check(0, 1e-15, 0, 1);
  check(1 - 1e-16, 1e-15, 1, 1);
  check(-2.0 / 3, 1e-15, -2, 3);
  check(0.5, 1e-15, 1, 2);
  check(997.0 / 1000, 1e-15, 997, 1000);
  check(22.0 / 7, 1e-12, 22, 7);
  CHECK_FALSE(fraction_within(std::sqrt(2.0), 1e-13));
  CHECK_FALSE(fraction_within(1.0 / 3 + 1e-12, 1e-13));
  // 1/1009 is beyond 1000.
  CHECK_FALSE(fraction_within(1.0 / 1009, 1e-14));
}

TEST_CASE("a fraction is found by chance with a probability of 1e-6 at most") {
  // 2 error times how many fractions there are in a turn, those without a common divisor.
  for (const double error : {1e-16, 1e-13, 1e-12, 1e-10, 1e-8, 2e-7, 4.9e-7, 1e-6, 1e-3, 1.0}) {
    const auto most = largest_denominator(error);
    double count = 0;
    for (std::size_t n = 1; n <= most; ++n) {
      for (std::size_t k = 1; k <= n; ++k) count += std::gcd(n, k) == 1 ? 1 : 0;
    }
    CAPTURE(error, most);
    CHECK(most <= 1000);
    CHECK(2 * error * count <= 1e-6);
  }
  CHECK(largest_denominator(1e-16) == 1000);
  CHECK(largest_denominator(1e-10) == 70);  // sqrt(1e-6/2e-10) = 70.7
}
