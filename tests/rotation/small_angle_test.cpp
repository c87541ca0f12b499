// The quotients that are 0/0 at angle 0 against their true values (small_angle.csv), to the bounds
// that small_angle.hpp derives.
#include "rotation/small_angle.hpp"

#include "reference.hpp"

using namespace rotor;
using namespace rotor::reference;

namespace {

// Half an ulp in extended precision; the table is good to half of that.
const Extended kU = std::ldexp(1.0L, -64);

Extended wrong(Extended measured, const Exact& exact) {
  return std::abs((measured - exact.hi) - exact.lo);
}

}  // namespace

TEST_CASE("small-angle quotients keep their bounds") {
  Worst sine, cosine, third, first, small, large;
  for (Row& row : table("rotation/small_angle.csv")) {
    const double angle = row.number();
    std::array<Exact, 5> exact;
    row.read(exact);
    const auto where = [&] { return text(angle); };
    const auto relative = [&](Extended measured, std::size_t i) {
      return wrong(measured, exact[i]) / std::abs(Extended{exact[i].hi});
    };
    sine.add(relative(sinc(angle), 0), where);
    if (std::abs(angle) < 1e100) {  // the second and third power are beyond double otherwise
      cosine.add(relative(one_minus_cos(angle), 1), where);
      third.add(relative(angle_minus_sin(angle), 2), where);
    }
    first.add(relative(half_cot(angle), 3), where);
    const Extended g = std::abs(Extended{exact[3].hi}), second = std::abs(Extended{exact[4].hi});
    const Extended off = wrong(one_minus_half_cot(angle), exact[4]);
    if (std::abs(angle) <= 3) {
      small.add(off / second, where);
    } else if (std::abs(angle) < 1e100) {
      large.add(off / (5 * g / angle / angle + 3 * second), where);
    }
  }
  const auto u = static_cast<double>(kU);
  sine.within("sin/theta", 5.5 * u);
  cosine.within("(1 - cos)/theta^2", 11.5 * u);
  third.within("(theta - sin)/theta^3", 12.5 * u);
  first.within("g", 5.5 * u);
  small.within("(1 - g)/theta^2, |theta| <= 3", 26.5 * u);
  large.within("(1 - g)/theta^2, |theta| > 3", 1.2 * u);
}

TEST_CASE("small-angle quotients are even and have their limits at 0") {
  for (double angle : {0.0, 1e-300, 1e-8, 0.3, 1.5, 1.6, 2.9, 3.1, 7.0}) {
    CAPTURE(angle);
    for (const auto quotient :
         {sinc, one_minus_cos, angle_minus_sin, half_cot, one_minus_half_cot}) {
      CHECK(quotient(-angle) == quotient(angle));
    }
  }
  CHECK(sinc(0) == 1);
  CHECK(one_minus_cos(0) == 0.5L);
  CHECK(angle_minus_sin(0) == 1.0L / 6);
  CHECK(half_cot(0) == 1);
  CHECK(static_cast<double>(one_minus_half_cot(0)) == 1.0 / 12);
}
