#include "integrate/dense.hpp"

#include <array>
#include <cmath>

#include "catch.hpp"
#include "closed_forms.hpp"

namespace {

using namespace rotor;
using One = Eigen::Matrix<double, 1, 1>;

// A polynomial of degree 7 is held exactly by seven terms: y = x^2 (1 - x) (...) of the form
// itself. Its coefficients are small integers, so that the eighths are exact in every operation.
constexpr std::array<double, 7> kTerms = {3, -1, 2, 5, -4, 1, 2};

double by_the_formula(double x) {
  const double z = 1 - x;
  const auto& f = kTerms;
  return 7 + x * (f[0] + z * (f[1] + x * (f[2] + z * (f[3] + x * (f[4] + z * (f[5] + x * f[6]))))));
}

std::array<One, 7> terms() {
  std::array<One, 7> f;
  for (std::size_t i = 0; i < 7; ++i) f[i] = One(kTerms[i]);
  return f;
}

// The cubic (t - 1)^3 + t in Hermite form on the piece from a to b.
double cubic(double t) { return (t - 1) * (t - 1) * (t - 1) + t; }
void append_cubic(DenseOutput<One>& dense, double a, double b) {
  const auto slope = [](double t) { return 3 * (t - 1) * (t - 1) + 1; };
  const double h = b - a;
  const double f0 = cubic(b) - cubic(a);
  dense.append(
      b, One(cubic(a)),
      std::array{One(f0), One(h * slope(a) - f0), One(2 * f0 - h * (slope(a) + slope(b)))});
}

}  // namespace

TEST_CASE("a piece is the nested polynomial that it says it is") {
  const auto f = terms();
  for (int eighths = 0; eighths <= 8; ++eighths) {
    const double x = eighths / 8.0;
    CAPTURE(x);
    CHECK(evaluate_piece(One(7.0), f.data(), 7, x).value[0] == by_the_formula(x));
  }
}

TEST_CASE("the slope of a piece is the derivative of its value") {
  // The central difference with d errs by d^2/6 times the third derivative (below 2000 here) and by
  // rounding, 1e-15 / d: at d = 1e-5 below 1e-7.
  const auto f = terms();
  constexpr double d = 1e-5;
  for (const double x : {0.0, 0.1, 0.37, 0.5, 0.9, 1.0}) {
    const double difference = (by_the_formula(x + d) - by_the_formula(x - d)) / (2 * d);
    CAPTURE(x);
    CHECK(evaluate_piece(One(7.0), f.data(), 7, x).slope[0] ==
          Approx(difference).epsilon(0).margin(1e-7));
  }
}

TEST_CASE("dense output holds a cubic, forward and backward, at its nodes and between") {
  // Numbers up to 30, some ten operations: 30 * 10 * 1.1e-16 < 4e-14.
  for (const auto& mesh :
       {std::vector{-1.0, -0.5, 0.25, 2.0, 4.0}, std::vector{4.0, 1.0, 0.9, -1.0},
        std::vector{0.0, 3.0}, std::vector{3.0, 0.0}}) {
    DenseOutput<One> dense(mesh.front(), 3);
    for (std::size_t i = 1; i < mesh.size(); ++i) append_cubic(dense, mesh[i - 1], mesh[i]);
    CHECK(dense.mesh() == mesh);
    CHECK(dense.pieces() == mesh.size() - 1);
    for (const double t : mesh) CHECK(dense.at(t)[0] == Approx(cubic(t)).epsilon(0).margin(4e-14));
    for (int i = 0; i <= 100; ++i) {
      const double t = mesh.front() + (mesh.back() - mesh.front()) * i / 100;
      CAPTURE(t);
      CHECK(dense.at(t)[0] == Approx(cubic(t)).epsilon(0).margin(4e-14));
    }
  }
}

TEST_CASE("each t is read from its own piece") {
  // Constant pieces 0, 1, 2, ...: the value is the number of the piece. A node may be read from
  // either side, for the pieces of a run join there.
  for (const double direction : {1.0, -1.0}) {
    DenseOutput<One> dense(0, 1);
    for (int i = 0; i < 5; ++i) dense.append(direction * (i + 1), One(i), std::array{One(0.0)});
    for (int i = 0; i < 5; ++i) {
      CHECK(dense.at(direction * (i + 0.5))[0] == i);
      CHECK(dense.at(direction * std::nextafter(i, 9))[0] == i);
      CHECK(dense.at(direction * std::nextafter(i + 1, 0))[0] == i);
      CHECK((dense.at(direction * (i + 1))[0] == i || dense.at(direction * (i + 1))[0] == i + 1));
    }
  }
}

namespace {

// The greatest error that arises within single steps of size h on P15 from 0 to 20.
double interpolation_error(const Scene& scene, double h) {
  const auto truth = closed_form::turning(5);
  const Propagator run = propagate(scene);
  const std::vector<double> mesh = run.flow->mesh();
  double greatest = 0;
  for (std::size_t i = 0; i + 1 < mesh.size(); ++i) {
    if (std::abs(mesh[i + 1] - mesh[i] - h) > 1e-9 * h) continue;
    const auto offset = truth(mesh[i]).conjugate() * run(mesh[i]).cast<Extended>();
    for (int part = 1; part < 10; ++part) {
      const double t = mesh[i] + h * part / 10;
      greatest = std::max(greatest, closed_form::rotation_error(run(t), truth(t) * offset));
    }
  }
  return greatest;
}

}  // namespace

// Within a step the output of order q errs by O(h^(q+1)); half an order tells q from its
// neighbours.
TEST_CASE("the Hermite cubic of the classical method is good to h^4") {
  const auto error = [](double h) {
    return interpolation_error(
        closed_form::by_rk4(h, closed_form::scene(closed_form::turning(5).omega(), 0, 20)), h);
  };
  CHECK(std::log2(error(0.5) / error(0.25)) == Approx(4).epsilon(0).margin(0.5));
  CHECK(std::log2(error(0.25) / error(0.125)) == Approx(4).epsilon(0).margin(0.5));
}

TEST_CASE("the dense output of DOP853 is good to h^8") {
  const auto error = [](double h) {
    Scene scene = closed_form::scene(closed_form::turning(5).omega(), 0, 20);
    scene.method = Method::kDop853;
    scene.accuracy = 1e3;  // the step is max_step, but for the first ones and the last two
    scene.max_step = h;
    return interpolation_error(scene, h);
  };
  CHECK(std::log2(error(1) / error(0.5)) == Approx(8).epsilon(0).margin(0.5));
  CHECK(std::log2(error(0.5) / error(0.25)) == Approx(8).epsilon(0).margin(0.5));
}
