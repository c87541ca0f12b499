#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "catch.hpp"
#include "closed_forms.hpp"
#include "integrate/dop853_tableau.hpp"
#include "integrate/equation.hpp"
#include "integrate/step.hpp"

namespace {

using namespace rotor;
using closed_form::ExtendedQuaternion;

constexpr closed_form::Turning kMotion{1};

// n steps of a bare method from 0 to t on P15, and the rotation error at the end.
template <std::size_t S>
double error_after(const Tableau<S>& method, double t, int n) {
  const AngularVelocity omega = kMotion.omega();
  const double h = t / n;
  Eigen::Vector4d y(0, 0, 0, 1);
  for (int step = 0; step < n; ++step) {
    std::array<Vector, S> samples;
    for (std::size_t i = 0; i < S; ++i) samples[i] = omega((step + method.c[i]) * h);
    y += increment(QuaternionEquation(), method, samples, y, h);
  }
  return closed_form::rotation_error(Quaternion(Eigen::Vector4d(y.normalized())), kMotion(t));
}

// Halving h divides the error c h^p (1 + O(h)) by 2^p (1 + O(h)). The last of the halvings is well
// above rounding (n steps of half an ulp); half an order tells p from its neighbours.
template <std::size_t S>
void check_order(const Tableau<S>& method, int first_n) {
  double before = error_after(method, 8, first_n);
  for (int n = 2 * first_n; n <= 4 * first_n; n *= 2) {
    const double after = error_after(method, 8, n);
    CAPTURE(n, before, after);
    CHECK(after > 1e-12);
    CHECK(std::log2(before / after) == Approx(method.order).epsilon(0).margin(0.5));
    before = after;
  }
}

}  // namespace

TEST_CASE("halving the step divides the error of the classical method by 2^4") {
  check_order(kRk4Tableau, 64);
}

TEST_CASE("halving the step divides the error of DOP853 by 2^8") { check_order(kDop853Tableau, 8); }

TEST_CASE("on a constant omega a step is the exponential series to the order of the method") {
  // One step multiplies by 1 + x + ... + x^p/p! + O(x^(p+1)), x = omega h/2, exactly so for p
  // stages: with |x| = 2^-3 the next term is 2^-15/120 = 2.6e-7 for p = 4. DOP853 has 12 stages,
  // thus a polynomial of degree 12 that agrees to degree 8: the next term is 2^-27/9! = 2.1e-14
  // times at most some units.
  const Vector omega(0, 0, 0.25);
  const ExtendedQuaternion exact = closed_form::turn(omega.cast<Extended>());
  const Eigen::Vector4d one(0, 0, 0, 1);
  const auto error = [&](const Eigen::Vector4d& dy) {
    return static_cast<double>(
        (Eigen::Vector4d(one + dy).cast<Extended>() - exact.coeffs()).norm());
  };
  std::array<Vector, 4> four;
  four.fill(omega);
  CHECK(error(increment(QuaternionEquation(), kRk4Tableau, four, one, 1)) ==
        Approx(std::pow(0.125, 5) / 120).epsilon(0.05));  // and x/6 of that for the next term
  std::array<Vector, 12> twelve;
  twelve.fill(omega);
  CHECK(error(increment(QuaternionEquation(), kDop853Tableau, twelve, one, 1)) < 1e-13);
}

TEST_CASE("a weighted sum leaves out what has no weight and what is past the count") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::array<Eigen::Vector2d, 3> k = {Eigen::Vector2d(1, 2), Eigen::Vector2d(nan, nan),
                                            Eigen::Vector2d(3, 5)};
  CHECK(weighted_sum(std::array{2.0, 0.0, -1.0}, k) == Eigen::Vector2d(-1, -1));
  CHECK(weighted_sum(std::array{2.0, 1.0, 1.0}, k, 1) == Eigen::Vector2d(2, 4));
}

TEST_CASE("a compensated sum of a million terms is as if added once") {
  // Kahan's bound: 2u sum |x_i|, and n u^2 sum |x_i|, which is nothing here. The exact sum is a
  // product, right to 2^-64.
  constexpr int kTerms = 1'000'000;
  constexpr double u = std::numeric_limits<double>::epsilon() / 2;
  const Eigen::Vector3d term(0.1, -1.0 / 3, 1e-17);
  const Eigen::Vector3d start(0.0, 0.0, 1.0);
  CompensatedSum<Eigen::Vector3d> sum(start);
  Eigen::Vector3d naive = start;
  for (int i = 0; i < kTerms; ++i) {
    sum.add(term);
    naive += term;
  }
  for (int i = 0; i < 3; ++i) {
    const Extended exact = Extended{start[i]} + Extended{term[i]} * kTerms;
    CAPTURE(i);
    CHECK(std::abs(static_cast<double>(sum.value()[i] - exact)) <=
          2.01 * u * std::abs(static_cast<double>(exact)));
  }
  CHECK(naive.z() == 1);  // what the compensation is for
  CHECK(sum.value().z() > 1);
}

TEST_CASE("a compensated sum forgets nothing when the terms change sign") {
  using One = Eigen::Matrix<double, 1, 1>;
  CompensatedSum<One> sum(One(1.0));
  for (int i = 0; i < 1000; ++i) sum.add(One(1e-17));
  for (int i = 0; i < 1000; ++i) sum.add(One(-1e-17));
  CHECK(sum.value()[0] == 1);
  sum.add(One(-1.0));
  CHECK(std::abs(sum.value()[0]) <= 1000 * 1e-17 * 2.3e-16);  // the rounding of the low part alone
}
