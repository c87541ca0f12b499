// General quaternions [N24-N26]: product, inverse, polar form, exp, log and powers.
#include "rotation/quaternion.hpp"

#include <functional>

#include "elements.hpp"
#include "exact.hpp"
#include "refusal.hpp"

using namespace rotor;
using namespace rotor::reference;

namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();
const double kInf = std::numeric_limits<double>::infinity();

// Rounding to double once: each component by half an ulp, the length by no more, relatively.
const double kRounded = std::ldexp(1, -53);
// And an operation in Extended.
const double kWide = std::ldexp(1, -64);

const Quaternion kOne(1, 0, 0, 0), kI(0, 1, 0, 0), kJ(0, 0, 1, 0), kK(0, 0, 0, 1);

std::string described(const Quaternion& q) { return text(q); }

Extended relative_error(const Quaternion& measured, const std::array<Exact, 4>& exact) {
  Eigen::Matrix<Extended, 4, 1> size;
  for (std::size_t i = 0; i < 4; ++i) size[int(i)] = exact[i].hi;
  const Extended error = errors(components(measured), exact).norm();
  return size.isZero(0) ? error : error / size.norm();
}

Extended difference(const Quaternion& p, const Quaternion& q) {
  return (p.coeffs().cast<Extended>() - q.coeffs().cast<Extended>()).norm();
}

Quaternion draw_quaternion(Draw& draw, double size) {
  const Vector v = draw.vector();
  return {size * draw.uniform(-1, 1), size * v.x(), size * v.y(), size * v.z()};
}

Quaternion scaled(const Quaternion& q, double x) {
  return Quaternion(Eigen::Vector4d(q.coeffs() * x));
}

}  // namespace

TEST_CASE("exp, log and powers of quaternions against 50 digits") {
  Worst exps, logs, powers;
  std::vector<Row> rows = table("rotation/quaternion_functions.csv");
  for (Row& row : rows) {
    const double w = row.number();
    const Vector v = row.vector();
    const Quaternion q(w, v.x(), v.y(), v.z());
    const double x = row.number();
    std::array<Exact, 4> exact_exp, exact_log, exact_power;
    row.read(exact_exp);
    row.read(exact_log);
    row.read(exact_power);
    const auto where = [&] { return described(q) + " to the power " + text(x); };
    const Extended length = v.cast<Extended>().norm();
    // |v| and e^w are off by units of their last place, and so is the angle by |v| of them.
    if (exact_exp[0].hi != 0) {
      exps.add(relative_error(exp(q), exact_exp) / (kRounded + kWide * (8 + length)), where);
    }
    // ln|q| and theta/2: a few operations, none of which cancels.
    logs.add(relative_error(log(q), exact_log) / (kRounded + 8 * kWide), where);
    // The same errors, of the logarithm, times x; a repeated product of |x| factors has as many.
    const Extended log_size = std::abs(exact_log[0].hi) + kPi;
    powers.add(relative_error(power(q, x), exact_power) /
                   (kRounded + kWide * (16 + 8 * std::abs(x) * log_size)),
               where);
  }
  exps.within("exp", 1);
  logs.within("log", 1);
  powers.within("power", 1);
}

TEST_CASE("the units of quaternions: i i = j j = k k = -1, i j = k [N25]") {
  for (const Quaternion& unit : {kI, kJ, kK}) {
    CHECK(product(unit, unit) == scaled(kOne, -1));
    CHECK(power(unit, 2) == scaled(kOne, -1));
    CHECK(power(unit, 4) == kOne);
    CHECK(power(unit, -1) == unit.conjugate());
    CHECK(inverse(unit) == unit.conjugate());
  }
  CHECK(product(kI, kJ) == kK);
  CHECK(product(kJ, kI) == scaled(kK, -1));
  CHECK(product(kJ, kK) == kI);
  CHECK(product(kK, kI) == kJ);
}

TEST_CASE("the product of quaternions is that of 50 digits, rounded") {
  const std::uint64_t seed = 611;
  CAPTURE(seed);
  Draw draw(seed);
  Worst worst;
  for (int i = 0; i < 2000; ++i) {
    const Quaternion p = draw_quaternion(draw, std::pow(10, draw.uniform(-150, 150)));
    const Quaternion q = draw_quaternion(draw, std::pow(10, draw.uniform(-150, 150)));
    const auto exact = split(p.cast<Real>() * q.cast<Real>());
    worst.add(relative_error(product(p, q), exact), [&] { return described(p) + described(q); });
  }
  worst.within("relative", kRounded + 8 * kWide);
  CHECK(product(Quaternion(1e200, 0, 0, 0), Quaternion(0, 1e200, 0, 0)).x() == kInf);
}

TEST_CASE("whole powers are repeated products, of small whole numbers exactly") {
  CHECK(power({1, 2, 3, 4}, 2) == Quaternion(-28, 4, 6, 8));
  CHECK(power({1, 1, 1, 1}, 3) == Quaternion(-8, 0, 0, 0));
  CHECK(power({0, 1, 0, 0}, 1e15 + 3) == Quaternion(0, -1, 0, 0));
  const std::uint64_t seed = 612;
  CAPTURE(seed);
  Draw draw(seed);
  for (int i = 0; i < 200; ++i) {
    Quaternion q, repeated = kOne;
    for (int k = 0; k < 4; ++k) q.coeffs()[k] = draw.below(13) - 6;
    if (q.coeffs().isZero(0)) continue;
    for (int n = 0; n <= 12; ++n) {  // |q| <= 12, 12^12 < 2^44
      if (power(q, n) != repeated) FAIL_CHECK(described(q) << " to the power " << n);
      repeated = product(repeated, q);
    }
  }
}

TEST_CASE("laws of quaternions: inverse, exp and log, powers") {
  const std::uint64_t seed = 613;
  CAPTURE(seed);
  Draw draw(seed);
  Worst inverses, logs, roots, angles;
  for (int i = 0; i < 2000; ++i) {
    const Quaternion q = draw_quaternion(draw, std::pow(10, draw.uniform(-300, 300)));
    const auto where = [&] { return described(q); };
    inverses.add(difference(product(q, inverse(q)), kOne), where);
    inverses.add(difference(product(inverse(q), q), kOne), where);
    // A logarithm rounded at size |log q| moves its exp by as much, relatively.
    const Quaternion l = log(q);
    const double size = norm(l);
    logs.add(difference(exp(l), q) / norm(q) / (1 + size), where);
    const Quaternion root = power(q, 1 / 3.0);
    // 1/3 is rounded as well: by half an ulp, 2^-55, times the logarithm.
    roots.add(difference(power(root, 3), q) / norm(q) / (4 + size / 2), where);
    // The rotation's angle times x [polar form], where it does not leave [0, 2 pi].
    const Polar p = polar(q), r = polar(power(q, 0.75));
    angles.add(std::abs(r.rotation.angle() - 0.75 * p.rotation.angle()), where);
  }
  inverses.within("q q^-1 = 1", 3 * kRounded);
  logs.within("exp log q = q", 1.01 * kRounded);
  roots.within("cube of the cube root", 1.01 * kRounded);
  // Three angles of at most 2 pi rounded, and a quaternion whose rounding the half angle doubles.
  angles.within("angle times x", 3 * 4 * kRounded + 2 * kRounded + 1e-16);
}

TEST_CASE("polar form there and back: theta counts modulo 4 pi") {
  const std::uint64_t seed = 614;
  CAPTURE(seed);
  Draw draw(seed);
  Worst worst;
  for (int i = 0; i < 2000; ++i) {
    const Quaternion q = draw_quaternion(draw, std::pow(10, draw.uniform(-290, 300)));
    const Polar p = polar(q);
    worst.add(difference(from_polar(p.norm, p.rotation), q) / norm(q),
              [&] { return described(q); });
  }
  // As in the test of the polar form, and rounded once more.
  worst.within("relative", 4.5e-16 / 2 + 1e-16 + 2 * kRounded);
  const Vector axis(0.3, -0.5, 0.8);
  const Quaternion once = from_polar(2, {axis, 1}), turned = from_polar(2, {axis, 1 + 2 * kPi}),
                   twice = from_polar(2, {axis, 1 + 4 * kPi});
  // 1 + 2 pi and 2 pi are rounded by half an ulp of 7 and 6, 1 + 4 pi by as much as 13.
  CHECK(double(difference(turned, scaled(once, -1))) <= 2e-15);
  CHECK(double(difference(twice, once)) <= 4e-15);
  CHECK(from_polar(0, {axis, 1}) == Quaternion(0, 0, 0, 0));
  CHECK(from_polar(3, {axis, 0}) == Quaternion(3, 0, 0, 0));
}

TEST_CASE("awkward quaternions: negative numbers, tiny and huge ones, zero") {
  CHECK(log({-1, 0, 0, 0}) == Quaternion(0, kPi, 0, 0));
  CHECK(log({1, 0, 0, 0}) == Quaternion(0, 0, 0, 0));
  CHECK(log({1, 0, 5e-324, 0}) == Quaternion(0, 0, 5e-324, 0));
  CHECK(power({-4, 0, 0, 0}, 0.5).x() == 2);
  CHECK(std::abs(power({-4, 0, 0, 0}, 0.5).w()) <= 2 * 2e-19);
  CHECK(power({0, 0, 0, 0}, 0) == kOne);
  CHECK(power({0, 0, 0, 0}, 2.5) == Quaternion(0, 0, 0, 0));
  CHECK(power({1e-300, 0, 1e-300, 0}, 3) == Quaternion(0, 0, 0, 0));  // underflows as numbers do
  CHECK(power({1e300, 0, 0, 0}, -1) == Quaternion(1e-300, 0, 0, 0));
  CHECK(exp({-1e308, 1, 2, 3}) == Quaternion(0, 0, 0, 0));
  CHECK(exp({0, 5e-324, 0, 0}) == Quaternion(1, 5e-324, 0, 0));
  CHECK(inverse({0, 0, 4e-308, 0}).y() == Approx(-0.25e308).epsilon(1e-15));
  CHECK(inverse({1e308, 0, 0, 0}).w() == Approx(1e-308).epsilon(1e-15));
  CHECK(unit(Quaternion(0, 5e-324, 0, 0)) == kI);
}

TEST_CASE("refused: quaternions without logarithm, inverse or finite result") {
  const Quaternion zero(0, 0, 0, 0);
  CHECK(refusal([&] { log(zero); }) ==
        "log: expected a quaternion other than zero, got (0.0, 0.0, 0.0, 0.0)");
  CHECK(refusal([&] { inverse(zero); }).starts_with("inverse: expected"));
  CHECK(refusal([&] { unit(zero); }).starts_with("unit: expected"));
  CHECK(refusal([&] { power(zero, -1); }) == "zero has no power -1.0");
  CHECK(refusal([&] { power(zero, -0.5); }) == "zero has no power -0.5");
  CHECK(refusal([&] {
          inverse({0, 5e-324, 0, 0});
        }) == "inverse: that of (0.0, 5e-324, 0.0, 0.0) exceeds the largest double");
  CHECK(refusal([&] { exp({1e4, 1, 0, 0}); }).find("exceeds") != std::string::npos);
  CHECK(refusal([&] { exp({1e308, 0, 0, 0}); }).find("exceeds") != std::string::npos);
  CHECK(refusal([&] { power({1e300, 1e300, 0, 0}, 2); }).find("exceeds") != std::string::npos);
  CHECK(refusal([&] { power({1e-300, 0, 0, 0}, -20); }).find("exceeds") != std::string::npos);
  CHECK(refusal([&] { power({1e300, 0, 1, 0}, 1e308); }).find("exceeds") != std::string::npos);
  CHECK(refusal([&] { from_polar(-1, {}); }) ==
        "from_polar: expected a finite norm, 0 or more, got -1.0");
  for (const double bad : {kNan, kInf, -kInf}) {
    CAPTURE(bad);
    const Quaternion q(1, 0, bad, 0);
    for (const auto& call : std::vector<std::function<void()>>{
             [&] { log(q); }, [&] { exp(q); }, [&] { inverse(q); }, [&] { unit(q); },
             [&] { power(q, 2); }, [&] { power(q, 0.5); }, [&] { continuous_quaternions({q}); },
             [&] { power(kI, bad); }, [&] { from_polar(bad, {}); }}) {
      CHECK(refusal(call).find(text(bad)) != std::string::npos);
    }
  }
}

TEST_CASE("continuous quaternions: a turn counted on, whatever the signs were") {
  std::vector<Quaternion> truth, shuffled;
  Draw draw(615);
  for (int i = 0; i <= 100; ++i) {
    const Quaternion q = Rotation({1, 2, -3}, 0.2 * i).quaternion();  // 20 rad: three turns
    truth.push_back(q);
    shuffled.push_back(i > 0 && draw.below(2) == 0 ? scaled(q, -1) : q);
  }
  CHECK(continuous_quaternions(shuffled) == truth);
  shuffled[0] = scaled(shuffled[0], -1);
  CHECK(continuous_quaternions(shuffled)[100] == scaled(truth[100], -1));
  CHECK(continuous_quaternions({}).empty());
  // A product that would underflow or overflow still has its sign; one of 0 changes nothing.
  const Quaternion tiny(1e-200, 0, 0, 0), huge(-1e200, 1e200, 0, 0);
  CHECK(continuous_quaternions({tiny, scaled(tiny, -1)})[1] == tiny);
  CHECK(continuous_quaternions({huge, scaled(huge, -1)})[1] == huge);
  CHECK(continuous_quaternions({kI, scaled(kJ, -1)})[1] == scaled(kJ, -1));
}
