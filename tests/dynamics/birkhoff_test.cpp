#include "dynamics/birkhoff.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "catch.hpp"

namespace {

using namespace rotor;
using Catch::Matchers::Contains;

// cos(k x) + cos(2 k x + 1) + 3 with the golden k: the mean over all x is 3.
std::vector<double> quasiperiodic(int n) {
  std::vector<double> samples;
  for (int i = 0; i < n; ++i) {
    const double x = 2 * std::numbers::pi * i / std::numbers::phi;
    samples.push_back(3 + std::cos(x) + std::cos(2 * x + 1));
  }
  return samples;
}

}  // namespace

TEST_CASE("an average of a constant is that, and of a line its middle") {
  const Average one = birkhoff(std::vector<double>(7, 0.1));
  CHECK(one.plain == 0.1);
  CHECK(std::abs(one.weighted - 0.1) <= 1e-16);
  CHECK(one.plain_error == 0);
  std::vector<double> line;
  for (int i = 0; i < 100; ++i) line.push_back(i);
  const Average middle = birkhoff(line);
  CHECK(middle.plain == 49.5);
  // The weights are symmetric: their rounding is all, 100 of them of some 1e-16 of 50.
  CHECK(std::abs(middle.weighted - 49.5) < 1e-12);
  CHECK(std::abs(middle.weighted_error - 50) < 1e-12);
  CHECK(middle.plain_error == 50);
}

TEST_CASE("the weights are those of exp(-1/(s (1 - s)))") {
  // The integral of w s^2 over that of w, by mpmath with 30 digits. The rule of middles of a w that
  // ends flat errs by less than any power of 1/n.
  std::vector<double> squares;
  constexpr int kCount = 200;
  for (int i = 0; i < kCount; ++i) squares.push_back(std::pow((i + 0.5) / kCount, 2));
  CHECK(std::abs(birkhoff(squares).weighted - 0.269124230013873457) < 1e-15);
}

TEST_CASE("weighted averages of a quasiperiodic motion come to more digits than plain ones") {
  const Average average = birkhoff(quasiperiodic(10000));
  // |sum of cos(k x)| <= 1/|sin(k/2)|, here of 1.1 and 1.4 in all 2.5.
  CHECK(std::abs(average.plain - 3) < 2.6e-4);
  CHECK(std::abs(average.plain - 3) > 1e-6);
  // k x, up to 8e4, is rounded to 7e-12 at most.
  CHECK(std::abs(average.weighted - 3) < 7e-12);
  CHECK(average.weighted_error < 14e-12);
  CHECK(average.plain_error > std::abs(average.plain - 3) / 10);
}

TEST_CASE("the average of a rate takes stretches by their lengths, forward and backward") {
  const std::vector<double> t = {0, 1, 3, 3.5, 7};
  const std::vector<double> sum = {1, 3, 7, 8, 15};
  const Average rate = birkhoff_rate(t, sum);
  CHECK(rate.plain == 2);
  CHECK(std::abs(rate.weighted - 2) < 1e-15);
  CHECK(rate.plain_error == 0);
  const std::vector<double> back = {0, -1, -3, -3.5, -7};
  CHECK(birkhoff_rate(back, sum).plain == 2);
  CHECK(std::abs(birkhoff_rate(back, sum).weighted - 2) < 1e-15);
}

TEST_CASE("averages refuse what has none") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(birkhoff(std::vector<double>{1}), Contains("at least 2 samples, got 1"));
  CHECK_THROWS_WITH(birkhoff(std::vector<double>{1, 2, nan}), Contains("nan as sample 3"));
  CHECK_THROWS_WITH(birkhoff_rate(std::vector<double>{0, 1}, std::vector<double>{0, 1}),
                    Contains("at least 3"));
  CHECK_THROWS_WITH(birkhoff_rate(std::vector<double>{0, 1, 2}, std::vector<double>{0, 1}),
                    Contains("2 sums and 3 times"));
  CHECK_THROWS_WITH(birkhoff_rate(std::vector<double>{0, 1, 2}, std::vector<double>{0, 1, 1 / nan}),
                    Contains("nan"));
}
