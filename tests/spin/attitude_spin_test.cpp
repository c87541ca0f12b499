// The omega of a log of attitudes: its derivatives.
#include "spin/attitude_spin.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "catch.hpp"
#include "rotation/rotation.hpp"

namespace {

using namespace rotor;

// Between the times the curve turns by 1 to 3 rad, in part about axes that are far apart.
AttitudeSpin some() {
  const std::vector<Rotation> rotations = {{Vector(1, 0, 0), 0.3},
                                           {Vector(0, 1, 0.2), 2},
                                           {Vector(1, 2, 3), 1},
                                           {Vector(-1, 0.5, 0), 2.5},
                                           {Vector(0, 0, 1), -1}};
  return AttitudeSpin(Spline({0, 1, 2.5, 3.25, 5}, rotations));
}

Vector coefficient(const VectorJet& jet, std::size_t k) {
  return {jet[0].c[k], jet[1].c[k], jet[2].c[k]};
}

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

}  // namespace

TEST_CASE("the derivatives of the omega of attitudes are those of its curve") {
  const AttitudeSpin omega = some();
  for (const double t : {0.0, 1e-9, 0.4, 1.7, 2.6, 3.0, 4.2, 5.0}) {
    CAPTURE(t);
    const VectorJet jet = omega.jet(t);
    CHECK(coefficient(jet, 0) == omega.value(t));
    // The acceleration has a formula of its own. At the ends it is zero, a sum of what is not.
    const double size = omega.value(t).norm();
    const Vector acceleration = omega.spline().acceleration(t);
    CHECK((coefficient(jet, 1) - acceleration).norm() <=
          64 * kEpsilon * (acceleration.norm() + size + size * size));
    // The series is omega nearby, but for the terms from the ninth on, if these go on as they have
    // grown so far: c_k <= size growth^k.
    double growth = 0;
    for (std::size_t k = 1; k <= Jet::kOrder; ++k) {
      growth = std::max(growth,
                        std::pow(coefficient(jet, k).norm() / size, 1.0 / static_cast<double>(k)));
    }
    for (const double s : {-0.025, 0.01, 0.025}) {
      const double there = t + s;
      if (there < 0 || there > 5) continue;
      Vector sum = Vector::Zero();
      for (std::size_t k = Jet::kOrder + 1; k-- > 0;) sum = sum * s + coefficient(jet, k);
      CAPTURE(s);
      CHECK(growth * std::abs(s) < 0.3);
      CHECK((sum - omega.value(there)).norm() <=
            size * (2 * std::pow(growth * std::abs(s), 9) + 64 * kEpsilon));
    }
  }
}

TEST_CASE("at an attitude a derivative jumps") {
  const AttitudeSpin omega = some();
  for (const double t : {1.0, 2.5, 3.25}) CHECK_THROWS_AS(omega.jet(t), NotDifferentiable);
  CHECK_THROWS_AS(omega.jet(5.5), std::out_of_range);
}
