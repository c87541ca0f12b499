// Distance and interpolation on SO(3).
#include "elements.hpp"

using namespace rotor;
using namespace rotor::reference;

namespace {

// The relative rotation is a product read as an angle: twice the quaternion's error.
constexpr double kDistance = 2 * kComposition;
// A slerp is the relative rotation, a part of it, and a product: 2 kComposition of operator each
// for the products, an ulp of pi for the angle of the step, taken round a half turn at most.
const double kSlerp = 4 * kComposition + ulp(kPi);

Wide spherical(const Rotation& r, const Rotation& s, double fraction, Way way) {
  // sin((1 - f) A)/sin A p + sin(f A)/sin A q, A the angle between p and q on S3, of the sign that
  // is near (short) or far (long).
  const Wide p = wide(r);
  Wide q = wide(s);
  if ((p.dot(q) < 0) == (way == Way::kShort)) q.coeffs() *= -1;
  const Extended a =
      2 * std::atan2((p.coeffs() - q.coeffs()).norm(), (p.coeffs() + q.coeffs()).norm());
  Wide result;
  result.coeffs() =
      (std::sin((1 - Extended(fraction)) * a) * p.coeffs() + std::sin(fraction * a) * q.coeffs()) /
      std::sin(a);
  return result;
}

std::string both(const Rotation& r, const Rotation& s) {
  return described(r) + ", " + described(s);
}

}  // namespace

TEST_CASE("distance: symmetric, in [0, pi], zero on the diagonal, true") {
  const auto all = elements(60, 501);
  Worst truth, diagonal, relative;
  for (const Rotation& r : all) {
    diagonal.add(distance(r, r), [&] { return described(r); });
    for (const Rotation& s : all) {
      const auto where = [&] { return both(r, s); };
      const double d = distance(r, s);
      truth.add(std::abs(d - operator_error(r, s)), where);
      relative.add(std::abs(d - (r.inverse() * s).canonical().angle()), where);
      if (d != distance(s, r) || !(0 <= d && d <= kPi)) {
        INFO(where());
        CHECK(d == distance(s, r));
        CHECK(d >= 0);
        CHECK(d <= kPi);
      }
    }
  }
  truth.within("distance", kDistance);
  diagonal.within("distance(R, R)", kCancelled);
  relative.within("angle of R^-1 S", kDistance + ulp(kPi));
}

TEST_CASE("distance: the same from every side, and the triangle inequality") {
  const std::uint64_t seed = 502;
  CAPTURE(seed);
  Draw draw(seed);
  Worst left, right, triangle;
  for (int i = 0; i < 5000; ++i) {
    const Rotation r = draw.rotation(), s = draw.rotation(), t = draw.rotation();
    const double d = distance(r, s);
    const auto where = [&] { return both(r, s) + ", " + described(t); };
    left.add(std::abs(distance(t * r, t * s) - d), where);
    right.add(std::abs(distance(r * t, s * t) - d), where);
    triangle.add(d - distance(r, t) - distance(t, s), where);
  }
  left.within("d(TR, TS) = d(R, S)", 2 * kDistance + 4 * kComposition);
  right.within("d(RT, ST) = d(R, S)", 2 * kDistance + 4 * kComposition);
  triangle.within("triangle inequality", 3 * kDistance);
}

TEST_CASE("distance: small and half-turn ones") {
  const Vector n(0.3, -0.5, 0.8);
  CHECK(distance({n, 1e-300}, {n, 3e-300}) == Approx(2e-300).epsilon(1e-15).margin(0));
  CHECK(distance({n, 0}, {n, kPi}) == kPi);
  CHECK(distance({{1, 0, 0}, kPi}, {{0, 1, 0}, kPi}) == kPi);
  CHECK(distance({n, 1}, {n, 1 + 2 * kPi}) <= 1e-15);  // 1 + 2 pi is rounded by half an ulp of 8
  CHECK(distance({n, 3}, {n, -3}) == Approx(2 * kPi - 6).epsilon(1e-14));
}

TEST_CASE("slerp: end points") {
  const std::uint64_t seed = 503;
  CAPTURE(seed);
  const auto all = elements(60, seed);
  Draw draw(seed);
  const auto any = [&]() -> const Rotation& {
    return all[std::size_t(draw.below(int(all.size())))];
  };
  Worst starts, ends;
  for (int i = 0; i < 8000; ++i) {
    const Rotation &r = any(), &s = any();
    const auto where = [&] { return both(r, s); };
    for (Way way : {Way::kShort, Way::kLong}) {
      starts.add(operator_error(slerp(r, s, 0, way), r), where);
      ends.add(operator_error(slerp(r, s, 1, way), s), where);
    }
  }
  starts.within("slerp at 0", kSlerp);
  // The long step is a difference of two angles: one ulp of 2 pi more.
  ends.within("slerp at 1", kSlerp + ulp(2 * kPi));
}

TEST_CASE("slerp: the arc of S3, at constant rate") {
  const std::uint64_t seed = 504;
  CAPTURE(seed);
  Draw draw(seed);
  Worst arc, rate;
  for (int i = 0; i < 5000; ++i) {
    const Rotation r = draw.rotation(), s = draw.rotation();
    const double d = distance(r, s), f = draw.uniform(0, 1);
    // The axis of the step has an error of kComposition / sin(d/2); near pi the way is a toss.
    if (d < 0.1 || d > kPi - 1e-6) continue;
    const auto where = [&] { return both(r, s) + " at " + text(f); };
    rate.add(std::abs(distance(r, slerp(r, s, f)) - f * d), where);
    for (Way way : {Way::kShort, Way::kLong}) {
      const double magnified = 1 + 1 / std::sin(d / 2);
      arc.add(
          operator_error(wide(slerp(r, s, f, way)), spherical(r, s, f, way)) / Extended(magnified),
          where);
    }
  }
  arc.within("slerp, over the magnification of the axis error", kSlerp);
  rate.within("d(R, slerp) = f d(R, S)", kSlerp + 2 * kDistance);
}

TEST_CASE("slerp: the long way goes round the other side") {
  const Rotation r, s({0, 0, 1}, 1);
  within(operator_error(slerp(r, s, 0.5), Rotation({0, 0, 1}, 0.5)), kSlerp);
  within(operator_error(slerp(r, s, 0.5, Way::kLong), Rotation({0, 0, 1}, 0.5 - kPi)), kSlerp);
  within(operator_error(slerp(r, s, 0.25, Way::kLong), Rotation({0, 0, 1}, 0.25 - kPi / 2)),
         kSlerp);
}

TEST_CASE("slerp: at distance pi the axis of N3 decides") {
  for (double angle : {kPi, -kPi}) {
    for (double z : {1.0, -1.0}) {
      CAPTURE(angle, z);
      const Rotation half({0, 0, z}, angle);
      within(operator_error(slerp({}, half, 0.5), Rotation({0, 0, 1}, kPi / 2)), kSlerp);
      within(operator_error(slerp({}, half, 0.5, Way::kLong), Rotation({0, 0, 1}, -kPi / 2)),
             kSlerp);
    }
  }
}

TEST_CASE("slerp: between equal operators nothing moves") {
  const Rotation r({0.3, -0.5, 0.8}, 2);
  for (double f : {0.0, 0.3, 1.0}) {
    CAPTURE(f);
    within(operator_error(slerp(r, r, f), r), kSlerp);
  }
}
