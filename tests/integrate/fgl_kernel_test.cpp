// The arithmetic of the fast integrator: one step against many, and against itself on other
// instructions.
#include "integrate/fgl_kernel.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <random>

#include "catch.hpp"
#include "integrate/fgl_tables.hpp"
#include "integrate/gauss_tables.hpp"
#include "rotation/rotation.hpp"

namespace {

using namespace rotor;

using Generator = std::function<Vector(double)>;

double node(std::size_t lane) { return kFglNodePlaces[lane].place; }

NodeVectors sampled(const Generator& g, double begin, double end) {
  NodeVectors w{};
  const double half = (end - begin) / 2;
  for (std::size_t l = 0; l < kFglNodes; ++l) {
    const Vector value = half * g((begin + end) / 2 + half * node(l));
    for (std::size_t c = 0; c < 3; ++c) w.v[c][l] = value(static_cast<Eigen::Index>(c));
  }
  return w;
}

Quaternion quaternion(const std::array<double, 4>& q) { return {q[0], q[1], q[2], q[3]}; }

double error_between(const Quaternion& a, const Quaternion& b) {
  return 2 * (a.coeffs() - b.coeffs()).norm();
}

// As many steps, each of an n-th of the length.
Quaternion by_steps(const Generator& g, double begin, double end, int n) {
  Quaternion u = Quaternion::Identity();
  for (int i = 0; i < n; ++i) {
    const double a = begin + (end - begin) * i / n;
    const double b = begin + (end - begin) * (i + 1) / n;
    u = quaternion(portable_fgl_kernel().step(sampled(g, a, b), 0, 0).turn) * u;
  }
  return u;
}

// A constant and four waves.
Generator random_waves(std::mt19937& random) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> even(0, 1);
  const double size = std::exp(3 * even(random) - 1.5);
  const double rate = std::exp(4 * even(random) - 2.5);
  std::array<Vector, 5> a;
  std::array<double, 5> frequency{};
  std::array<double, 5> phase{};
  for (std::size_t i = 0; i < 5; ++i) {
    a[i] = size * Vector(normal(random), normal(random), normal(random));
    frequency[i] = i == 0 ? 0 : rate * even(random);
    phase[i] = 6 * even(random);
  }
  return [=](double t) {
    Vector g = a[0];
    for (std::size_t i = 1; i < 5; ++i) g += a[i] / 2 * std::cos(frequency[i] * t + phase[i]);
    return g;
  };
}

}  // namespace

TEST_CASE("the polynomials of the factors are the functions that they stand for") {
  // To 2^-55, and the rounding of up to 16 terms whose sum of sizes is below 4.
  const double margin = std::ldexp(1, -55) + 16 * 4 * std::ldexp(1, -53);
  const auto value = [](const auto& powers, Extended u) {
    Extended sum = 0;
    for (std::size_t k = powers.size(); k-- > 0;) sum = sum * u + powers[k];
    return sum;
  };
  for (int i = 1; i <= 200; ++i) {
    for (const auto& fit : kFerFits) {
      const Extended x = Extended{fit.range} * i / 200;
      const Extended th = std::sqrt(x);
      const Extended versine = 2 * std::pow(std::sin(th / 2), Extended{2}) / x;
      const Extended u = 2 * x / fit.range - 1;
      CHECK(std::abs(static_cast<double>(value(fit.first, u) - (versine - std::sin(th) / th))) <
            margin);
      // (th - sin th)/th^3 loses digits near 0: there by its series.
      const Extended third = x > 0.01L
                                 ? (th - std::sin(th)) / (th * x)
                                 : Extended{1} / 6 - x / 120 + x * x / 5040 - x * x * x / 362880;
      CHECK(std::abs(static_cast<double>(value(fit.second, u) - (versine - third))) < margin);
    }
    for (const auto& fit : kExpFits) {
      const Extended x = Extended{fit.range} * i / 200;
      const Extended half = std::sqrt(x) / 2;
      const Extended u = 2 * x / fit.range - 1;
      CHECK(std::abs(static_cast<double>(value(fit.first, u) - std::cos(half))) < margin);
      CHECK(std::abs(static_cast<double>(value(fit.second, u) - std::sin(half) / half / 2)) <
            margin);
    }
  }
}

TEST_CASE("the best instructions give the digits of the portable ones, to the last bit") {
  std::mt19937 random(11);
  for (int i = 0; i < 200; ++i) {
    const Generator g = random_waves(random);
    const NodeVectors w = sampled(g, 0, std::ldexp(8, -i / 4) / g(0).norm());
    const FglStep best = fgl_kernel().step(w, 1e-15, 0);
    const FglStep plain = portable_fgl_kernel().step(w, 1e-15, 0);
    CAPTURE(i);
    CHECK(std::memcmp(&best, &plain, sizeof best) == 0);
    FglInterior inside{};
    FglInterior plain_inside{};
    CHECK(fgl_kernel().interior(w, inside) == portable_fgl_kernel().interior(w, plain_inside));
    CHECK(std::memcmp(&inside, &plain_inside, sizeof inside) == 0);
    NodeSlopes slopes{};
    NodeSlopes plain_slopes{};
    fgl_kernel().slope(w, slopes);
    portable_fgl_kernel().slope(w, plain_slopes);
    CHECK(std::memcmp(&slopes, &plain_slopes, sizeof slopes) == 0);
    FglPiece piece{};
    FglPiece plain_piece{};
    const std::array<double, 4> from = {0.5, -0.1, 0.7, 0.5};
    fgl_kernel().fit(inside, from, {0, 1e-9, 0, -1e-9}, piece);
    portable_fgl_kernel().fit(inside, from, {0, 1e-9, 0, -1e-9}, plain_piece);
    CHECK(std::memcmp(&piece, &plain_piece, sizeof piece) == 0);
    std::array<double, 4> value{};
    std::array<double, 4> plain_value{};
    fgl_kernel().value(piece, 0.3, value.data());
    portable_fgl_kernel().value(piece, 0.3, plain_value.data());
    CHECK(value == plain_value);
  }
}

TEST_CASE("a step's error estimate covers its error, for waves of all kinds") {
  // Against ten steps, whose errors are 10^-32 of it. Rounding: some 4 ulp each.
  std::mt19937 random(7);
  std::uniform_real_distribution<double> even(0, 1);
  int seen = 0;
  for (int i = 0; i < 3000; ++i) {
    const Generator g = random_waves(random);
    const double h = std::exp(2 * even(random) - 1) * 8 / (g(0).norm() + g(0.3).norm());
    const FglStep step = portable_fgl_kernel().step(sampled(g, 0, h), 1e-18, 0);
    if (!(step.error < 1e-2)) continue;
    const double error = error_between(quaternion(step.turn), by_steps(g, 0, h, 10));
    CAPTURE(i, h);
    CHECK(error <= step.error + 1e-14);
    if (error > 1e-13) ++seen;
  }
  CHECK(seen > 100);  // it was a test
}

TEST_CASE("a step is of order 32") {
  const auto error = [](double h) {
    const Generator g = [](double t) { return Vector(std::cos(2 * t), std::sin(2 * t), 0); };
    return error_between(quaternion(portable_fgl_kernel().step(sampled(g, 1, 1 + h), 0, 0).turn),
                         by_steps(g, 1, 1 + h, 16));
  };
  // Of 33 in one step, the next terms being of relative size h: within some of it.
  const double order = std::log(error(5) / error(4)) / std::log(5.0 / 4);
  CHECK(order > 20);
  CHECK(order < 36);
}

TEST_CASE("the interior of a step leads to its end, and each of its values is a step's") {
  const Generator g = [](double t) {
    return Vector(std::cos(t), 0.3 * t, std::sin(3 * t) / (2 + t));
  };
  const double h = 0.4;  // between the ends the order is 17, of functions with a pole at -2
  FglInterior inside{};
  REQUIRE(fgl_kernel().interior(sampled(g, 0, h), inside));
  CHECK(error_between(quaternion(inside.end), by_steps(g, 0, h, 8)) < 1e-14);
  for (std::size_t l = 0; l < kFglNodes; ++l) {
    const double t = h / 2 * (1 + node(l));
    const auto& n = inside.nodes;
    CHECK(error_between(Quaternion(n[0][l], n[1][l], n[2][l], n[3][l]), by_steps(g, 0, t, 8)) <
          1e-13);
  }
}

TEST_CASE("the polynomial of a part goes through its values at the nodes and at both ends") {
  const Generator g = [](double t) { return Vector(1, std::cos(2 * t), -t); };
  FglInterior inside{};
  REQUIRE(fgl_kernel().interior(sampled(g, 0, 2), inside));
  const Quaternion from = Quaternion(0.1, 0.7, -0.5, 0.5).normalized();
  for (const double size : {0.0, 1e-9, 0.1}) {  // 0.1: far from unit, so that the root is needed
    CAPTURE(size);
    const std::array<double, 4> turn = {-size, 2 * size, 0, size};
    FglPiece piece{};
    fgl_kernel().fit(inside, {from.w(), from.x(), from.y(), from.z()}, turn, piece);
    const auto off = [&](double z, const Quaternion& v) {
      Quaternion u;
      fgl_kernel().value(piece, z, u.coeffs().data());
      CHECK(std::abs(u.norm() - 1) < 4e-16);
      Quaternion there = v * from;
      there.coeffs() += (1 + z) / 2 * (quaternion(turn) * there).coeffs();
      return error_between(u, there.normalized());
    };
    // 18 terms, each rounded a few times, none greater than 1.
    const double rounding = 18 * 4 * std::ldexp(1, -53);
    for (std::size_t l = 0; l < kFglNodes; ++l) {
      const auto& n = inside.nodes;
      CHECK(off(node(l), {n[0][l], n[1][l], n[2][l], n[3][l]}) < rounding);
    }
    CHECK(off(-1, Quaternion::Identity()) < rounding);
    CHECK(off(1, quaternion(inside.end)) < rounding);
  }
}

TEST_CASE("what is too long, infinite or not a number is refused, and nothing is done to nothing") {
  const auto all = [](double x) {
    NodeVectors w{};
    for (auto& component : w.v) component.fill(x);
    return fgl_kernel().step(w, 1e-15, 0);
  };
  for (const double x : {10.0, 1e160, 1e308, std::numeric_limits<double>::infinity(),
                         std::numeric_limits<double>::quiet_NaN()}) {
    CAPTURE(x);
    CHECK(!(all(x).error < 1));
  }
  for (const double x : {0.0, 5e-324, 1e-300}) {
    CHECK(all(x).turn[0] == 1);
    CHECK(std::abs(all(x).turn[1] - x) <= 1e-15 * x + 5e-324);
    CHECK(all(x).error <= 1e-300);
  }
}
