#include "dynamics/tangent.hpp"

#include <cmath>
#include <random>

#include "../rotation/elements.hpp"
#include "catch.hpp"

namespace {

using namespace rotor;

State state_of(const Rotation& r) {
  State state;
  state.axis = r.axis();
  state.angle = r.angle();
  state.quaternion = r.quaternion();
  return state;
}

State at(Chart chart, const Vector& x) {
  switch (chart) {
    case Chart::kEulerVector:
      return state_of(from_euler_vector(x));
    case Chart::kModifiedGibbs:
      return state_of(from_modified_gibbs(x));
    case Chart::kGibbs:
      return state_of(from_gibbs(x));
    default:
      return state_of(from_mrp(x));
  }
}

// Central differences of f with steps h along e1, e2, e3: (f(x + h e_j) - f(x - h e_j))/2h.
template <class F>
Matrix differences(F f) {
  constexpr double kStep = 1e-5;
  Matrix d;
  for (int j = 0; j < 3; ++j) {
    const Vector step = kStep * Vector::Unit(j);
    d.col(j) = (f(step) - f(-step)) / (2 * kStep);
  }
  return d;
}

// Of functions of order 1 that change over a distance r: h^2/(6 r^3) f''' and 2e-16/h of rounding,
// with h = 1e-5 and r >= 1/3 (of an angle within 1 of a singularity, 1/3 in units of theta/2) some
// 1e-9; twice that for the next order and for f up to 2.
constexpr double kTolerance = 2e-9;

}  // namespace

TEST_CASE("the Jacobian of a chart is that of its coordinates by a small rotation from the left") {
  reference::Draw draw(61);
  for (int i = 0; i < 200; ++i) {
    // Away from the singularities of all charts: pi, 2 pi.
    const Rotation r(draw.vector(), draw.uniform(0.01, i % 2 == 0 ? 2.0 : 1.0));
    CAPTURE(i, r.angle(), r.axis().transpose());
    for (const Chart chart : kCharts) {
      if (chart == Chart::kRotation) continue;
      CAPTURE(name_of(chart));
      const Matrix measured = differences([&](const Vector& e) {
        const Quaternion q = from_euler_vector(e).quaternion() * r.quaternion();
        return coordinates(chart, state_of(rotation_of(q)));
      });
      CHECK((chart_jacobian(chart, state_of(r)) - measured).norm() < kTolerance);
    }
  }
  CHECK(chart_jacobian(Chart::kRotation, state_of(Rotation())) == Matrix::Identity());
}

TEST_CASE("the linearised motion is the derivative of the chart's own equation, in both frames") {
  reference::Draw draw(62);
  for (int i = 0; i < 200; ++i) {
    const Rotation r(draw.vector(), i < 100 ? draw.uniform(1e-3, 2) : draw.uniform(1e-3, 0.6));
    const Vector omega = draw.vector();
    CAPTURE(i, r.angle(), r.axis().transpose(), omega.transpose());
    for (const Chart chart : kCharts) {
      if (chart == Chart::kRotation) continue;
      const Vector x = coordinates(chart, state_of(r));
      for (const Frame frame : {Frame::kSpace, Frame::kBody}) {
        CAPTURE(name_of(chart), frame == Frame::kSpace);
        const Matrix measured = differences([&](const Vector& step) -> Vector {
          const State s = at(chart, x + step);
          const Vector in_space = frame == Frame::kSpace ? omega : Vector(s.matrix() * omega);
          return chart_jacobian(chart, s) * in_space;
        });
        CHECK((rate_jacobian(chart, state_of(r), omega, frame) - measured).norm() < kTolerance);
      }
    }
  }
}

TEST_CASE("the linearised motion of E beyond pi, and where its series ends") {
  // Both sides of theta = 1/2 with the same E but for 1e-12 of its length: A changes by no more.
  const Vector n = Vector(1, 2, -2) / 3;
  const Vector omega(0.3, -1, 0.5);
  const Matrix below =
      rate_jacobian(Chart::kEulerVector, state_of(Rotation(n, 0.5 - 1e-12)), omega, Frame::kSpace);
  const Matrix above =
      rate_jacobian(Chart::kEulerVector, state_of(Rotation(n, 0.5 + 1e-12)), omega, Frame::kSpace);
  CHECK((below - above).norm() < 1e-11);
  // Next to 2 pi differences know least: at 5 the singularity is 1.3 away, and (theta/2)/sin, 4.2,
  // is what f grows to.
  for (const double angle : {4.0, 5.0, 8.0, -5.0}) {
    CAPTURE(angle);
    const Vector x = angle * n;
    const Matrix measured = differences([&](const Vector& step) -> Vector {
      const Vector e = x + step;
      const Rotation r(e * (angle < 0 ? -1 : 1), angle < 0 ? -e.norm() : e.norm());
      return chart_jacobian(Chart::kEulerVector, state_of(r)) * omega;
    });
    const State state = state_of(Rotation(n, angle));
    CHECK((rate_jacobian(Chart::kEulerVector, state, omega, Frame::kSpace) - measured).norm() <
          10 * kTolerance);
  }
}
