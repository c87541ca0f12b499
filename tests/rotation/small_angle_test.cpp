// The quotients that are 0/0 at angle 0 against their true values (small_angle.csv), to the bounds
// that small_angle.hpp derives.
#include "rotation/small_angle.hpp"

#include "reference.hpp"

using namespace rotor;
using namespace rotor::reference;

TEST_CASE("small-angle quotients keep their bounds") {
  const double u = std::ldexp(1, -53);
  Worst first, small, large;
  for (Row& row : table("small_angle.csv")) {
    const double angle = row.number();
    std::array<Exact, 2> exact;
    row.read(exact);
    const auto where = [&] { return text(angle); };
    const double g = std::abs(exact[0].hi), second = std::abs(exact[1].hi);
    first.add(std::abs(error(half_cot(angle), exact[0])) / g, where);
    const Extended wrong = std::abs(error(one_minus_half_cot(angle), exact[1]));
    if (std::abs(angle) <= 3) {
      small.add(wrong / second, where);
    } else {
      // 3u |g|/(1 - g) + 3u, relatively.
      large.add(wrong / (3 * g / angle / angle + 3 * second), where);
    }
  }
  first.within("g", 3 * u);
  small.within("(1 - g)/theta^2, |theta| <= 3", 8 * u);
  large.within("(1 - g)/theta^2, |theta| > 3", u);
}

TEST_CASE("small-angle quotients are even and have their limits at 0") {
  for (double angle : {0.0, 1e-300, 1e-8, 0.3, 2.9, 3.1, 7.0}) {
    CAPTURE(angle);
    CHECK(half_cot(-angle) == half_cot(angle));
    CHECK(one_minus_half_cot(-angle) == one_minus_half_cot(angle));
  }
  CHECK(half_cot(0) == 1);
  CHECK(one_minus_half_cot(0) == 1.0 / 12);
}
