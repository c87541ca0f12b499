// Splines against splines.csv, against the scalar cubic spline, and against what defines them:
// nodes, continuity, end conditions, order.
#include "rotation/spline.hpp"

#include "elements.hpp"
#include "refusal.hpp"
#include "rotation/random.hpp"

using namespace rotor;
using namespace rotor::reference;

namespace {

// As in make_kinematics.py.
const std::vector<double> kTimes = {0, 1, 1.5, 4};
const std::vector<Rotation> kRotations = {
    {{1, 0, 0}, 0.3}, {{0, 1, 0}, 1.1}, {{0, 0, 1}, -0.9}, {{1, 0, 0}, -2.0}};
const Spline::EndRates kEndRates = {{0.5, -1.0, 0.25}, {-0.75, 0.0, 1.5}};

struct Waypoints {
  std::vector<double> times;
  std::vector<Rotation> rotations;
};

// Neighbours up to `most` apart, the lengths of the segments over two orders of magnitude.
Waypoints waypoints(Draw& draw, int count, double most) {
  Waypoints data{{draw.uniform(-5, 5)}, {draw.rotation()}};
  for (int i = 1; i < count; ++i) {
    data.times.push_back(data.times.back() + std::pow(10, draw.uniform(-1, 1)));
    const Rotation turn(draw.vector(), draw.uniform(-most, most));
    data.rotations.push_back(data.rotations.back() * turn);
  }
  return data;
}

}  // namespace

TEST_CASE("splines against the true solution of their equations") {
  // The axes are exact; rounding errors of extended precision stay far below those of the results:
  // kComposition in the quaternion, half an ulp of a component, 0.87 of the length, in the rates.
  const Spline natural(kTimes, kRotations);
  const Spline clamped(kTimes, kRotations, kEndRates);
  for (Row& row : table("rotation/splines.csv")) {
    const bool is_natural = row.number() != 0;
    const double t = row.number();
    std::array<Exact, 4> q;
    std::array<Exact, 3> omega, acceleration;
    row.read(q);
    row.read(omega);
    row.read(acceleration);
    const Spline& spline = is_natural ? natural : clamped;
    CAPTURE(is_natural, t);
    const Eigen::Vector4d measured = components(spline(t).quaternion());
    // The table's quaternion follows each segment from a node of its own sign.
    Eigen::Matrix<Extended, 4, 1> same = errors(measured, q),
                                  opposite = errors((-measured).eval(), q);
    within(std::min(same.norm(), opposite.norm()), kComposition);
    const auto check = [](const Vector& value, const std::array<Exact, 3>& exact) {
      within(errors(value, exact).norm(), 1.2e-16 * norm(value) + 1e-17);
    };
    check(spline.omega(t), omega);
    check(spline.acceleration(t), acceleration);
  }
}

TEST_CASE("a spline goes through its rotations, its quaternion without a jump") {
  Draw draw(60);
  for (int i = 0; i < 40; ++i) {
    const Waypoints data = waypoints(draw, 2 + draw.below(12), 2.5);
    const Spline spline(data.times, data.rotations);
    CAPTURE(i);
    CHECK(spline.times() == data.times);
    for (std::size_t k = 0; k < data.times.size(); ++k) {
      within(operator_error(spline(data.times[k]), data.rotations[k]), 2 * kComposition);
    }
    Wide before = wide(data.rotations.front());
    const double t0 = data.times.front(), t1 = data.times.back();
    for (int k = 0; k <= 5000; ++k) {
      const double t = std::min(t1, t0 + (t1 - t0) * k / 5000);
      const Wide now = wide(spline(t));
      REQUIRE((now.coeffs() - before.coeffs()).norm() < 0.5);
      before = now;
    }
  }
}

TEST_CASE("angular velocity and acceleration are the derivatives, continuous at the nodes") {
  Draw draw(61);
  Worst velocity, acceleration, jump;
  for (int i = 0; i < 40; ++i) {
    const Waypoints data = waypoints(draw, 3 + draw.below(8), 2.0);
    const Spline spline(data.times, data.rotations);
    double fastest = 0, sharpest = 0, shortest = 1;
    for (std::size_t k = 1; k < data.times.size(); ++k)
      shortest = std::min(shortest, data.times[k] - data.times[k - 1]);
    const double t0 = data.times.front(), t1 = data.times.back();
    for (int k = 0; k <= 1000; ++k) {
      const double t = std::min(t1, t0 + (t1 - t0) * k / 1000);
      fastest = std::max(fastest, norm(spline.omega(t)));
      sharpest = std::max(sharpest, norm(spline.acceleration(t)));
    }
    // The scale of the third derivative: a segment's cubic and its turning.
    const double third = 40 * (sharpest / shortest + fastest * sharpest + std::pow(fastest, 3));
    const double d = 1e-5 * shortest;
    const auto where = [&] { return "data " + std::to_string(i); };
    for (std::size_t k = 1; k + 1 < data.times.size(); ++k) {
      const double t = data.times[k];
      // On either side of the node d/2 times the next derivative, and the rounding of t over d.
      const Vector rate = spline.acceleration(t);
      const Vector left = (spline.omega(t) - spline.omega(t - d)) / d;
      const Vector right = (spline.omega(t + d) - spline.omega(t)) / d;
      const double bound = third * d + 1e-14 * (fastest + sharpest * (1 + std::abs(t))) / d;
      acceleration.add((left - rate).norm() / bound, where);
      acceleration.add((right - rate).norm() / bound, where);
      // R(t + d) R(t - d)^-1 is 2 d omega, to d^3/3 of the second derivative.
      const Rotation step = spline(t + d) * spline(t - d).inverse();
      const Vector turn =
          step.angle() > kPi ? Vector(step.axis() * (step.angle() - 2 * kPi)) : step.euler_vector();
      const double bound_turn = third * d * d + (2e-15 + 1e-15 * fastest * (1 + std::abs(t))) / d;
      velocity.add((turn / (2 * d) - spline.omega(t)).norm() / bound_turn, where);
      // The doubles on both sides of t.
      const double before = std::nextafter(t, -HUGE_VAL);
      const double gap = t - before;
      jump.add(
          (spline.acceleration(before) - rate).norm() / (gap * third + 1e-15 * sharpest + 1e-300),
          where);
    }
  }
  velocity.within("omega over its bound", 1);
  acceleration.within("acceleration over its bound", 1);
  jump.within("jump of the acceleration over its bound", 1);
}

TEST_CASE("ends: no angular acceleration, or the rates given") {
  Draw draw(62);
  for (int i = 0; i < 40; ++i) {
    const Waypoints data = waypoints(draw, 2 + draw.below(6), 2.0);
    const double t0 = data.times.front(), t1 = data.times.back();
    CAPTURE(i);
    const Spline natural(data.times, data.rotations);
    const double size = norm(natural.acceleration((t0 + t1) / 2)) + norm(natural.omega(t0));
    // Terms of the size of omega/h cancel in extended precision.
    CHECK(norm(natural.acceleration(t0)) < 1e-15 * (size + 100));
    CHECK(norm(natural.acceleration(t1)) < 1e-15 * (size + 100));
    const Spline::EndRates rates{draw.vector(), draw.vector()};
    const Spline clamped(data.times, data.rotations, rates);
    CHECK((clamped.omega(t0) - rates.first).norm() < 4.5e-16);
    CHECK((clamped.omega(t1) - rates.last).norm() < 4.5e-16);
  }
}

TEST_CASE("two rotations are joined by their geodesic at constant rate") {
  Draw draw(63);
  for (int i = 0; i < 200; ++i) {
    const Rotation r = draw.rotation(), s = draw.rotation();
    const Spline spline({-1, 3}, {r, s});
    CAPTURE(i, described(r), described(s));
    for (const double x : {0.0, 0.1, 0.5, 0.9, 1.0}) {
      within(operator_error(spline(-1 + 4 * x), slerp(r, s, x)), 2e-15);
      CHECK(std::abs(norm(spline.omega(-1 + 4 * x)) - distance(r, s) / 4) < 4.5e-16);
    }
  }
}

TEST_CASE("about a fixed axis the angle is the natural cubic spline") {
  // The scalar spline by its second derivatives m: h_i-1 m_i-1 + 2(h_i-1 + h_i) m_i + h_i m_i+1 =
  // 6 (slope_i - slope_i-1), m = 0 at the ends; solved by relaxation, which converges for it.
  Draw draw(64);
  const std::size_t n = 9;
  std::vector<double> t{0}, angle{0.5};
  for (std::size_t i = 1; i < n; ++i) {
    t.push_back(t.back() + draw.uniform(0.5, 2));
    angle.push_back(angle.back() + draw.uniform(-3, 3));  // many turns in all
  }
  std::vector<Extended> m(n, 0);
  const auto h = [&](std::size_t i) { return Extended{t[i + 1]} - t[i]; };
  const auto slope = [&](std::size_t i) { return (Extended{angle[i + 1]} - angle[i]) / h(i); };
  for (int sweep = 0; sweep < 100; ++sweep) {
    for (std::size_t i = 1; i + 1 < n; ++i) {
      m[i] = (6 * (slope(i) - slope(i - 1)) - h(i - 1) * m[i - 1] - h(i) * m[i + 1]) /
             (2 * (h(i - 1) + h(i)));
    }
  }
  const Vector axis(2, -1, 2);
  std::vector<Rotation> rotations;
  rotations.reserve(n);
  for (const double a : angle) rotations.emplace_back(axis, a);
  const Spline spline(t, rotations);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    for (const double x : {0.0, 0.2, 0.5, 0.7}) {
      const double at = t[i] + x * (t[i + 1] - t[i]);
      const Extended b = (at - Extended{t[i]}), a = h(i) - b;
      const Extended value = (m[i] * a * a * a + m[i + 1] * b * b * b) / (6 * h(i)) +
                             (angle[i] / h(i) - m[i] * h(i) / 6) * a +
                             (angle[i + 1] / h(i) - m[i + 1] * h(i) / 6) * b;
      const Extended rate =
          (m[i + 1] * b * b - m[i] * a * a) / (2 * h(i)) + slope(i) - (m[i + 1] - m[i]) * h(i) / 6;
      CAPTURE(i, x);
      // Angles of up to 10 are rounded to 9e-16; the axis, 1.1e-16 off, is the same everywhere.
      within(operator_error(spline(at), {axis, double(value)}), 2e-15);
      within((spline.omega(at) - axis / 3 * double(rate)).norm(), 1e-15);
    }
  }
}

TEST_CASE("constant angular velocity is reproduced") {
  const Vector omega(0.3, -0.4, 1.2);
  const Rotation start({1, 2, -2}, 1);
  std::vector<double> times{0, 0.5, 2, 2.25, 4};
  std::vector<Rotation> rotations;
  for (const double t : times) rotations.push_back(Rotation(omega, 1.3 * t) * start);
  const Spline spline(times, rotations);
  for (double t = 0; t <= 4; t += 0.125) {
    CAPTURE(t);
    within(operator_error(spline(t), Rotation(omega, 1.3 * t) * start), 2e-15);
    // The rotations given are rounded to 5e-16, over steps of a quarter at least, and the condition
    // of the spline of about 3.
    within((spline.omega(t) - omega).norm(), 6e-15);
    within(spline.acceleration(t).norm(), 2e-13);
  }
}

TEST_CASE("a smooth motion is met with the fourth order") {
  // exp(t k) exp(sin t i): omega = k + cos t (exp(t k) i).
  const auto motion = [](double t) {
    return Rotation({0, 0, 1}, t) * Rotation({1, 0, 0}, std::sin(t));
  };
  const auto rate = [](double t) {
    return Vector(std::cos(t) * std::cos(t), std::cos(t) * std::sin(t), 1);
  };
  double last = 0;
  for (const int n : {16, 32, 64, 128}) {
    std::vector<double> times;
    std::vector<Rotation> rotations;
    for (int i = 0; i <= n; ++i) {
      times.push_back(4.0 * i / n);
      rotations.push_back(motion(times.back()));
    }
    const Spline spline(times, rotations, Spline::EndRates{rate(0), rate(4)});
    Extended worst = 0;
    for (int i = 0; i < 1000; ++i) {
      worst = std::max(worst, operator_error(spline(i * 0.004), motion(i * 0.004)));
    }
    CAPTURE(n, double(worst), last);
    // h^4/384 of a fourth derivative of some 5, and what the Euler vector's curving adds.
    CHECK(double(worst) < 0.1 * std::pow(4.0 / n, 4));
    // A ratio of 16 per halving, to the terms of the next order.
    if (last > 0) CHECK(last / double(worst) == Approx(16).epsilon(0.15));
    last = double(worst);
  }
}

TEST_CASE("a change of frame or of the unit of time changes nothing else") {
  Draw draw(65);
  const Rotation turn = draw.rotation();
  std::vector<Rotation> turned;
  for (const Rotation& r : kRotations) turned.push_back(turn * r);
  const Spline spline(kTimes, kRotations), other(kTimes, turned);
  for (const double t : {0.1, 1.2, 3.0}) {
    within(operator_error(other(t), turn * spline(t)), 3e-15);
    within((other.omega(t) - turn * spline.omega(t)).norm(), 3e-14);
  }
  for (const double unit : {1e-300, 1e-9, 1e12, 1e300}) {
    std::vector<double> times;
    for (const double t : kTimes) times.push_back(unit * t);
    const Spline scaled(times, kRotations);
    CAPTURE(unit);
    for (const double t : {0.5, 1.25, 3.0}) {
      within(operator_error(scaled(t * unit), spline(t)), 3e-15);
      within((scaled.omega(t * unit) * unit - spline.omega(t)).norm(), 3e-15);
    }
  }
}

TEST_CASE("refused: what no spline goes through") {
  const Rotation r, s({0, 0, 1}, 1);
  refused([&] { Spline({}, {}); }, {"spline", "two", "0"});
  refused([&] { Spline({0}, {r}); }, {"two", "1"});
  refused([&] { Spline({0, 1, 2}, {r, s}); }, {"3 and 2"});
  refused([&] { Spline({0, 0}, {r, s}); }, {"rise", "0.0 after 0.0"});
  refused([&] { Spline({1, 0}, {r, s}); }, {"rise", "0.0 after 1.0"});
  refused([&] { Spline({0, HUGE_VAL}, {r, s}); }, {"times", "inf"});
  refused([&] { Spline({std::nan(""), 1}, {r, s}); }, {"times", "nan"});
  refused([&] { Spline({0, 1, 2}, {r, s, {{0, 0, 1}, 1 + kPi}}); }, {"2 and 3", "half a turn"});
  refused([&] { Spline({0, 1}, {r, {{0, 1, 0}, -3 * kPi}}); }, {"1 and 2", "half a turn"});
  refused(
      [&] {
        Spline({0, 1}, {r, s}, Spline::EndRates{{0, 0, HUGE_VAL}, {0, 0, 0}});
      },
      {"rates", "inf"});
  const Spline spline({0, 1}, {r, s});
  for (const double t : {-1e-9, 1.0 + 1e-9, std::nan("")}) {
    refused([&] { spline(t); }, {text(t), "0.0 .. 1.0"});
    refused([&] { spline.omega(t); }, {text(t), "outside"});
    refused([&] { spline.acceleration(t); }, {text(t), "outside"});
  }
  CHECK(Spline({0, 1}, {s, s})(0.5) == s);
}

TEST_CASE("a spline through uneven times, where Newton's method needs help") {
  // From the linear equations in one go it fails for the first eight of these seeds.
  for (const std::uint64_t seed : {93U, 97U, 167U, 253U, 281U, 332U, 339U, 414U, 1U, 2U}) {
    CAPTURE(seed);
    const std::vector<double> times = {0, 1, 11, 12, 22, 23, 33};
    const Spline spline(times, random_rotations(seed, times.size()));
    for (std::size_t i = 1; i + 1 < times.size(); ++i) {
      // Across the node, two doubles apart, a continuous acceleration changes by the jerk (its size
      // over a segment of length 1, at most 100) times 7e-15.
      const Vector before = spline.acceleration(std::nextafter(times[i], 0));
      const Vector after = spline.acceleration(times[i]);
      within(norm(before - after), 100 * 7e-15 * (1 + norm(after)));
    }
    // Newton's method stops at rates changed by 2^-52 of all of them, less than 10 together; over
    // segments of length 1 that is four times as much of acceleration.
    within(norm(spline.acceleration(0)), 1e-14);
    within(norm(spline.acceleration(33)), 1e-14);
  }
}
