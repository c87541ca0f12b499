// Angular velocity, rates of axis and angle, and Jacobians of the exponential map against
// rates.csv and jacobians.csv, and the laws that join them.
#include "rotation/kinematics.hpp"

#include "elements.hpp"
#include "refusal.hpp"

using namespace rotor;
using namespace rotor::reference;

namespace {

const Extended kU = std::ldexp(1.0L, -64);
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

// The part of v perpendicular to the axis, rounded once.
Vector perpendicular(const Rotation& r, const Vector& v) {
  const ExtendedVector u = r.axis().cast<Extended>(), w = v.cast<Extended>();
  return (w - u * (u.dot(w) / u.squaredNorm())).cast<double>();
}

}  // namespace

TEST_CASE("N15 against the derivative of the quaternion") {
  // The axis of a rotation is rounded, by at most d = 1.14e-16: that turns the terms of size
  // |theta'| and 2|u'|, and adds up to 2d|u'| along u in taking off what is parallel, times
  // |sin| + |1 - cos| < 2.5. The result is rounded, by sqrt(3) half-ulps of its largest component.
  Worst worst;
  for (Row& row : table("rotation/rates.csv")) {
    const Vector axis = row.vector();
    const double angle = row.number(), angle_rate = row.number();
    const Vector rate = row.vector();
    std::array<Exact, 3> exact;
    row.read(exact);
    const Vector omega = angular_velocity({axis, angle}, angle_rate, rate);
    const Extended size = std::abs(Extended{angle_rate}) + 7 * Extended{norm(rate)};
    const Extended bound = 1.14e-16L * size + 0.87L * ulp(norm(omega));
    worst.add(errors(omega, exact).norm() / bound,
              [&] { return described(axis, angle) + " axis_rate " + text(rate); });
  }
  worst.within("omega over its bound", 1);
}

TEST_CASE("P5 inverts N15, also beside full turns") {
  Draw draw(50);
  Worst angle_rates, axis_rates;
  for (int i = 0; i < 20000; ++i) {
    const Rotation r(draw.vector(), draw.awkward_angle());
    const double half_sine = std::abs(std::sin(r.angle() / 2));
    if (half_sine < 1e-5) continue;  // full turns have their own test
    const double angle_rate = draw.uniform(-2, 2);
    const Vector rate = perpendicular(r, draw.vector());
    const RotationRates back = rotation_rates(r, angular_velocity(r, angle_rate, rate));
    REQUIRE_FALSE(back.jump);
    CHECK(back.axis == r.axis());
    // omega is rounded, by at most 1.5e-16 |omega|; the axis rate is what is across the axis times
    // sqrt(1 + cot^2)/2 = 1/(2|sin|), and the axis as above.
    const double size = std::abs(angle_rate) + 2 * half_sine * rate.norm();
    const auto where = [&] { return described(r) + " axis_rate " + text(rate); };
    angle_rates.add(std::abs(back.angle_rate - angle_rate) / (5e-16 * size), where);
    axis_rates.add((back.axis_rate - rate).norm() /
                       (3e-16 * (size / half_sine + rate.norm()) + 5e-16 * rate.norm()),
                   where);
  }
  angle_rates.within("angle rate over its bound", 1);
  axis_rates.within("axis rate over its bound", 1);
}

TEST_CASE("at a full turn the axis stays if omega is along it, else it jumps to omega") {
  Draw draw(51);
  for (const double turns : {0.0, 1.0, -1.0, 2.0, -3.0, 7.0, 1000.0, 1e6}) {
    for (int i = 0; i < 200; ++i) {
      const Rotation r(draw.vector(), turns * 2 * kPi);
      const Vector omega = draw.vector() * std::pow(10, draw.uniform(-200, 200));
      CAPTURE(turns, i, described(r), omega.transpose());
      const RotationRates jumped = rotation_rates(r, omega);
      CHECK(jumped.jump);
      CHECK(jumped.axis == unit(omega));
      CHECK(jumped.angle_rate == norm(omega));
      CHECK(jumped.axis_rate == Vector(0, 0, 0));
      for (const double rate : {0.0, 0.3, -1.7, 1e-200, -1e300}) {
        const RotationRates kept = rotation_rates(r, rate * r.axis());
        CAPTURE(rate);
        CHECK_FALSE(kept.jump);
        CHECK(kept.axis == r.axis());
        CHECK(std::abs(kept.angle_rate - rate) <= 2 * kEpsilon * std::abs(rate));
        CHECK(kept.axis_rate == Vector(0, 0, 0));
      }
    }
  }
  // Beside it P5 holds: the axis moves, as fast as it must.
  for (const double off : {1e-14, -1e-14, 1e-6}) {
    const RotationRates beside = rotation_rates({{0, 0, 1}, 2 * kPi + off}, {1, 0, 0});
    const Extended half = (Extended{2 * kPi + off} - 2 * kPi - 2.44929359829470635e-16L) / 2;
    CAPTURE(off);
    CHECK_FALSE(beside.jump);
    CHECK(beside.axis_rate.x() == Approx(double(1 / std::tan(half) / 2)).epsilon(1e-12));
    CHECK(beside.axis_rate.y() == -0.5);  // i x k / 2
  }
  CHECK_FALSE(rotation_rates({{0, 0, 1}, 5e-324}, {1, 0, 0}).jump);
  CHECK(rotation_rates({{0, 0, 1}, 5e-324}, {0, 0, 1}).axis_rate == Vector(0, 0, 0));
  CHECK_FALSE(rotation_rates({{0, 0, 1}, 1e22}, {1, 0, 0}).jump);
}

TEST_CASE("Jacobians against the power series of exp and its inverse") {
  // The rounding of an entry; in extended precision, with quotients good to 26u, some 50u of the
  // largest entry; and what the rounding of the length, 2u theta, does to the quotient of the
  // inverse: g changes by theta/(4 sin^2(theta/2)) of it.
  Worst left, inverse;
  for (Row& row : table("rotation/jacobians.csv")) {
    const Vector v = row.vector();
    std::array<Exact, 9> j, j_inverse;
    row.read(j);
    row.read(j_inverse);
    const auto check = [&](Worst& worst, const Matrix& m, const std::array<Exact, 9>& exact,
                           Extended more) {
      Extended largest = 0;
      for (const Exact& e : exact) largest = std::max(largest, std::abs(Extended{e.hi}));
      for (int i = 0; i < 9; ++i) {
        const Exact& e = exact[std::size_t(i)];
        worst.add(std::abs(error(entries(m)[i], e)) / (ulp(e.hi) / 2 + kU * (50 * largest + more)),
                  [&] { return text(v) + " entry " + std::to_string(i); });
      }
    };
    const Extended theta = v.cast<Extended>().norm(), sine = std::sin(theta / 2);
    check(left, left_jacobian(v), j, 0);
    check(inverse, left_jacobian_inverse(v), j_inverse,
          theta == 0 ? 0 : theta * theta / (2 * sine * sine));
  }
  left.within("J_l over its bound", 1);
  inverse.within("J_l^-1 over its bound", 1);
}

TEST_CASE("J_l(E) = R J_r(E), J_r(E) = J_l(-E), and the inverses invert") {
  Draw draw(52);
  for (int i = 0; i < 2000; ++i) {
    const Vector e = 6 * draw.vector() * std::pow(10, draw.uniform(-9, 0));
    const Matrix left = left_jacobian(e), right = right_jacobian(e);
    CAPTURE(i, e.transpose());
    // Products of matrices with entries of at most 1, each rounded: some 3 (2^-53 + 2^-53) + 3u.
    CHECK((left - from_euler_vector(e).matrix() * right).cwiseAbs().maxCoeff() < 9e-16);
    CHECK(right == left_jacobian(-e));
    CHECK(right == left.transpose());
    CHECK(right_jacobian_inverse(e) == left_jacobian_inverse(-e));
    if (std::abs(e.norm() - 2 * kPi) < 1e-3) continue;
    const Matrix inverse = left_jacobian_inverse(e);
    const double size = inverse.cwiseAbs().maxCoeff();
    CHECK((left * inverse - Matrix::Identity()).cwiseAbs().maxCoeff() <
          9e-16 * std::max(1.0, size));
  }
}

TEST_CASE("J_l(E) E' is the angular velocity of axis and angle") {
  // E = theta u: E' = theta' u + theta u'.
  Draw draw(53);
  for (int i = 0; i < 2000; ++i) {
    const Rotation r(draw.vector(), draw.uniform(-9, 9));
    const double angle_rate = draw.uniform(-2, 2);
    const Vector rate = perpendicular(r, draw.vector());
    const Vector euler_rate = angle_rate * r.axis() + r.angle() * rate;
    const Vector omega = angular_velocity(r, angle_rate, rate);
    CAPTURE(i, described(r));
    // Everything is of size |E'| <= 20, with a handful of roundings.
    CHECK((left_jacobian(r.euler_vector()) * euler_rate - omega).norm() < 20 * 5 * kEpsilon);
    CHECK((right_jacobian(r.euler_vector()) * euler_rate - r.inverse() * omega).norm() <
          20 * 5 * kEpsilon);
  }
}

TEST_CASE("the inverse Jacobian is refused at full turns, and finite beside them") {
  Draw draw(54);
  for (const double turns : {1.0, 2.0, 7.0, 1000.0}) {
    for (int i = 0; i < 200; ++i) {
      const Vector v = Rotation(draw.vector(), turns * 2 * kPi).euler_vector();
      CAPTURE(turns, v.transpose());
      refused([&] { left_jacobian_inverse(v); },
              {"left_jacobian_inverse", "2 pi", text(v), "length"});
      refused([&] { right_jacobian_inverse(v); }, {"right_jacobian_inverse", text(v)});
      CHECK(left_jacobian_inverse(v * (1 + 1e-14)).allFinite());
    }
  }
  CHECK(left_jacobian_inverse({0, 0, 0}) == Matrix::Identity());
  CHECK(left_jacobian_inverse({0, 0, 1e16}).allFinite());
  refused([] { left_jacobian_inverse({1e300, 0, 1e300}); }, {"at most 1e+16", "1e+300"});
  CHECK(left_jacobian({0, 0, 0}) == Matrix::Identity());
}

TEST_CASE("refused: rates without value, and an axis rate along the axis") {
  const Rotation r({0, 0, 2}, 1);
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    const Vector v(0, bad, 0);
    CAPTURE(bad);
    refused([&] { angular_velocity(r, bad, {0, 0, 0}); }, {"angle_rate", text(bad)});
    refused([&] { angular_velocity(r, 0, v); }, {"axis_rate", text(v)});
    refused([&] { rotation_rates(r, v); }, {"rotation_rates", text(v)});
    refused([&] { left_jacobian(v); }, {"left_jacobian", text(v)});
    refused([&] { right_jacobian(v); }, {"right_jacobian", text(v)});
    refused([&] { left_jacobian_inverse(v); }, {"left_jacobian_inverse", text(v)});
    refused([&] { right_jacobian_inverse(v); }, {"right_jacobian_inverse", text(v)});
  }
  refused(
      [&] {
        angular_velocity(r, 0, {1, 0, 2e-6});
      },
      {"perpendicular", "(0.0, 0.0, 1.0)", "(1.0, 0.0, 2e-06)", "2e-06 along"});
  refused([&] { angular_velocity(r, 0, {0, 0, -3}); }, {"-3.0 along"});
  // What is accepted counts as perpendicular.
  CHECK(angular_velocity(r, 0, {1, 0, 9e-7}) == angular_velocity(r, 0, {1, 0, 0}));
}

TEST_CASE("the shadow MRP is the same operator the other way round") {
  Draw draw(55);
  Worst values;
  for (int i = 0; i < 3000; ++i) {
    const Rotation r(draw.vector(), draw.awkward_angle());
    const Vector shadow = r.shadow_mrp();
    if (!shadow.allFinite() || r.angle() == 0) continue;
    // -n cot(theta/4) = -mrp/|mrp|^2: each is rounded once.
    const ExtendedVector p = r.mrp().cast<Extended>();
    if (!p.allFinite() || p.norm() < 1e-300L) continue;  // subnormal components are rounded more
    const ExtendedVector expected = -p / p.squaredNorm();
    values.add((shadow.cast<Extended>() - expected).norm() / expected.norm(),
               [&] { return described(r); });
    if (norm(shadow) > 1e8) continue;  // then from_mrp has lost the small angle, not the operator
    within(operator_error(from_mrp(shadow), r), 2e-15);
  }
  // mrp: relatively 1.12e-16 componentwise, twice in the quotient and once along; shadow once. The
  // axis rounded the same way in both.
  values.within("shadow and inversion of the MRP", 4.5e-16);
  const double inf = HUGE_VAL;
  CHECK(Rotation({0, 0, 1}, kPi).shadow_mrp() == Vector(0, 0, -1));
  CHECK(Rotation({0, 0, 1}, 0).shadow_mrp() == Vector(0, 0, -inf));
  CHECK(Rotation({0, 0, 1}, -0.0).shadow_mrp() == Vector(0, 0, inf));
  CHECK(Rotation({0, -1, 0}, 5e-324).shadow_mrp() == Vector(0, inf, 0));
  CHECK(Rotation({0, 1, 0}, 2 * kPi).shadow_mrp().norm() < 1e-16);
}
