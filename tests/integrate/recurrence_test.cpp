// The steps of an angle that come near a multiple of pi, against trying them all.
#include "integrate/recurrence.hpp"

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include "catch.hpp"

namespace {

using rotor::Extended;
using rotor::near_multiples_of_pi;

constexpr Extended kPi = std::numbers::pi_v<Extended>;

std::vector<std::uint64_t> by_trying(Extended step, Extended offset, Extended width,
                                     std::uint64_t last) {
  std::vector<std::uint64_t> found;
  for (std::uint64_t k = 0; k <= last; ++k) {
    const Extended angle = offset + static_cast<Extended>(k) * step;
    if (std::abs(std::remainder(angle, kPi)) <= width) found.push_back(k);
  }
  return found;
}

}  // namespace

TEST_CASE("the steps that come near a multiple of pi are those that trying them all finds") {
  std::mt19937_64 random(5);
  INFO("seed 5");
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int trial = 0; trial < 300; ++trial) {
    // Steps of all sizes, widths from a half of everything down to none.
    const Extended step =
        uniform(random) * std::pow(10.0, -trial % 7) * (trial % 11 == 0 ? 100 : 1);
    const Extended offset = 10 * uniform(random);
    const Extended width = std::pow(10.0, -trial % 5 / 2.0) * 1.5;
    CAPTURE(trial, static_cast<double>(step), static_cast<double>(offset),
            static_cast<double>(width));
    CHECK(near_multiples_of_pi(step, offset, width, 2000) == by_trying(step, offset, width, 2000));
  }
  // A step that is part of pi, and none at all.
  CHECK(near_multiples_of_pi(kPi / 7, 0.1L, 0.1001L, 20) == std::vector<std::uint64_t>{0, 7, 14});
  CHECK(near_multiples_of_pi(0, 0.1L, 0.2L, 3) == std::vector<std::uint64_t>{0, 1, 2, 3});
  CHECK(near_multiples_of_pi(0, 0.1L, 0.05L, 1'000'000'000'000).empty());
}

TEST_CASE("steps far apart are found without those between") {
  // Of the golden section: near pi at the Fibonacci numbers. 0 < F(n) phi - F(n+1) or so < 1/F(n).
  const Extended step = kPi * (std::numbers::phi_v<Extended> - 1);
  for (const std::uint64_t k : near_multiples_of_pi(step, 0, 1e-9L, 10'000'000'000)) {
    if (k == 0) continue;
    CHECK(std::abs(std::remainder(static_cast<Extended>(k) * step, kPi)) < 2e-8L);
  }
  const auto found = near_multiples_of_pi(step, 0, 1e-8L, 300'000'000);
  // pi / (sqrt 5 F) is how near F comes: F from 1.4e8 on. 165580141 and 267914296 are F(41), F(42).
  REQUIRE(found.size() == 3);
  CHECK(found[1] == 165580141);
  CHECK(found[2] == 267914296);
  CHECK_THROWS_AS(near_multiples_of_pi(step, 0, 0.1L, 1'000'000'000'000), std::length_error);
}
