// Jets of models against other routes to them, and the check of jets against values.
#include "spin/jet_check.hpp"

#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include "catch.hpp"
#include "rotation/text.hpp"
#include "spin/models.hpp"

namespace {

using rotor::Jet, rotor::Vector, rotor::VectorJet;

constexpr double kUnit = std::numeric_limits<double>::epsilon() / 2;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// What the check says of a scalar function with this jet.
template <class Function>
std::string verdict(const Jet& jet, double t, const Function& f) {
  try {
    rotor::check_jet(std::array{jet}, t, [&](double s) { return Vector(f(s), 0, 0); });
  } catch (const rotor::NotDifferentiable& e) {
    return e.what();
  }
  return "good";
}

}  // namespace

// f'' of the kinks below jumps by 2; the check sees that from 2^-2 M/T^2 on.
TEST_CASE("jets that are not those of the values are seen, on either side") {
  const auto foretell = Catch::Matchers::Contains("foretell");
  for (const double t : {-3.0, 0.0, 0.25, 1e6}) {
    CAPTURE(t);
    const Jet s = Jet::variable(t);
    const auto kink = [t](double x) { return x < t ? 0.0 : x - t; };
    const auto bend = [t](double x) { return x < t ? 0.0 : (x - t) * (x - t); };
    const Jet step = s - Jet::constant(t);
    CHECK_THAT(verdict(step, t, kink), foretell);
    CHECK_THAT(verdict(Jet::constant(0), t, kink), foretell);
    CHECK_THAT(verdict(step * step, t, bend), foretell);
    CHECK_THAT(verdict(Jet::constant(0), t, bend), foretell);
    CHECK_THAT(verdict(sin(s), t, [](double x) { return std::sin(1.01 * x); }),
               t == 0 ? foretell : Catch::Matchers::Contains("with a jet"));
    CHECK(verdict(sin(s), t, [](double x) { return std::sin(x); }) == "good");
    CHECK(verdict(step * step, t, [t](double x) { return (x - t) * (x - t); }) == "good");
  }
}

TEST_CASE("digits lost inside a function are no kink") {
  // 1 - cos x near zero is rounded as 1 is: at 2e-6 that is 6e-5 of it.
  for (const double t : {1.8734970692602e-06, 1e-5, 1e-3}) {
    CAPTURE(t);
    const Jet s = Jet::variable(t);
    const Jet lost = Jet::constant(1) - cos(s);
    CHECK(verdict(lost, t, [](double x) { return 1 - std::cos(x); }) == "good");
    CHECK(verdict(lost * lost, t, [](double x) { return (1 - std::cos(x)) * (1 - std::cos(x)); }) ==
          "good");
  }
}

TEST_CASE("jets that are right are accepted, of any size and speed") {
  for (const double size : {1e-310, 1e-300, 1e-8, 1.0, 1e200}) {
    for (const double speed : {1e-300, 1e-8, 1.0, 1e3, 1e8}) {
      for (const double t : {0.0, 1e-300, 1e-9, 0.7, 3.14159, -1e4, 1e9}) {
        CAPTURE(size, speed, t);
        const Jet x = Jet::variable(t) * speed;
        CHECK(verdict(sin(x) * size, t, [&](double s) { return std::sin(s * speed) * size; }) ==
              "good");
        CHECK(verdict(cos(x) * size, t, [&](double s) { return std::cos(s * speed) * size; }) ==
              "good");
        const Jet witch = Jet::constant(size) / (Jet::constant(1) + x * x);
        CHECK(verdict(witch, t, [&](double s) { return size / (1 + s * speed * (s * speed)); }) ==
              "good");
      }
    }
  }
}

TEST_CASE("where there is no value on one side the other decides") {
  const Jet s = Jet::variable(0);
  CHECK(verdict(s, 0, [](double x) { return x < 0 ? kNaN : x; }) == "good");
  CHECK(verdict(s, 0, [](double x) { return x > 0 ? kNaN : x; }) == "good");
  CHECK(verdict(s, 0, [](double x) { return x == 0 ? 0 : kNaN; }) ==
        "it has no values on either side");
  CHECK(verdict(s, 0, [](double x) { return x < 0 ? kNaN : 2 * x; }) != "good");
  CHECK(verdict(s, 0, [](double) { return kNaN; }) == "it gives nan");
  CHECK(verdict(Jet::constant(1), 0, [](double) { return 2.0; }) ==
        "called with a number it gives 2.0, with a jet 1.0 (t == 1 is true of no jet; t <= 1 can "
        "be)");
  Jet infinite = s;
  infinite.c[3] = std::numeric_limits<double>::infinity();
  CHECK(verdict(infinite, 0, [](double x) { return x; }) == "its derivative of order 3 is inf");
}

// Rodrigues' formula in jets, about an axis along which (1, 2, 3) has 3. A derivative of order k is
// rate^k times a vector no longer than sqrt(14); k cross products with a rounding of some 4 u each
// there, 8 (k + 1)^2 u here (jet_test.cpp).
TEST_CASE("a turning omega has the jet of its formula") {
  const double rate = 1.7;
  const rotor::TurningSpin spin(Vector(1, 2, 3), Vector(0, 0, 5), rate);
  for (const double t : {0.0, 0.4, -11.0}) {
    const Jet angle = Jet::variable(t) * rate;
    const VectorJet expected = {cos(angle) - sin(angle) * 2, sin(angle) + cos(angle) * 2,
                                Jet::constant(3)};
    const VectorJet jets = spin.jet(t);
    double factorial = 1;
    for (std::size_t k = 0; k <= Jet::kOrder; ++k) {
      factorial *= k > 0 ? double(k) : 1;
      const double scale = 4 * std::pow(rate, double(k)) / factorial;
      for (std::size_t i = 0; i < 3; ++i) {
        CAPTURE(t, k, i);
        CHECK(std::abs(jets[i].c[k] - expected[i].c[k]) <=
              (8.0 * double((k + 1) * (k + 1)) + 4 * double(k)) * kUnit * scale);
      }
    }
    CHECK_NOTHROW(rotor::check_jet(jets, t, [&](double s) { return spin.value(s); }));
  }
}

TEST_CASE("an omega along a direction has the jet of its rate, if that has one") {
  const rotor::ScalarFunction rate{
      .value = [](double t) { return t * t; },
      .jet = [](double t) { return pow(Jet::variable(t), Jet::constant(2)); },
      .name = "t^2"};
  const rotor::AlongSpin spin(Vector(0, 3, 4), rate);
  const VectorJet jets = spin.jet(5);
  CHECK(jets[0].c == Jet{}.c);
  CHECK(jets[1].derivative(1) == Approx(6));
  CHECK(jets[2].derivative(2) == Approx(1.6));
  const rotor::AlongSpin without(Vector(1, 0, 0), {.value = rate.value, .jet = {}, .name = "s"});
  CHECK_THROWS_AS(without.jet(0), rotor::NotDifferentiable);
}

TEST_CASE("where periods and pieces meet") {
  const auto period = [](double jump) {
    return rotor::PeriodicSpin(
        1, {std::make_shared<rotor::AlongSpin>(
               Vector(0, 0, 1),
               rotor::ScalarFunction{.value = [=](double t) { return jump * t; },
                                     .jet = [=](double t) { return Jet::variable(t) * jump; },
                                     .name = "s"})});
  };
  CHECK_NOTHROW(period(0).jet(-3));
  CHECK_NOTHROW(period(1).jet(2.5));
  CHECK_THROWS_AS(period(1).jet(-3), rotor::NotDifferentiable);
  const rotor::PiecewiseSpin pieces({1.0}, {Vector(1, 0, 0), Vector(2, 0, 0)});
  CHECK(pieces.jet(0.5)[0].c[0] == 1);
  CHECK(pieces.jet(1.5)[0].c[0] == 2);
  CHECK_THROWS_AS(pieces.jet(1), rotor::NotDifferentiable);
}
