// N3's rule: the operator's own rotation.
#include "elements.hpp"
#include "exact.hpp"

using namespace rotor;
using namespace rotor::reference;

namespace {

bool last_non_zero_is_positive(const Vector& n) {
  for (int i = 2; i >= 0; --i)
    if (n[i] != 0) return n[i] > 0;
  return false;
}

}  // namespace

TEST_CASE("canonical keeps the operator, in [0, pi], and is idempotent") {
  Worst worst, opposite;
  for (const Rotation& r : elements(1000, 401)) {
    const Rotation c = r.canonical();
    const auto where = [&] { return described(r); };
    worst.add(operator_error(c, r), where);
    INFO(where());
    CHECK(c.angle() >= 0);
    CHECK(c.angle() <= kPi);
    CHECK(c.canonical() == c);
    opposite.add(operator_error(Rotation(-r.axis(), -r.angle()).canonical(), c), where);
    CHECK(from_matrix(r.matrix()).canonical() == from_matrix(r.matrix()));
  }
  // A half turn may have been an ulp of pi away, and turning its axis over costs twice what the
  // nearest double falls short of pi (1.23e-16); the axis is rounded again (0.98e-16, moved twice
  // that).
  worst.within("canonical, rad", ulp(kPi) + 2.5e-16 + 2e-16);
  opposite.within("(-n, -theta), rad", ulp(kPi) + 2 * 2e-16);
}

TEST_CASE("canonical angle and axis of random rotations") {
  const std::uint64_t seed = 402;
  CAPTURE(seed);
  Draw draw(seed);
  Worst angle, axis;
  for (int i = 0; i < 3000; ++i) {
    const Rotation r(draw.awkward_axis(), draw.awkward_angle());
    const RealQuaternion q = exact_quaternion(r.axis(), r.angle());
    const Real half_sine = sqrt(q.vec().squaredNorm());
    const double size = Real(2 * atan2(half_sine, Real(abs(q.w())))).convert_to<double>();
    const Rotation c = r.canonical();
    const auto where = [&] { return described(r); };
    if (size > kPi - 1e-15) {
      INFO(where());
      CHECK(c.angle() >= kPi - 1e-15);
      continue;
    }
    if (size == 0) continue;
    angle.add(std::abs(c.angle() - size) / ulp(size), where);
    const double sign = q.w() < 0 ? -1 : 1;
    axis.add(errors(c.axis(), split<3>(RealVector(q.vec() * Real(sign / half_sine)))).norm(),
             where);
  }
  angle.within("angle, ulp", 1);
  axis.within("axis", kAxis);
}

TEST_CASE("canonical half turns: the last non-zero component is positive") {
  const double below = std::nextafter(kPi, 0), above = std::nextafter(kPi, 4);
  for (double angle : {kPi, -kPi, below, -below, above, -above}) {
    for (int code = 1; code < 27; ++code) {
      const Vector axis(code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1);
      if (axis.isZero(0)) continue;
      const Rotation c = Rotation(axis, angle).canonical();
      INFO(described(axis, angle));
      CHECK(c.angle() == kPi);
      CHECK(last_non_zero_is_positive(c.axis()));
      const Vector n = unit(axis);
      CHECK((c.axis() == n || c.axis() == -n));
      CHECK(Rotation(-axis, angle).canonical() == c);
    }
  }
}

TEST_CASE("canonical half turns: a component of any size counts") {
  const auto axis_of = [](double x, double y, double z) {
    return Rotation({x, y, z}, kPi).canonical().axis();
  };
  CHECK(axis_of(1, 0, -1e-200) == Vector(-1, 0, 1e-200));
  CHECK(axis_of(1, -5e-324, 0) == Vector(-1, 5e-324, 0));
  CHECK(axis_of(-1, 0, 1e-200) == Vector(-1, 0, 1e-200));
  CHECK(axis_of(-1, 0, -0.0) == Vector(1, 0, 0));
}

TEST_CASE("canonical: close to a half turn is not a half turn") {
  const Vector down(0, 0, -1);
  CHECK(Rotation(down, kPi - 1e-9).canonical() == Rotation(down, kPi - 1e-9));
  const Rotation beyond = Rotation(down, kPi + 1e-9).canonical();
  CHECK(beyond.axis() == -down);
  CHECK(beyond.angle() == Approx(kPi - 1e-9).epsilon(1e-15));
  const double three_ulp_less = kPi - 3 * ulp(kPi);
  CHECK(Rotation(down, three_ulp_less).canonical() == Rotation(down, three_ulp_less));
}

TEST_CASE("canonical at and near the identity") {
  const Vector n(0, 0, -1);
  CHECK(Rotation(n, 0).canonical() == Rotation());
  CHECK(Rotation(n, -0.0).canonical() == Rotation());
  CHECK(Rotation(n, 5e-324).canonical() == Rotation(n, 5e-324));
  CHECK(Rotation(n, -1e-300).canonical() == Rotation(-n, 1e-300));
  // The doubles nearest 2 pi and 4 pi fall short by 2.4492935982947064e-16 and twice that.
  CHECK(Rotation(n, 2 * kPi).canonical().axis() == -n);
  CHECK(Rotation(n, 2 * kPi).canonical().angle() ==
        Approx(2.4492935982947064e-16).epsilon(0).margin(0));
  CHECK(Rotation(n, 4 * kPi).canonical().angle() ==
        Approx(4.8985871965894128e-16).epsilon(0).margin(0));
  CHECK(Rotation(n, -2 * kPi).canonical().axis() == n);
}
