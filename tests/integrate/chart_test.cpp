// The right-hand sides of the charts, and what an integrator asks of them.
#include "integrate/charts.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "catch.hpp"
#include "charts.hpp"
#include "closed_forms.hpp"
#include "integrate/generalized.hpp"
#include "refusal.hpp"
#include "rotation/text.hpp"
#include "table.hpp"

namespace {

using namespace rotor;
using Eigen::Vector4d;

constexpr double kPi = std::numbers::pi;
constexpr double kU = 0x1p-53;

struct Row {
  std::string equation;
  Vector4d y;
  Vector omega;
  Vector4d rate;
};

std::vector<Row> rows() {
  std::vector<Row> all;
  for (reference::Row& fields : reference::table("integrate/charts.csv")) {
    Row row;
    row.equation = fields.word();
    for (double& y : row.y) y = fields.number();
    row.omega = fields.vector();
    for (double& rate : row.rate) rate = fields.number();
    all.push_back(row);
  }
  return all;
}

// The rows of one equation; each is measured by rate(row) against error(row), the bound.
template <class Rate, class Bound>
void check_rates(const std::string& equation, const Rate& rate, const Bound& bound) {
  int count = 0;
  for (const Row& row : rows()) {
    if (row.equation != equation) continue;
    ++count;
    const Vector4d measured = rate(row);
    CAPTURE(equation, text(row.y.head<3>().eval()), row.y.w(), text(row.omega));
    CAPTURE(measured.transpose(), row.rate.transpose());
    const double size = norm(Vector(row.rate.head<3>())) + std::abs(row.rate.w());
    CHECK((measured - row.rate).cwiseAbs().maxCoeff() <= bound(row, size));
  }
  CHECK(count >= 18);
}

Vector4d padded(const Vector& v) { return {v.x(), v.y(), v.z(), 0}; }

struct Random {
  std::mt19937 generator{7};
  std::normal_distribution<double> normal;
  double operator()() { return normal(generator); }
  Vector vector() { return Vector((*this)(), (*this)(), (*this)()); }
};

}  // namespace

TEST_CASE("the rate of the Euler vector is right to the last digits") {
  // Extended precision rounded once, and so is the table: an ulp. Near a full turn |E|, known to
  // 2^-64, decides: 1e-19 theta^2/(4 sin^2(theta/2)) more (kinematics.hpp), of the part of omega
  // across E.
  check_rates(
      "euler",
      [](const Row& row) { return padded(EulerEquation::rate(row.omega, row.y.head<3>())); },
      [](const Row& row, double size) {
        const double theta = norm(Vector(row.y.head<3>()));
        const double half = theta == 0 ? 1 : theta / (2 * std::sin(theta / 2));
        return 2.02 * kU * size + 1e-19 * half * half * norm(row.omega);
      });
}

TEST_CASE("the rate of axis and angle is right to the last digits") {
  // n is made unit (2u for each of its two appearances), the product scaled and rounded.
  check_rates(
      "axis_angle", [](const Row& row) { return AxisAngleEquation::rate(row.omega, row.y); },
      [](const Row& row, double size) { return 8 * kU * (size + norm(row.omega)); });
}

TEST_CASE("the rate of the Gibbs vector is right to the last digits") {
  // Sums of products of the size of omega (1 + |G|^2), each with three or four roundings.
  check_rates(
      "gibbs",
      [](const Row& row) { return padded(GibbsEquation::rate(row.omega, row.y.head<3>())); },
      [](const Row& row, double) {
        return 4 * kU * norm(row.omega) * (1 + row.y.head<3>().squaredNorm());
      });
}

TEST_CASE("the rate of the generalized Euler vector is right to the last digits") {
  // What theta = f^-1(|F|) may be wrong by, d = 4u (theta + f/f'), changes f' by f'' d and
  // (f/theta) g by about f/theta (d/theta) (1 + theta^2/(4 sin^2(theta/2))); rounding comes to 4u
  // of the terms.
  const auto check = [](const std::string& name, const auto& f, const auto& second) {
    const GeneralizedEquation equation(f, false);
    check_rates(
        name, [&](const Row& row) { return padded(equation.rate(row.omega, row.y.head<3>())); },
        [&](const Row& row, double size) {
          const double value = norm(Vector(row.y.head<3>()));
          const double theta = f->inverse(value);
          const double slope = (*f)(theta).slope;
          const double d = 4 * kU * (theta + value / slope);
          const double pole = theta / (2 * std::sin(theta / 2));
          const double change =
              std::abs(second(theta)) * d + value / theta * (d / theta) * (1 + pole * pole);
          return 4 * kU * (size + norm(row.omega) * (slope + value)) + change * norm(row.omega);
        });
  };
  check("euler", identity_angle(), [](double) { return 0.0; });
  check("cubic", cubic_angle(), [](double theta) { return 0.6 * theta; });
  check("half_sine", half_sine_angle(), [](double theta) { return std::sin(theta / 2) / 2; });
  check("half_tangent", half_tangent_angle(),
        [](double theta) { return std::tan(theta / 2) / std::pow(std::cos(theta / 2), 2) / 2; });
}

TEST_CASE("at the identity the rates of E, G and F are omega, half of it, and f'(0) of it") {
  const Vector omega(0.3, -1, 2);
  CHECK(EulerEquation::rate(omega, Vector::Zero()) == omega);
  CHECK(GibbsEquation::rate(omega, Vector::Zero()) == omega / 2);
  CHECK(GeneralizedEquation(half_tangent_angle(), false).rate(omega, Vector::Zero()) == omega / 2);
  CHECK(EulerEquation::body_error(Vector::Zero(), omega) == omega);
  CHECK(GeneralizedEquation(half_tangent_angle(), false).body_error(Vector::Zero(), omega) ==
        2 * omega);
}

TEST_CASE("the limit constant of P4 is (f'(0)/12 + f'''(0)/3)/f'(0)^2") {
  // For omega across F, F' . omega = |omega|^2 (f' - f^2 C). f = theta + theta^3/10 has f'(0) = 1
  // and f'''(0) = 3/5; at theta = 1e-3 the next term is of order theta^2, rounding u/theta^2.
  const GeneralizedEquation equation(cubic_angle(), false);
  constexpr double theta = 1e-3;
  const double f = theta + theta * theta * theta / 10;
  const Vector rate = equation.rate(Vector(0, 1, 0), Vector(f, 0, 0));
  const double constant = (1 + 0.3 * theta * theta - rate.y()) / (f * f);
  CHECK(constant == Approx(1.0 / 12 + 0.6 / 3).epsilon(1e-5));
  // As printed, 2/3 of f''' instead of 1/3, it would be 0.4833.
  CHECK(std::abs(constant - (1.0 / 12 + 2 * 0.6 / 3)) > 0.19);
}

namespace {

// Some y of each chart, a little off the rotations where that can be (as dense output is), with the
// rotation that they stand for; f(equation, y).
template <class F>
void for_each_chart(const F& f) {
  Random random;
  for (int i = 0; i < 40; ++i) {
    const Vector n = random.vector().normalized();
    const double theta = 3 * kPi * (i + 0.5) / 40;
    if (std::abs(theta - 2 * kPi) < 0.2) continue;
    const Rotation r(n, theta);
    const double off = 1 + 1e-3 * random();
    CAPTURE(i, text(n), theta);
    f(QuaternionEquation(), Vector4d(off * r.quaternion().coeffs()), r);
    Matrix stretch = Matrix::Identity();
    for (int j = 0; j < 3; ++j) stretch(j, j) += 1e-4 * random();
    f(BodyPointsEquation(), Matrix(r.matrix() * stretch), r);
    f(EulerEquation(false, false), Vector(n * theta), r);
    f(GibbsEquation(), r.gibbs(), r);
    f(AxisAngleEquation(), Vector4d(off * n.x(), off * n.y(), off * n.z(), theta), r);
    const double value = theta + theta * theta * theta / 10;
    f(GeneralizedEquation(cubic_angle(), false), Vector(n * value), r);
  }
}

// The greatest of |f'|, |f/theta| and the like: what a small rotation is multiplied by.
double size_of(const Matrix& y) { return 1 + y.squaredNorm(); }
template <class Y>
double size_of(const Y& y) {
  return 10 * (1 + y.squaredNorm());
}

}  // namespace

TEST_CASE("seen from the body the rate of every chart is omega there") {
  // R^T omega, by the operator itself. Off the rotations too, but for the matrix, where the square
  // of what it is off by, some 1e-8, is left out.
  Random random;
  for_each_chart([&](const auto& equation, const auto& y, const Rotation& r) {
    const Vector omega = random.vector();
    const bool matrix = y.size() == 9;
    const Vector body = r.inverse() * omega;
    CHECK(norm(equation.body_error(y, equation.rate(omega, y)) - body) <
          (matrix ? 2e-7 : 4e-14 * size_of(y)) * norm(omega));
  });
}

TEST_CASE("the quaternion of every chart is that of its rotation") {
  for_each_chart([](const auto& equation, const auto& y, const Rotation& r) {
    const Quaternion q = equation.quaternion(y);
    const double nearest = std::min((q.coeffs() - r.quaternion().coeffs()).norm(),
                                    (q.coeffs() + r.quaternion().coeffs()).norm());
    CHECK(nearest < (y.size() == 9 ? 1e-3 : 1e-14));  // a stretch is no rotation, nearly
    CHECK(q.norm() == Approx(1).epsilon(1e-15));
  });
}

TEST_CASE(
    "the error of every chart is the logarithm of the rotation between, and turning undoes it") {
  Random random;
  for_each_chart([&](const auto& equation, const auto& y, const Rotation&) {
    using Value = std::decay_t<decltype(y)>;
    constexpr double size = 1e-5;
    const Vector v = size * random.vector().normalized();
    const Value dy = equation.turning(y, v);
    // From y itself: what it is off the rotations by falls out.
    CHECK(norm(equation.body_error(y, dy) - v) <
          (y.size() == 9 ? 1e-3 : 1e-12 * size_of(y)) * size);
    Quaternion d = equation.quaternion(y).conjugate() * equation.quaternion(y + dy);
    if (d.w() < 0) d.coeffs() *= -1;
    // First order in dy; second derivatives of a chart here are less than some 1/0.2^2.
    CHECK((2 * d.vec() - v).norm() < (y.size() == 9 ? 1e-3 * size : 200 * size * size));
  });
}

TEST_CASE("restoring makes axes unit and matrices orthogonal, without turning") {
  for_each_chart([](const auto& equation, const auto& y, const Rotation&) {
    using Value = std::decay_t<decltype(y)>;
    const Value restored = y + equation.restoring(y);
    CHECK(equation.quaternion(restored).angularDistance(equation.quaternion(y)) < 1e-7);
    const Vector body = equation.body_error(y, equation.restoring(y));
    CHECK(norm(body) < 1e-9);
    if (y.size() == 9) {
      const Matrix r = Eigen::Map<const Matrix>(restored.data());
      // 3/2 of the square of what it was off by, 1e-4 times a few.
      CHECK((r.transpose() * r - Matrix::Identity()).norm() < 1e-6);
    }
    if (std::is_same_v<std::decay_t<decltype(equation)>, AxisAngleEquation>) {
      CHECK(Vector(restored.data()[0], restored.data()[1], restored.data()[2]).norm() ==
            Approx(1).epsilon(1e-15));
    }
  });
}

TEST_CASE("a restart is the same operator, on the branch around 0") {
  const auto same = [](const auto& equation, const Vector& before) {
    const Vector after = equation.restarted(before);
    const Quaternion q = equation.quaternion(before);
    const Quaternion p = equation.quaternion(after);
    CHECK((q.coeffs() + p.coeffs()).norm() < 2e-15);  // a full turn less
    return after;
  };
  const Vector n(2.0 / 3, -1.0 / 3, 2.0 / 3);
  // The paper: at 3 pi/2 from -E/3.
  CHECK((same(EulerEquation(true, false), n * 1.5 * kPi) + n * kPi / 2).norm() < 1e-15);
  const double theta = cubic_angle()->inverse(13);
  CHECK((same(GeneralizedEquation(cubic_angle(), true), n * 13) +
         n * (*cubic_angle())(2 * kPi - theta).f)
            .norm() < 1e-14);
  CHECK(EulerEquation(true, false).is_due(n * 4.72));
  CHECK(!EulerEquation(true, false).is_due(n * 4.71));
  CHECK(!EulerEquation(false, false).is_due(n * 4.72));
  for (const double angle : {4.8, 7.0, 15.0, -7.0, 100.0}) {
    const Vector start = EulerEquation(true, false).start(Rotation(n, angle));
    CAPTURE(angle);
    CHECK(start.norm() <= 1.5 * kPi);
    CHECK(distance(from_euler_vector(start), Rotation(n, angle)) < 1e-13);
  }
}

TEST_CASE("a start where the equation is singular is refused, with the angle and the ways out") {
  const Vector n(0, 0.6, 0.8);
  for (const double k : {1.0, -1.0, 2.0, 5.0}) {
    const Rotation turns(n, 2 * kPi * k);
    refused([&] { EulerEquation(false, false).start(turns); },
            {"\"euler\"",
             k == 5   ? "10 pi"
             : k == 2 ? "4 pi"
                      : "2 pi",
             "restart = true", text(turns.angle())});
    refused([&] { AxisAngleEquation::start(turns); }, {"\"axis_angle\"", "quaternion"});
    refused([&] { GeneralizedEquation(cubic_angle(), true).start(turns); }, {"\"generalized\""});
  }
  refused([] { AxisAngleEquation::start(Rotation()); }, {"theta = 0", "start's angle is 0.0"});
  refused([&] { GeneralizedEquation(half_sine_angle(), false).start(Rotation(n, 3.2)); },
          {"3.14159", "domain of f ends", "3.2"});
  CHECK(refusal([&] { AxisAngleEquation::start(Rotation(n, 1e-300)); }) == "(accepted)");
  CHECK(refusal([&] {
          EulerEquation(false, false).start(Rotation(n, std::nextafter(6.2831, 7)));
        }) == "(accepted)");
  refused([&] { GibbsEquation::start(Rotation(n, kPi)); }, {"\"gibbs\"", "theta = pi"});
  CHECK(GibbsEquation::start(Rotation(n, 3.1415926)).norm() > 1e7);
}
