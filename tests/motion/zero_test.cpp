// Zeros of M that are no plain crossings: where the axis has no limit, what is undecided, what is a
// start; and the derivatives that tell the order.
#include <cmath>
#include <numbers>

#include "catch.hpp"
#include "motion/zero_of_m.hpp"
#include "motions.hpp"
#include "spin/models.hpp"

namespace {

using namespace rotor;
using namespace rotor::motions;
using Catch::Matchers::Contains;

constexpr double kPi = std::numbers::pi;

AngularVelocity function(AngularVelocity::Function f) { return {std::move(f)}; }

// [P6]: the integral of omega is t^3 (sin 1/t, cos 1/t, 0).
Vector pathological(double t) {
  if (t == 0) return Vector::Zero();
  const double s = std::sin(1 / t);
  const double c = std::cos(1 / t);
  return {3 * t * t * s - t * c, 3 * t * t * c + t * s, 0};
}

// At rest from t = 1 to 2, before it about k, after it about i.
Vector resting(double t) {
  if (t < 1) return {0, 0, -(1 - t) * (1 - t)};
  return t <= 2 ? Vector(0, 0, 0) : Vector(t - 2, 0, 0);
}

}  // namespace

TEST_CASE("the pathological omega of P6 has no axis at its start, and follows (sin, cos) of 1/t") {
  const Run run = evolve(scene(function(pathological), 0, 0.1, 1e-9), Rotation());
  CHECK(run(0).axis.hasNaN());
  CHECK(run(0).angle == 0);
  CHECK(run(0).euler_vector() == Vector(0, 0, 0));
  CHECK(run(0).rotation().angle() == 0);
  REQUIRE(run.notes().size() == 1);
  CHECK_THAT(run.notes()[0], Contains("at the start") && Contains("no limit"));
  CHECK(run.crossings().empty());
  for (const double t : {0.01, 0.03, 0.1}) {
    // theta/t^3 -> 1 and n = (sin 1/t, cos 1/t, 0) to 0.1 t^2 (theory 5).
    CAPTURE(t);
    const double error = run.propagator().error_estimate / std::pow(t, 3);
    CHECK(run(t).angle / std::pow(t, 3) == Approx(1).epsilon(0).margin(t * t + error));
    const Vector n = run(t).axis - Vector(std::sin(1 / t), std::cos(1 / t), 0);
    CHECK(n.head<2>().norm() < 0.02 * t * t + error);
    CHECK(std::abs(n.z()) == Approx(0.1 * t * t).epsilon(0.1).margin(error));
  }
}

TEST_CASE("where the body rests at the identity the axis has no limit, and the run says why") {
  for (const double sense : {1.0, -1.0}) {
    // theta = 1/3 about k falls to 0 at t = 1; backward the same from t = 3 about i.
    const bool forward = sense > 0;
    Scene request = scene(function(resting), forward ? 0 : 3, forward ? 3 : 0);
    request.breaks = {1, 2};
    const Rotation from(forward ? Vector(0, 0, 1) : Vector(1, 0, 0), forward ? 1.0 / 3 : 0.5);
    const Run run = evolve(request, from);
    const std::vector<Crossing> crossings = run.crossings();
    CAPTURE(sense);
    REQUIRE(crossings.size() == 1);
    CHECK(crossings[0].kind == Passage::kUndecided);
    CHECK(!crossings[0].order.has_value());
    CHECK(crossings[0].axis.hasNaN());
    CHECK(crossings[0].turn_before == crossings[0].turn_after);
    CHECK(std::abs(crossings[0].t - 1.5) + 0.5 <= crossings[0].t_error + 0.01);
    CHECK(crossings[0].t_error < 0.51);
    CHECK_THAT(crossings[0].note, Contains("at rest") && Contains("no limit"));
    CHECK(run(1.5).axis.hasNaN());
    CHECK(run(1.5).angle < 1e-14);
    CHECK((run(0.5).axis - Vector(0, 0, 1)).norm() < 1e-12);
    CHECK((run(2.5).axis - Vector(1, 0, 0)).norm() < 1e-12);
    CHECK(run(2.5).angle == Approx(0.125).epsilon(0).margin(1e-13));
    const Rates rates = run.rates(run(1.5), run.omega(1.5));
    CHECK(rates.angle_rate == 0);
    CHECK(rates.axis_rate.hasNaN());
  }
}

TEST_CASE(
    "at rest from the start: no axis at angle 0, at other multiples of 2 pi that of the start") {
  const auto zero = [](double) -> Vector { return Vector::Zero(); };
  const auto late = [](double t) { return Vector(t < 1 ? 0 : 1, 0, 0); };
  const Vector j(0, 1, 0);
  for (const double end : {0.75, 2.0}) {  // it does not depend on what comes later
    for (const auto& [omega, leaves] : {std::pair{AngularVelocity(Vector(0, 0, 0)), false},
                                        {function(zero), false},
                                        {function(late), true}}) {
      for (const int turns : {-1, 0, 1, 2}) {
        Scene request = scene(omega, 0, end);
        request.breaks = {1};
        const Run run = evolve(request, Rotation(j, 2 * kPi * turns));
        CAPTURE(end, omega.description(), turns);
        REQUIRE(run.notes().size() == 1);
        CHECK_THAT(run.notes()[0], Contains("at rest"));
        CHECK(run.crossings().empty());
        for (const double t : {0.25, 0.5}) {
          const State state = run(t);
          const Rates rates = run.rates(state, run.omega(t));
          // M of the start, sin of the double nearest to pi k, is not quite 0.
          CHECK(std::abs(state.angle - 2 * kPi * turns) <= 4 * kEpsilon * std::abs(turns));
          CHECK(rates.angle_rate == 0);
          if (turns == 0) {
            CHECK(state.axis.hasNaN());
            CHECK(rates.axis_rate.hasNaN());
            CHECK(state.euler_vector() == Vector(0, 0, 0));
          } else {
            CHECK(state.axis == j);
            CHECK(rates.axis_rate == Vector(0, 0, 0));
            CHECK(rates.euler_rate == Vector(0, 0, 0));
          }
        }
        if (leaves && end > 1) CHECK((run(1.5).axis - Vector(1, 0, 0)).norm() < 1e-14);
      }
    }
  }
}

TEST_CASE("where P6 is met on the way, or at the end, the run says that the axis has no limit") {
  // Whatever a method makes of the spin of n, it is faster than the run can tell.
  const Rotation at_minus_1 = [] {
    Scene request = scene(function(pathological), 0, -1);
    request.accuracy = 1e-8;
    return evolve(request, Rotation())(-1).rotation();
  }();
  for (const Method method : {Method::kFgl, Method::kDop853, Method::kRk4}) {
    for (const double end : {0.0, 1.0}) {
      Scene request = scene(function(pathological), -1, end, 1e-4);
      request.method = method;
      if (method == Method::kRk4) request.step = 0x1p-15;
      const Run run = evolve(request, at_minus_1);
      CAPTURE(static_cast<int>(method), end);
      CHECK(run(0).axis.hasNaN());
      REQUIRE(run.notes().size() == 1);
      CHECK_THAT(run.notes()[0], Contains("no limit"));
      const std::vector<Crossing> crossings = run.crossings();
      CHECK(crossings.size() == (end > 0 ? 1 : 0));
      for (const Crossing& crossing : crossings) {
        CHECK(crossing.kind == Passage::kUndecided);
        CHECK(crossing.axis.hasNaN());
        CHECK(std::abs(crossing.t) <= crossing.t_error);
      }
    }
  }
}

TEST_CASE("what is less than the tolerance is a crossing, four times that a near miss") {
  // omega = k: theta comes to `miss` of 2 pi. The tolerance is set; between, it is undecided.
  const auto with_miss = [](double miss, std::optional<double> tolerance) {
    const double aside = std::asin(std::sin(miss / 2) / std::sin(0.5));
    return evolve(scene(as_function(Vector(0, 0, 1)), 0, 7),
                  Rotation(Vector(std::sin(aside), 0, std::cos(aside)), 1), {}, {}, tolerance);
  };
  for (const double miss : {1e-3, 1e-8, 1e-12}) {
    CAPTURE(miss);
    CHECK(with_miss(miss, {}).crossings().empty());
    CHECK(with_miss(miss, {}).crossing_tolerance() < 1e-13);
    const Run undecided = with_miss(miss, miss / 2);
    CHECK(undecided.crossing_tolerance() == miss / 2);
    REQUIRE(undecided.crossings().size() == 1);
    const Crossing first = undecided.crossings()[0];
    CHECK(first.kind == Passage::kUndecided);
    CHECK(first.turn_after == first.turn_before);
    CHECK(first.distance == Approx(miss).epsilon(1e-3));
    CHECK_THAT(first.note, Contains("crossing_tolerance"));
    CHECK(undecided(6.9).axis.z() < -0.9);  // "back" is followed
    CHECK(with_miss(miss, miss / 8).crossings().empty());
    const Run through = with_miss(miss, 2 * miss);
    REQUIRE(through.crossings().size() == 1);
    CHECK(through.crossings()[0].kind == Passage::kThrough);
    CHECK(through(6.9).axis.z() > 0.9);
    CHECK(through(6.9).angle > 2 * kPi);
  }
  CHECK_THROWS_WITH(with_miss(1, 0.0), Contains("crossing_tolerance") && Contains("0.0"));
  CHECK_THROWS_AS(with_miss(1, std::nan("")), std::invalid_argument);
}

TEST_CASE(
    "where omega jumps at the zero, the motion and its derivatives disagree, and it is said") {
  // About k until theta = 2 pi at t = 1, then about i: omega there is k, the motion goes on along
  // i.
  Scene request =
      scene(function([](double t) { return t < 1 ? Vector(0, 0, 1) : Vector(1, 0, 0); }), 0, 2);
  request.breaks = {1};
  const Run run = evolve(request, Rotation(Vector(0, 0, 1), 2 * kPi - 1));
  REQUIRE(run.crossings().size() == 1);
  CHECK(run.crossings()[0].kind == Passage::kUndecided);
  CHECK(run.crossings()[0].axis.hasNaN());
  CHECK(!run.crossings()[0].note.empty());
  CHECK(run.notes().size() == 1);
  CHECK(std::abs(run(2).angle - (2 * kPi - 1)) < 1e-12);  // "back"
}

TEST_CASE("three crossings near one another are three, or what is left of them, but never two") {
  // theta = 2 pi + 0.7 s (s^2 - d^2) about an axis that turns; the angle at the end tells.
  const auto angle = [](double s, double d) { return 2 * kPi + 0.7 * s * (s * s - d * d); };
  for (const double d : {1e-4, 1e-3, 2e-3, 5e-3, 1e-2, 2e-2, 0.1}) {
    const auto omega = function([=](double t) -> Vector {
      const double s = t - 1;
      const double theta = angle(s, d);
      const Vector n(std::cos(s), std::sin(s), 0);
      const Vector rate(-std::sin(s), std::cos(s), 0);
      return 0.7 * (3 * s * s - d * d) * n + (1 - std::cos(theta)) * n.cross(rate) +
             std::sin(theta) * rate;  // [N15]
    });
    for (const Method method : {Method::kFgl, Method::kDop853}) {
      for (const double accuracy : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
        Scene request = scene(omega, 0, 2, accuracy);
        request.method = method;
        const Run run =
            evolve(request, Rotation(Vector(std::cos(1), -std::sin(1), 0), angle(-1, d)));
        CAPTURE(d, accuracy, run.crossings().size());
        CHECK(std::abs(run(2).angle - angle(1, d)) <= rotation_tolerance(run, 7));
        CHECK((run(2).axis - Vector(std::cos(1), std::sin(1), 0)).norm() <= axis_tolerance(run, 7));
        CHECK(run.crossings().size() % 2 == 1);
      }
    }
  }
}

TEST_CASE("beside a zero the axis goes on as omega does, where that jumps too") {
  // A crossing at t = 1 about k; omega turns aside at 1.05, which the run is told or is not.
  for (const bool told : {true, false}) {
    Scene request = scene(
        function([](double t) { return t < 1.05 ? Vector(0, 0, 1) : Vector(1, 0, 0); }), 0, 2);
    if (told) request.breaks = {1.05};
    const Run run = evolve(request, Rotation(Vector(0, 0, 1), -1));
    REQUIRE(run.crossings().size() == 1);
    for (const double t : times(0, 2, 200)) {
      const State state = run(t);
      CAPTURE(told, t);
      const double half = state.angle / 2;
      CHECK((state.axis * std::sin(half) - state.quaternion.vec()).norm() <=
            2 * run.propagator().error_estimate + 4 * kEpsilon);
    }
  }
}

TEST_CASE("a jump or a kink of omega on the zero leaves no axis, or says what it goes by") {
  // omega turns aside by 0.64 rad at t = 1, where theta = 2 pi: n jumps with it.
  const auto aside =
      function([](double t) { return t < 1 ? Vector(0, 0.6, 0.8) : Vector(0, 0, 1); });
  for (const bool told : {true, false}) {
    Scene request = scene(aside, 0, 2);
    if (told) request.breaks = {1};
    const Run run = evolve(request, Rotation(Vector(0, 0.6, 0.8), 2 * kPi - 1));
    CAPTURE(told);
    REQUIRE(run.crossings().size() == 1);
    CHECK(run.crossings()[0].kind == Passage::kThrough);
    CHECK(run.crossings()[0].axis.hasNaN());
    CHECK(!run.crossings()[0].note.empty());
    // 0.1 from the zero, theta/2 is 0.05: an error of 1e-10 in M turns the axis by 2e-9 at most.
    CHECK((run(0.9).axis - Vector(0, 0.6, 0.8)).norm() < 2e-9);
    CHECK((run(1.1).axis - Vector(0, 0, 1)).norm() < 2e-9);
  }
  // omega along k changes sign by a jump: theta turns back, and no derivative tells.
  const Run back =
      evolve(scene(function([](double t) { return Vector(0, 0, t < 1 ? 1 : -1); }), 0, 2),
             Rotation(Vector(0, 0, 1), -1));
  REQUIRE(back.crossings().size() == 1);
  CHECK(back.crossings()[0].kind == Passage::kBack);
  CHECK_THAT(back.crossings()[0].note, Contains("by the motion alone"));
  CHECK((back.crossings()[0].axis - Vector(0, 0, 1)).norm() < 1e-9);
}

TEST_CASE("a start at 2 pi k goes on with the axis that is nearer to its own") {
  // omega = (t^2, t, 0): n(0+) = +-j, n' = +-(2/3) i [Lemma 5.3, i = 1].
  const auto omega = function([](double t) { return Vector(t * t, t, 0); });
  for (const double t1 : {1.0, -1.0}) {
    for (const double turns : {-2.0, -1.0, 1.0, 2.0, 7.0}) {
      for (const double side : {1.0, -1.0}) {
        const Run run =
            evolve(scene(omega, 0, t1), Rotation(Vector(0.6, 0.8 * side, 0), 2 * kPi * turns));
        CAPTURE(t1, turns, side);
        CHECK(run(0).axis == Vector(0.6, 0.8 * side, 0));
        const double t = 1e-3 * t1;
        const State state = run(t);
        CHECK((state.axis - side * Vector(2 * t / 3, 1, 0)).norm() < 2e-6);
        CHECK(std::abs(state.angle - (2 * kPi * turns + side * t * t / 2)) <
              1e-11 + 8 * kEpsilon * 44);
        CHECK((run.rates(state, run.omega(t)).axis_rate - side * Vector(2.0 / 3, 0, 0)).norm() <
              2e-3);
        CHECK(run.crossings().empty());
      }
    }
  }
}

TEST_CASE("derivatives by differences are those of the jets, to the error that they state") {
  const auto model = std::make_shared<const TurningSpin>(Vector(1, 0.3, -2), Vector(1, 1, 0), 3);
  const AngularVelocity plain([&](double t) { return model->value(t); });
  const AngularVelocity with_jets(model);
  for (const double t : {0.0, 0.7, 5.0}) {
    const Derivatives exact = derivatives_at(with_jets, t, 0, 5);
    const Derivatives found = derivatives_at(plain, t, 0, 5);
    CHECK(exact.no_jets.empty());
    CHECK(!found.no_jets.empty());
    for (std::size_t k = 0; k < 6; ++k) {
      CAPTURE(t, k, found.error[k]);
      CHECK(norm(Vector(found.c[k] - exact.c[k])) <= found.error[k] + exact.error[k]);
      CHECK(found.error[k] < 1e-13 * std::pow(300, k));
    }
  }
  // A jump of the first derivative is no derivative.
  const AngularVelocity kink([](double t) { return Vector(1, std::abs(t - 1), 0); });
  const Derivatives at_kink = derivatives_at(kink, 1, 0, 2);
  CHECK(at_kink.differs_from_zero(0));
  CHECK(!at_kink.differs_from_zero(1));
}

TEST_CASE("the order of a zero is what M shows above its error") {
  const auto order = [](const AngularVelocity::Function& f, double t, double error) {
    const auto found = order_of_zero(AngularVelocity(f), t, error, 0, 2);
    return found ? static_cast<int>(found->order) : -1;
  };
  const auto power = [](int i, double offset) {
    return
        [=](double t) { return Vector(offset, std::pow(t - 1, i), 0.3 * std::pow(t - 1, i + 1)); };
  };
  for (const int i : {0, 1, 2, 3, 4}) {
    CAPTURE(i);
    // t is off by half of what the error makes of it.
    const double off = std::pow(2 * (i + 1) * 1e-12, 1.0 / (i + 1)) / 2;
    CHECK(order(power(i, 0), 1 + (i > 0 ? off : 0), 1e-12) == i);
  }
  // omega = 1e-9 i + (t - 1) j: M is away from an error of 1e-12 by its term of order 1 first, of
  // an error of 1e-22 by that of order 0.
  CHECK(order(power(1, 1e-9), 1, 1e-12) == 1);
  CHECK(order(power(1, 1e-9), 1, 1e-22) == 0);
  CHECK(order([](double) { return Vector(0, 0, 0); }, 1, 1e-12) == -1);
  CHECK(order(pathological, 0, 1e-12) == -1);
}

TEST_CASE("a start on 2 pi k long after t = 0 goes with omega as any other") {
  // n = omega/|omega| from the identity, and theta up from where n is that already [Lemma 5.3].
  const auto omega = [](double t) { return Vector(std::cos(5 * t), std::sin(5 * t), 1); };
  for (const double t0 : {1.0, 43.0, 300.0, 1e6}) {
    CAPTURE(t0);
    const Vector n = omega(t0).normalized();
    const Run run = evolve(scene(function(omega), t0, t0 + 2), Rotation());
    CHECK((run(t0).axis - n).norm() < 1e-9 + 5 * kEpsilon * t0);
    CHECK(run.rates(run(t0), omega(t0)).angle_rate == Approx(std::sqrt(2)).epsilon(1e-9));
    const Run turned = evolve(scene(function(omega), t0, t0 + 2), Rotation(n, 2 * kPi));
    CHECK(turned(t0 + 0.01).angle == Approx(2 * kPi + 0.01 * std::sqrt(2)).epsilon(1e-6));
    CHECK(turned(t0 + 0.01).axis.dot(n) > 0.99);
  }
}

TEST_CASE("a zero beside a near miss, between the same two samples, is found") {
  // omega = (a + t, 0.131 t, 0) is nearly zero at t = -a, and M nearly at -2 a; at 0 it is.
  const auto omega = function([](double t) { return Vector(0.0002573 + t, 0.131 * t, 0); });
  constexpr double kBegin = -1.4380108672586274;
  for (const Method method : {Method::kFgl, Method::kDop853}) {
    const Rotation there = evolve(scene(omega, kBegin, 0, 1e-14), Rotation())(0).rotation();
    Scene request = scene(omega, kBegin, 1.9408439164841624);
    request.method = method;
    const Run run = evolve(request, there.inverse());
    CAPTURE(static_cast<int>(method));
    REQUIRE(run.crossings().size() == 1);
    CHECK(run.crossings()[0].kind == Passage::kThrough);
    CHECK(std::abs(run.crossings()[0].t) <= run.crossings()[0].t_error);
    CHECK(run(-1e-6).axis.dot(run(1e-6).axis) > 0.99);
  }
}

TEST_CASE("after many turns the rounding of the start is no motion") {
  const Vector k(0, 0, 1);
  const auto faster = function([](double t) { return Vector(0, 0, 1 + 0.1 * t); });
  for (const double turns : {4.0, 60.0, 330.0, 1000.0, -1000.0, 31831.0}) {
    CAPTURE(turns);
    const double start = 2 * kPi * turns;
    const Run run = evolve(scene(faster, 0, 2), Rotation(k, start));
    CHECK(run.crossings().empty());
    for (const double t : {1e-15, 0.5, 2.0}) {
      CHECK((run(t).axis - k).norm() < 1e-9);
      CHECK(std::abs(run(t).angle - (start + t + 0.05 * t * t)) <
            1e-12 + kEpsilon * std::abs(start));
    }
    const Run rest = evolve(scene(Vector(0, 0, 0), 0, 2), Rotation(k, start));
    CHECK(rest(1).axis == k);
  }
}

TEST_CASE("from a rest at 2 pi a body leaves upward or downward, as its axis goes on") {
  for (const double side : {1.0, -1.0}) {
    const auto omega =
        function([side](double t) { return Vector(0, 0, t < 1 ? 0 : side * (t - 1)); });
    Scene request = scene(omega, 0, 3);
    request.breaks = {1};
    const Run run = evolve(request, Rotation(Vector(0, 0, 1), 2 * kPi));
    CAPTURE(side);
    CHECK((run(0.5).axis - Vector(0, 0, 1)).norm() == 0);
    CHECK((run(3).axis - Vector(0, 0, 1)).norm() < 1e-12);
    CHECK(run(3).angle == Approx(2 * kPi + 2 * side).epsilon(1e-12));
    CHECK(run.crossings().empty());
  }
}

TEST_CASE("a start on 2 pi whose derivatives tell nothing goes on with its axis") {
  const Vector k(0, 0, 1);
  for (const double side : {1.0, -1.0}) {
    const auto root = function([=](double t) { return Vector(0, 0, side * std::sqrt(t)); });
    const auto high = function([=](double t) { return Vector(0, 0, side * std::pow(t, 10)); });
    for (const double turns : {-1.0, 1.0, 2.0}) {
      CAPTURE(side, turns);
      const Run by_root = evolve(scene(root, 0, 1, 1e-9), Rotation(k, 2 * kPi * turns));
      CHECK(std::abs(by_root(1).angle - (2 * kPi * turns + side * 2 / 3)) < 1e-8);
      const Run by_high = evolve(scene(high, 0, 1), Rotation(k, 2 * kPi * turns));
      CHECK(std::abs(by_high(1).angle - (2 * kPi * turns + side / 11)) < 1e-9);
      for (const double t : {0.5, 1.0}) {
        CHECK((by_root(t).axis - k).norm() < 1e-8);
        CHECK((by_high(1).axis - k).norm() < 1e-8);
      }
    }
  }
}

TEST_CASE("a state at rest on 2 pi k does not depend on what was asked before") {
  const auto omega = function(
      [](double t) { return t < 1 ? Vector(0, 0, 2 * kPi) : Vector(t < 2 ? 0 : 1, 0, 0); });
  Scene request = scene(omega, 0, 4);
  request.breaks = {1, 2};
  for (const double t : {1.0, 1.2, 1.5, 1.9}) {
    const Run fresh = evolve(request, Rotation());
    const Run asked = evolve(request, Rotation());
    CHECK(asked.crossings().size() == 1);
    CAPTURE(t);
    CHECK(fresh(t).axis.hasNaN() == asked(t).axis.hasNaN());
  }
}
