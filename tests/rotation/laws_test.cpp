// The laws of the group and of its action, over awkward and random elements. A tolerance is the sum
// of the promises used on the way: kComposition for every product (unit quaternions move nothing
// that is multiplied by them, so earlier errors arrive unenlarged), and what is said beside it.
#include "elements.hpp"
#include "exact.hpp"

using namespace rotor;
using namespace rotor::reference;

namespace {

// |R*v - true| / |v|. An axis error d (three components, each half an ulp of at most 2^-53:
// 0.98e-16) changes n (n.v)(1 - cos) + (n x v) sin by at most d (2 (1 - cos) + sin) <= 4.24 d;
// rounding the three components adds 2^-53: 5.3e-16 together.
constexpr double kAction = 5.4e-16;

std::string both(const Rotation& r, const Rotation& s) {
  return described(r) + ", " + described(s);
}

template <class Law>
void for_pairs(const Law& law) {
  const auto all = elements(60, 201);
  for (const Rotation& r : all)
    for (const Rotation& s : all) law(r, s);
}

}  // namespace

TEST_CASE("identity, inverse, and the form of a product") {
  Worst left, right, form;
  const Rotation one;
  for (const Rotation& r : elements(1000, 202)) {
    const auto where = [&] { return described(r); };
    left.add(spinor_error(one * r, r), where);
    right.add(spinor_error(r * one, r), where);
    form.add(std::abs(norm((one * r).axis()) - 1), where);
    INFO(where());
    CHECK(r.inverse().angle() == -r.angle());
    CHECK(r.inverse().axis() == r.axis());
    CHECK(r.inverse().inverse() == r);
    CHECK((r * r).angle() >= 0);
    CHECK((r * r).angle() <= 2 * kPi);
  }
  left.within("1 R = R", kComposition);
  right.within("R 1 = R", kComposition);
  form.within("|axis| = 1", kAxis);
}

TEST_CASE("the inverse of a product") {
  Worst worst;
  for_pairs([&](const Rotation& r, const Rotation& s) {
    worst.add(spinor_error((r * s).inverse(), s.inverse() * r.inverse()),
              [&] { return both(r, s); });
  });
  worst.within("(R S)^-1 = S^-1 R^-1", 2 * kComposition);
}

TEST_CASE("associativity") {
  const std::uint64_t seed = 203;
  CAPTURE(seed);
  const auto all = elements(60, seed);
  Draw draw(seed);
  const auto any = [&]() -> const Rotation& {
    return all[std::size_t(draw.below(int(all.size())))];
  };
  Worst worst;
  for (int i = 0; i < 50000; ++i) {
    const Rotation &a = any(), &b = any(), &c = any();
    worst.add(spinor_error((a * b) * c, a * (b * c)),
              [&] { return both(a, b) + ", " + described(c); });
  }
  worst.within("(A B) C = A (B C)", 4 * kComposition);
}

TEST_CASE("composition is the product of quaternions and of matrices") {
  // Products in double: a quaternion component is four products, off by 4u sum |p_i q_j| <= 4u, the
  // vector of four by 8u; a matrix entry by 3u |row||column|, the nine by 9u. An operator is off
  // from the quaternion by 2 sqrt(2) in the Frobenius norm.
  const double u = std::ldexp(1, -53);
  Worst quaternions, matrices;
  for_pairs([&](const Rotation& r, const Rotation& s) {
    const auto where = [&] { return both(r, s); };
    const Rotation product = r * s;
    const Quaternion q = r.quaternion() * s.quaternion();
    quaternions.add((q.coeffs() - product.quaternion().coeffs()).norm(), where);
    matrices.add((r.matrix() * s.matrix() - product.matrix()).norm(), where);
  });
  quaternions.within("quaternions", kComposition + 3 * kQuaternion + 8 * u);
  matrices.within("matrices", 2 * std::sqrt(2.0) * kComposition + 3 * kMatrix + 9 * u);
}

TEST_CASE("action on a vector against 50 digits") {
  const std::uint64_t seed = 204;
  CAPTURE(seed);
  Draw draw(seed);
  Worst worst;
  for (int i = 0; i < 10000; ++i) {
    const Vector axis = draw.awkward_axis();
    const double angle = draw.awkward_angle();
    const Vector v = draw.vector() * std::pow(10, draw.uniform(-290, 290));
    const auto exact = split<3>(exact_action(exact_quaternion(axis, angle), v));
    worst.add(errors(Rotation(axis, angle) * v, exact).norm() / Extended(norm(v)),
              [&] { return described(axis, angle) + " on " + text(v); });
  }
  worst.within("|R v - true|/|v|", kAction);
}

TEST_CASE("action: a homomorphism that keeps lengths and the axis") {
  const Vector v(0.6, -1.1, 0.4);
  Worst homomorphism, matrix, length, axis, back;
  for_pairs([&](const Rotation& r, const Rotation& s) {
    homomorphism.add((r * (s * v) - (r * s) * v).norm() / v.norm(), [&] { return both(r, s); });
  });
  for (const Rotation& r : elements(1000, 205)) {
    const auto where = [&] { return described(r); };
    matrix.add((r * v - r.matrix() * v).norm() / v.norm(), where);
    length.add(std::abs(norm(r * v) - norm(v)) / v.norm(), where);
    axis.add((r * r.axis() - r.axis()).norm(), where);
    back.add((r.inverse() * (r * v) - v).norm() / v.norm(), where);
  }
  // An error of the quaternion moves a vector by at most twice as much.
  homomorphism.within("R (S v) = (R S) v", 3 * kAction + 2 * kComposition);
  // The product in double: 3u |row||v| a component, 6u |v| together.
  matrix.within("R v = matrix v", kAction + kMatrix + 6 * std::ldexp(1, -53));
  length.within("|R v| = |v|", 2 * kAction);
  axis.within("R n = n", kAction);
  back.within("R^-1 R v = v", 2 * kAction);
}

TEST_CASE("action on vectors of extreme length") {
  const Rotation quarter({0, 0, 1}, kPi / 2);
  CHECK((quarter * Vector(1.7e308, 0, 1.7e308)).isApprox(Vector(0, 1.7e308, 1.7e308), 1e-15));
  CHECK(quarter * Vector(5e-324, 0, 0) == Vector(0, 5e-324, 0));
  CHECK(quarter * Vector::Zero() == Vector::Zero());
}

TEST_CASE("powers") {
  Worst square, root;
  for (const Rotation& r : elements(1000, 206)) {
    const auto where = [&] { return described(r); };
    INFO(where());
    CHECK(r.power(1) == r);
    CHECK(r.power(-1) == r.inverse());
    CHECK(r.power(0).angle() == 0);
    CHECK(r.power(3).axis() == r.axis());
    CHECK(r.power(0.3).angle() == r.angle() * 0.3);
    square.add(spinor_error(r.power(2), r * r), where);
    root.add(spinor_error(r.power(0.5) * r.power(0.5), r), where);
  }
  square.within("R^2 = R R", kComposition);
  root.within("R^0.5 R^0.5 = R", kComposition);
}

TEST_CASE("powers add") {
  const std::uint64_t seed = 207;
  CAPTURE(seed);
  Draw draw(seed);
  Worst worst;
  for (int i = 0; i < 2000; ++i) {
    const Rotation r = draw.rotation();
    const double x = draw.uniform(-2, 2), y = draw.uniform(-2, 2);
    // The angles theta x, theta y and theta (x + y) are rounded, x + y too; half of it is in the
    // quaternion.
    const double angle = std::abs(r.angle()), z = x + y;
    const double rounding =
        (ulp(angle * x) + ulp(angle * y) + ulp(angle * z) + angle * ulp(z)) / 2 / 2;
    worst.add(spinor_error(r.power(x) * r.power(y), r.power(z)) / Extended(kComposition + rounding),
              [&] { return described(r) + ", " + text(x) + ", " + text(y); });
  }
  worst.within("R^x R^y = R^(x+y), error over tolerance", 1);
}
