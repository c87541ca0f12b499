#include "integrate/equation.hpp"

#include <cmath>
#include <random>

#include "catch.hpp"
#include "closed_forms.hpp"

namespace {

using namespace rotor;
using Value = QuaternionEquation::Value;

struct Random {
  std::mt19937 generator{15};
  std::uniform_real_distribution<double> uniform{-1, 1};
  double operator()() { return uniform(generator); }
  Vector vector() { return Vector((*this)(), (*this)(), (*this)()); }
  Value quaternion() { return Value((*this)(), (*this)(), (*this)(), (*this)()).normalized(); }
};

}  // namespace

TEST_CASE("the rate of the quaternion is half the product omega q") {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    CAPTURE(i);
    const Vector omega = random.vector();
    const Value q = random.quaternion();
    const Quaternion product = Quaternion(0, omega.x(), omega.y(), omega.z()) * Quaternion(q);
    // Sums of four products below 1: each side errs by less than 8u.
    CHECK((QuaternionEquation::rate(omega, q) - 0.5 * product.coeffs()).norm() < 2e-15);
  }
}

TEST_CASE("the rate of the quaternion is the derivative of a turn") {
  Random random;
  constexpr Extended d = 1e-6L;
  for (int i = 0; i < 100; ++i) {
    CAPTURE(i);
    const Vector omega = 2 * random.vector();
    const auto q0 = Quaternion(random.quaternion()).cast<Extended>();
    const auto at = [&](Extended t) {
      return (closed_form::turn(omega.cast<Extended>() * t) * q0).coeffs().eval();
    };
    const Value q = at(0.5L).cast<double>();
    const Value difference = ((at(0.5L + d) - at(0.5L - d)) / (2 * d)).cast<double>();
    // d^2/6 (|omega|/2)^3 < 1e-12; rounding 5e-20/d = 5e-14, and that of q and of the rate.
    CHECK((QuaternionEquation::rate(omega, q) - difference).norm() < 2e-12);
  }
}

TEST_CASE("the error of a quaternion is the logarithm of q* (q + dq)") {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    CAPTURE(i);
    const Value q = random.quaternion();
    const double size = 1e-5;
    const Value dq = size * random.quaternion();
    const Quaternion d = Quaternion(q).conjugate() * Quaternion(Value(q + dq));
    const Vector logarithm = d.vec() / d.vec().norm() * 2 * std::atan2(d.vec().norm(), d.w());
    // First order in dq: what is left out is 2 |dq|^2 and less.
    CHECK((QuaternionEquation::body_error(q, dq) - logarithm).norm() < 2 * size * size);
  }
}

TEST_CASE(
    "turning by a small vector is what body_error reads back, and the exact turn to order 1") {
  Random random;
  for (int i = 0; i < 100; ++i) {
    CAPTURE(i);
    const Value q = random.quaternion();
    const Vector v = 1e-5 * random.vector();
    const Value dq = QuaternionEquation::turning(q, v);
    CHECK((QuaternionEquation::body_error(q, dq) - v).norm() < 1e-20);  // some u |v|
    const auto exact = Quaternion(q).cast<Extended>() * closed_form::turn(v.cast<Extended>());
    CHECK((q + dq - exact.coeffs().cast<double>()).norm() < v.squaredNorm() + 1e-15);
  }
}

TEST_CASE("a change of the norm alone is no error of the rotation") {
  Random random;
  for (int i = 0; i < 100; ++i) {
    CAPTURE(i);
    const Value q = random.quaternion();
    CHECK(QuaternionEquation::body_error(q, 0.5 * q).norm() < 1e-15);
  }
}

TEST_CASE("restoring brings a norm of 1 + d back to 1 within 2 d^2, without turning") {
  Random random;
  for (const double d : {0.0, 1e-16, 1e-12, -1e-8, 1e-4, -1e-2}) {
    const Value direction = random.quaternion();
    const Value q = (1 + d) * direction;
    const Value restored = q + QuaternionEquation::restoring(q);
    CAPTURE(d);
    // (1 + d) (1 - d - d^2/2) = 1 - 3/2 d^2 - d^3/2; and the rounding of a norm of four squares.
    CHECK(std::abs(restored.norm() - 1) < 2 * d * d + 1e-15);
    CHECK((restored.normalized() - direction.normalized()).norm() < 1e-15);
  }
}
