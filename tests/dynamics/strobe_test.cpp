#include "dynamics/strobe.hpp"

#include <limits>
#include <stdexcept>

#include "catch.hpp"

namespace {

using namespace rotor;
using Catch::Matchers::Contains;

Run turn(double t0, double t1) {
  return evolve({AngularVelocity(Vector(0, 0, 1)), t0, t1}, Rotation(Vector(1, 0, 0), 1));
}

}  // namespace

TEST_CASE("a strobe has the start, and a point each period after it") {
  CHECK(strobe_times(turn(0, 4200), 40).size() == 106);
  CHECK(strobe_times(turn(1, -1), 0.5) == std::vector<double>{1, 0.5, 0, -0.5, -1});
  CHECK_THROWS_WITH(strobe_times(turn(0, 1), 0), Contains("positive") && Contains("0.0"));
  CHECK_THROWS_WITH(strobe_times(turn(0, 1), 2), Contains("longer than the run"));
  const double inf = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(strobe_times(turn(0, 1), inf), std::invalid_argument);
  CHECK_THROWS_AS(strobe_times(turn(0, 1), inf - inf), std::invalid_argument);
}
