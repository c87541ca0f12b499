// Rodrigues' construction against 50 digits, closed forms, composition, and the great circles.
#include "rotation/spherical_triangle.hpp"

#include "elements.hpp"
#include "exact.hpp"

using namespace rotor;
using namespace rotor::reference;
using Kind = SphericalTriangle::Kind;

namespace {

// A product read back from its axis (each component to 0.51 ulp <= 5.7e-17, so 9.8e-17 across it)
// and its angle (in [0, 2 pi], to 4.4e-16, half of that in the quaternion): sqrt(9.8^2 + 22.2^2).
constexpr double kRounded = 2.5e-16;
// Composition, its own error on top, is to agree to this.
constexpr double kAgreement = 1e-15;
// Where p and q differ by no more than rounding, q is taken for p.
constexpr double kParallel = 2e-16;
// An arc in [0, pi] to half an ulp of pi.
constexpr double kArc = 2.3e-16;

double size(const Real& x) { return x.convert_to<double>(); }

RealQuaternion exact_product(const Rotation& first, const Rotation& second) {
  return exact_quaternion(second.axis(), second.angle()) *
         exact_quaternion(first.axis(), first.angle());
}

// The distance of p and q on the sphere.
Real exact_arc(const RealVector& p, const RealVector& q) {
  const RealVector normal = p.cross(q);
  return atan2(sqrt(normal.squaredNorm()), p.dot(q));
}

// v turned about the axis n by an angle.
RealVector turned(const RealVector& n, const Real& angle, const RealVector& v) {
  const RealVector unit_n = n / sqrt(n.squaredNorm());
  return v * cos(angle) + unit_n * (unit_n.dot(v) * (1 - cos(angle))) +
         unit_n.cross(v) * sin(angle);
}

struct Errors {
  Worst product, parallel, composition, arcs;

  void add(const Rotation& first, const Rotation& second) {
    const auto where = [&] { return described(second) + " after " + described(first); };
    const SphericalTriangle t = spherical_triangle(first, second);
    const RealQuaternion exact = exact_product(first, second);
    const RealQuaternion measured = exact_quaternion(t.product.axis(), t.product.angle());
    const RealQuaternion difference(measured.coeffs() - exact.coeffs());
    const bool has_sides = t.kind == Kind::kTriangle || t.kind == Kind::kIdentity;
    (has_sides ? product : parallel).add(size(difference.norm()), where);
    composition.add(spinor_error(t.product, second * first), where);
    const Real sine = sqrt(exact.vec().squaredNorm());
    if (t.kind != Kind::kTriangle || sine < 1e-30) return;
    // The direction of r is as good as the sums of Extended, 1e-18, are beside sin(gamma/2).
    const double slack = 1e-18 / size(sine);
    const RealVector p = exact_unit(first.axis()), q = exact_unit(second.axis());
    const RealVector r = exact.vec() / sine;
    arcs.add(size(abs(exact_arc(p, q) - t.pq)), where);
    arcs.add(size(abs(exact_arc(q, r) - t.qr)) - slack, where);
    arcs.add(size(abs(exact_arc(r, p) - t.rp)) - slack, where);
  }

  void within_bounds() const {
    product.within("product of a triangle", kRounded);
    parallel.within("product about one axis", kRounded + kParallel);
    composition.within("agreement with composition", kAgreement);
    arcs.within("arcs", kArc);
  }
};

}  // namespace

TEST_CASE("theory 5: the composition, from its triangle") {
  const SphericalTriangle t =
      spherical_triangle({{0, 0, 1}, 0.9}, {{std::sin(1.0), 0, std::cos(1.0)}, 1.4});
  CHECK(t.kind == Kind::kTriangle);
  CHECK(std::abs(t.product.angle() - 2.007127) <= 5e-7);
  CHECK((t.product.axis() - Vector(0.578763, -0.279575, 0.766075)).cwiseAbs().maxCoeff() <= 5e-7);
  CHECK(std::abs(t.pq - 1) <= kArc);
}

TEST_CASE("triangles of awkward rotations") {
  const std::uint64_t seed = 900;
  CAPTURE(seed);
  Draw draw(seed);
  Errors errors;
  const std::vector<Rotation> all = elements(40, seed);
  const auto any = [&]() -> const Rotation& {
    return all[std::size_t(draw.below(int(all.size())))];
  };
  for (int i = 0; i < 1500; ++i) {
    const Rotation& first = any();
    errors.add(first, any());
  }
  errors.within_bounds();
}

TEST_CASE("triangles of axes nearly parallel or opposite") {
  const std::uint64_t seed = 901;
  CAPTURE(seed);
  Draw draw(seed);
  Errors errors;
  for (int i = 0; i < 800; ++i) {
    const Vector p = draw.vector();
    const Vector q = (draw.below(2) == 0 ? 1 : -1) *
                     (p.normalized() + std::pow(10, draw.uniform(-17, 0)) * draw.vector());
    errors.add({p, draw.awkward_angle()}, {q, draw.awkward_angle()});
    const double angle = draw.awkward_angle();
    errors.add({p, angle}, {q, -angle});
  }
  for (double angle : {0.0, 5e-324, kPi, 2 * kPi, 7.0, -3.0, 1e15}) {
    for (double other : {0.0, 5e-324, kPi, 2 * kPi, 7.0, -3.0, 1e15}) {
      const Rotation first({0, 0, 1}, angle), second({1e-15, 0, 1}, other);
      errors.add(first, second);
      const Kind expected = angle == 0 && other == 0 ? Kind::kIdentity : Kind::kTriangle;
      CHECK(spherical_triangle(first, second).kind == expected);
    }
  }
  errors.within_bounds();
}

TEST_CASE("the two great circles meet at the axis of the product, at half its angle") {
  const std::uint64_t seed = 902;
  CAPTURE(seed);
  Draw draw(seed);
  Worst incidence, angle;
  for (int i = 0; i < 300; ++i) {
    const Rotation first = draw.rotation(), second = draw.rotation();
    const auto where = [&] { return described(second) + " after " + described(first); };
    const RealVector p = exact_unit(first.axis()), q = exact_unit(second.axis());
    const RealVector pq = p.cross(q);
    const RealVector m = pq / sqrt(pq.squaredNorm());
    const RealVector from_p = turned(p, -Real(first.angle()) / 2, m);
    const RealVector from_q = turned(q, Real(second.angle()) / 2, m);
    const Rotation product = spherical_triangle(first, second).product;
    const RealVector r = product.axis().cast<Real>();
    // r is rounded, to 9.8e-17 across and along.
    incidence.add(size(abs(r.dot(from_p))), where);
    incidence.add(size(abs(r.dot(from_q))), where);
    // Half of an angle in [0, 2 pi], to 2.2e-16.
    angle.add(size(abs(exact_arc(from_p, from_q) - Real(product.angle()) / 2)), where);
  }
  incidence.within("r on both circles", 1e-16);
  angle.within("exterior angle at r", kArc);
}

TEST_CASE("with the whole angles, as printed, the circles meet elsewhere") {
  const Rotation first({0, 0, 1}, 0.9), second({std::sin(1.0), 0, std::cos(1.0)}, 1.4);
  const RealVector p = exact_unit(first.axis()), q = exact_unit(second.axis());
  const RealVector m = p.cross(q);
  const RealVector printed = turned(p, -0.9, m).cross(turned(q, 1.4, m));
  const Real apart = exact_arc(printed, exact_product(first, second).vec());
  CHECK(std::min(size(apart), kPi - size(apart)) > 0.2);
}

TEST_CASE("closed forms: half turns, and an octant") {
  for (double c : {1e-15, 1e-8, 0.5, 1.5, 3.0}) {
    CAPTURE(c);
    // Half turns about axes c apart: by 2 c about p x q and a turn short, 2 pi - 2 c about q x p.
    // Half an ulp of the angle and of what it is compared with (4.4e-16 each), the doubles 2 pi
    // (2.5e-16) and q (2 * 1.2e-16); the double pi is 1.2e-16 short of pi, and moves r by as much
    // towards p and q, beside sin(gamma/2) = sin c.
    const SphericalTriangle t =
        spherical_triangle({{1, 0, 0}, kPi}, {{std::cos(c), std::sin(c), 0}, kPi});
    CHECK(std::abs(t.product.angle() - (2 * kPi - 2 * c)) <= 1.4e-15);
    CHECK((t.product.axis() + Vector(0, 0, 1)).norm() <= 2.5e-16 / std::sin(c));
  }
  const SphericalTriangle t = spherical_triangle({{1, 0, 0}, kPi / 2}, {{0, 1, 0}, kPi / 2});
  CHECK(std::abs(t.product.angle() - 2 * kPi / 3) <= 4.5e-16);
  CHECK((t.product.axis() - Vector(1, 1, -1) / std::sqrt(3)).norm() <= 2e-16);
  CHECK(std::abs(t.pq - kPi / 2) <= kArc);
  CHECK(std::abs(t.rp - std::acos(1 / std::sqrt(3))) <= 2 * kArc);
  CHECK(t.qr == t.rp);
}

TEST_CASE("a rotation by nothing is a vertex on the other") {
  const SphericalTriangle t = spherical_triangle({{1, 0, 0}, 0}, {{0, 1, 0}, 2.5});
  CHECK(t.kind == Kind::kTriangle);
  CHECK(t.product == Rotation({0, 1, 0}, 2.5));
  CHECK(t.qr == 0);
  CHECK(t.rp == t.pq);
}

TEST_CASE("no triangle: parallel and opposite axes, and the identity") {
  const Vector axis(1, 2, 3);
  const Vector tripled = 3 * axis;  // its unit vector may be rounded otherwise
  const SphericalTriangle parallel = spherical_triangle({axis, 1}, {tripled, 2});
  CHECK(parallel.kind == Kind::kParallel);
  CHECK(parallel.product.angle() == 3);
  CHECK((parallel.product.axis() - unit(axis)).norm() <= kParallel);
  const SphericalTriangle opposite = spherical_triangle({axis, 1}, {-tripled, 2});
  CHECK(opposite.kind == Kind::kOpposite);
  CHECK(opposite.product.angle() == 1);
  CHECK((opposite.product.axis() + unit(axis)).norm() <= kParallel);
  CHECK(spherical_triangle({axis, 7}, {axis, -7}).product == Rotation());
  const SphericalTriangle identity = spherical_triangle({{1, 0, 0}, 0}, {{0, 1, 0}, -0.0});
  CHECK(identity.kind == Kind::kIdentity);
  CHECK(identity.product == Rotation());
}

TEST_CASE("tiny rotations make triangles without underflow") {
  const SphericalTriangle t = spherical_triangle({{1, 0, 0}, 3e-300}, {{0, 1, 0}, 4e-300});
  CHECK(t.kind == Kind::kTriangle);
  CHECK(t.product.angle() == Approx(5e-300).epsilon(1e-15).margin(0));
  CHECK((t.product.axis() - Vector(0.6, 0.8, 0)).norm() <= 3e-16);
  const SphericalTriangle least = spherical_triangle({{1, 0, 0}, 5e-324}, {{0, 1, 0}, 5e-324});
  CHECK(least.product.angle() == 5e-324);
  CHECK(least.rp == Approx(kPi / 4).epsilon(1e-15));
}
