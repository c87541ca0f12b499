// The times at which runs are asked.
#include "motion/times.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "catch.hpp"

using namespace rotor;

TEST_CASE("n times go from end to end, both included") {
  CHECK(times_in(0, 10, 5) == std::vector<double>{0, 2.5, 5, 7.5, 10});
  CHECK(times_in(3, 1, 3) == std::vector<double>{3, 2, 1});
  CHECK(times_in(2, 7, 1) == std::vector<double>{2});
  CHECK(times_in(-1.7e308, 1.7e308, 3) == std::vector<double>{-1.7e308, 0, 1.7e308});
  CHECK_THROWS_AS(times_in(0, 1, 0), std::invalid_argument);
  CHECK_THROWS_AS(times_in(0, 1, 1'000'000'000'000), std::invalid_argument);
}

TEST_CASE("the times lie within the interval and in its order, however short it is") {
  std::mt19937_64 random(20);
  std::uniform_real_distribution<double> place(-3, 3);
  for (int trial = 0; trial < 20000; ++trial) {
    const double t0 = place(random);
    double t1 = t0;
    for (int ulp = 0; ulp < trial % 4; ++ulp) t1 = std::nextafter(t1, 10);
    CAPTURE(trial, t0, t1);
    const auto times = times_in(t0, t1, 7);
    REQUIRE(std::is_sorted(times.begin(), times.end()));
    REQUIRE((times.front() == t0 && times.back() == t1));
  }
}

TEST_CASE("every so much, as often as it fits") {
  CHECK(times_every(0, 1, 0.25) == std::vector<double>{0, 0.25, 0.5, 0.75, 1});
  CHECK(times_every(1, 0, 0.4) == std::vector<double>{1, 1 - 0.4, 1 - 0.8});
  CHECK(times_every(0, 0.3, 0.1).size() == 4);  // 0.3/0.1 is 2.9999999999999996
  CHECK(times_every(0, 0.3, 0.1).back() == 0.3);
  CHECK(times_every(5, 5, 1) == std::vector<double>{5});
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity()}) {
    CHECK_THROWS_AS(times_every(0, 1, bad), std::invalid_argument);
  }
  CHECK_THROWS_AS(times_every(0, 1, 1e-12), std::invalid_argument);
}
