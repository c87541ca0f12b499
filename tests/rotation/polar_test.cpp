// Polar form of general quaternions [N24-N26].
#include "elements.hpp"
#include "rotation/quaternion.hpp"

using namespace rotor;
using namespace rotor::reference;

TEST_CASE("polar form: norm times the rotation's quaternion is the quaternion") {
  const std::uint64_t seed = 601;
  CAPTURE(seed);
  Draw draw(seed);
  Worst worst;
  for (int i = 0; i < 5000; ++i) {
    const Vector v = draw.vector();
    const double scale = std::pow(10, draw.uniform(-290, 300));
    const Quaternion q(draw.uniform(-1, 1) * scale, v.x() * scale, v.y() * scale, v.z() * scale);
    const Polar p = polar(q);
    const Eigen::Matrix<Extended, 4, 1> again = wide(p.rotation).coeffs() * Extended(p.norm);
    worst.add((again - q.coeffs().cast<Extended>()).norm() / Extended(p.norm),
              [&] { return text(q.w()) + ", " + text(Vector(q.vec())); });
    if (p.rotation.angle() < 0 || p.rotation.angle() > 2 * kPi) {
      FAIL_CHECK("angle out of [0, 2 pi]: " << text(p.rotation.angle()));
    }
  }
  // Half an ulp of the angle (halved in the quaternion), the axis, and the norm: u.
  worst.within("relative", 4.5e-16 / 2 + 1e-16 + std::ldexp(1, -53));
}

TEST_CASE("polar form of a product: norms multiply, rotations compose") {
  const std::uint64_t seed = 602;
  CAPTURE(seed);
  Draw draw(seed);
  Worst norms, rotations;
  for (int i = 0; i < 5000; ++i) {
    Quaternion p, q;
    for (int k = 0; k < 4; ++k) {
      p.coeffs()[k] = draw.uniform(-3, 3);
      q.coeffs()[k] = draw.uniform(-3, 3);
    }
    const Polar a = polar(p), b = polar(q), c = polar(p * q);
    const auto where = [&] { return described(a.rotation) + ", " + described(b.rotation); };
    norms.add(std::abs(c.norm / (a.norm * b.norm) - 1), where);
    rotations.add(spinor_error(c.rotation, a.rotation * b.rotation), where);
  }
  // p * q in double: 8u of its norm; each of the three norms, their product and quotient another u.
  norms.within("norms", 13 * std::ldexp(1, -53));
  rotations.within("rotations", 8 * std::ldexp(1, -53) + 4 * kComposition);
}

TEST_CASE("polar form of awkward quaternions") {
  CHECK(polar({2, 0, 0, 0}).norm == 2);
  CHECK(polar({2, 0, 0, 0}).rotation == Rotation());
  CHECK(polar({-2, 0, 0, 0}).rotation.angle() == 2 * kPi);  // -1 is a full turn, not the identity
  CHECK(polar({-2, 0, 0, 0}).rotation.axis() == Vector(1, 0, 0));
  CHECK(polar({0, 0, 3, 0}).rotation == Rotation({0, 1, 0}, kPi));
  CHECK(polar({0, 0, -3, 0}).rotation == Rotation({0, -1, 0}, kPi));
  CHECK(polar({0, 5e-324, 0, 0}).norm == 5e-324);
  CHECK(polar({5e-324, 0, 0, 5e-324}).rotation == Rotation({0, 0, 1}, kPi / 2));
  CHECK(polar({1e308, 1e308, 0, 0}).norm == Approx(std::sqrt(2.0) * 1e308).epsilon(1e-15));
  CHECK(polar({1, 0, 1e-300, 0}).rotation == Rotation({0, 1, 0}, 2e-300));
}
