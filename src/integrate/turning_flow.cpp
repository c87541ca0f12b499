// omega constant in a uniformly turning frame: the closed form.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "integrate/exact.hpp"
#include "integrate/recurrence.hpp"
#include "rotation/turn.hpp"

namespace rotor {
namespace {

// exp(axis rate t). The product has twice the digits of a double: what an extended number cannot
// hold of it turns about the same axis once more.
ExtendedQuaternion turn_by_product(const ExtendedVector& axis, double rate, double t) {
  const Extended angle = Extended{rate} * Extended{t};
  const double high = rate * t;
  if (!std::isfinite(high)) return turn(axis, angle);
  const Extended rest = (Extended{high} - angle) + Extended{std::fma(rate, t, -high)};
  return turn(axis, angle, rest);
}

// With R(t) = exp(k rate t) and p = v - rate k, the generator less the turning of the frame, both
// at t = 0, U(t) = R(t) exp(p (t - t0)) R(t0)*.
class TurningFlow final : public Flow {
 public:
  TurningFlow(const Vector& v, const TurningSpin& omega, double t0, double t1)
      : v_(v.cast<Extended>()),
        about_(omega.about()),
        rate_(omega.rate()),
        t0_(t0),
        t1_(t1),
        back_(turn_by_product(about_, rate_, t0).conjugate()) {
    const ExtendedVector p = v_ - rate_ * about_;
    own_rate_ = p.norm();
    if (own_rate_ != 0) own_axis_ = p / own_rate_;
  }

  Quaternion at(double t) const override {
    if (v_.isZero(0)) return Quaternion::Identity();
    const ExtendedQuaternion own = turn(own_axis_, own_rate_ * (Extended{t} - Extended{t0_}));
    return (frame_at(t) * own * back_).cast<double>();
  }

  Vector generator(double t) const override { return (frame_at(t) * v_).cast<double>(); }

  // The turning of the frame is part of the motion: it too is followed.
  std::vector<double> mesh() const override {
    const Extended rate = v_.isZero(0) ? Extended{0} : v_.norm() + std::abs(Extended{rate_});
    return even_mesh(t0_, t1_, static_cast<double>(rate * std::abs(Extended{t1_} - t0_)));
  }

  // <U, target> is bilinear in (cos, sin) of the two half angles x, of the frame, and y: it is
  // A cos(x - y - p) + B cos(x + y - q), so that U comes near where both cosines are nearly 1, or
  // nearly -1, and nowhere if A + B is less.
  std::vector<TimeSpan> approaches(const Quaternion& target, double distance) const override {
    const ExtendedQuaternion aim = target.cast<Extended>().normalized() * back_.conjugate();
    const ExtendedQuaternion frame = pure(rate_ == 0 ? ExtendedVector::Zero().eval() : about_);
    const ExtendedQuaternion own = pure(own_axis_);
    const Extended a = ExtendedQuaternion::Identity().dot(aim);
    const Extended b = own.dot(aim);
    const Extended c = frame.dot(aim);
    const Extended d = (frame * own).dot(aim);
    const Extended start = own_rate_ * t0_ / 2;
    const Wave difference{std::hypot(a + d, c - b) / 2, std::atan2(c - b, a + d),
                          (rate_ - own_rate_) / 2, start};
    const Wave sum{std::hypot(a - d, b + c) / 2, std::atan2(b + c, a - d), (rate_ + own_rate_) / 2,
                   -start};
    // 1 - |<U, target>| is half the square of the distance.
    constexpr Extended kRounding = 64 * std::numeric_limits<Extended>::epsilon();
    const Extended half_square = Extended{distance} * distance / 2 + kRounding;
    if (1 - difference.size - sum.size > half_square) return {};
    const bool sum_is_faster = std::abs(sum.rate) > std::abs(difference.rate);
    const Wave& fast = sum_is_faster ? sum : difference;
    if (fast.width(half_square) > 0.5L) return Flow::approaches(target, distance);
    return meetings(fast, sum_is_faster ? difference : sum, half_square);
  }

 private:
  // size cos(rate t + start - phase).
  struct Wave {
    Extended size;
    Extended phase;
    Extended rate;
    Extended start;

    // How far from a multiple of pi its argument may be where |cos| lacks no more than that.
    Extended width(Extended lack) const {
      const Extended sine = std::sqrt(lack / (2 * size));  // of half of it
      return sine < 0.7L ? 2 * std::asin(sine) : std::numbers::pi_v<Extended> / 2;
    }
    Extended at(Extended t) const { return rate * t + start - phase; }
  };

  // The faster wave is at a multiple of pi once in every half turn of it; of these, where the
  // slower one is too.
  std::vector<TimeSpan> meetings(const Wave& fast, const Wave& slow, Extended lack) const {
    constexpr Extended kPi = std::numbers::pi_v<Extended>;
    const Extended sense = t1_ >= t0_ ? 1 : -1;
    const Extended half_turn = kPi / std::abs(fast.rate);  // in time
    const Extended width = fast.width(lack);
    // From the one before the start to the one after the end.
    const Extended place = fast.at(t0_) * sense * (fast.rate > 0 ? 1 : -1) / kPi;
    const Extended first = t0_ - sense * half_turn * (place - std::floor(place));
    const Extended count = std::ceil(std::abs(Extended{t1_} - t0_) / half_turn) + 1;
    const Extended slow_width = slow.width(lack) + width * std::abs(slow.rate / fast.rate);
    std::vector<TimeSpan> spans;
    for (const std::uint64_t k :
         near_multiples_of_pi(sense * slow.rate * half_turn, slow.at(first), slow_width,
                              static_cast<std::uint64_t>(count))) {
      const Extended t = first + sense * half_turn * static_cast<Extended>(k);
      const auto far =
          static_cast<double>(width / std::abs(fast.rate)) +
          4 * std::numeric_limits<double>::epsilon() * static_cast<double>(std::abs(t));
      const auto [low, high] = std::minmax(t0_, t1_);
      const double begin = std::clamp(static_cast<double>(t - sense * far), low, high);
      const double end = std::clamp(static_cast<double>(t + sense * far), low, high);
      if (begin != end) spans.push_back({begin, end});
    }
    return spans;
  }

  // R(t). U and its generator are often asked for one after the other.
  ExtendedQuaternion frame_at(double t) const {
    if (t != frame_t_) {
      frame_ = turn_by_product(about_, rate_, t);
      frame_t_ = t;
    }
    return frame_;
  }

  static ExtendedQuaternion pure(const ExtendedVector& v) { return {0, v.x(), v.y(), v.z()}; }

  ExtendedVector v_;      // the generator at t = 0
  ExtendedVector about_;  // k, unit
  double rate_;
  double t0_;
  double t1_;
  ExtendedQuaternion back_;                           // R(t0)*
  ExtendedVector own_axis_ = ExtendedVector::Zero();  // p/|p|
  Extended own_rate_ = 0;
  mutable double frame_t_ = std::numeric_limits<double>::quiet_NaN();
  mutable ExtendedQuaternion frame_;  // R there
};

}  // namespace

void follow_turning(const Scene& scene, const TurningSpin& omega, Propagator& result) {
  const Extended rates = omega.vector().cast<Extended>().norm() + std::abs(Extended{omega.rate()});
  const Extended longest = std::max(std::abs(Extended{scene.t0}), std::abs(Extended{scene.t1}));
  if (!std::isfinite(static_cast<double>(rates * 2 * longest))) {
    throw std::invalid_argument(
        "(omega and the rate of its turning) t is too large to be an angle");
  }
  // The angles of the frame are exact. Of p = v - rate k the product (1 ulp, and 2 of k), the
  // difference, the norm (3) and its product with the time (2) are rounded, each by half an ulp;
  // the quaternion by that of a double in each component: an error of the rotation of an ulp of 1.
  constexpr double kRounding = std::numeric_limits<double>::epsilon();
  constexpr auto kOfAngle = 4 * static_cast<double>(std::numeric_limits<Extended>::epsilon());
  const Extended way = std::abs(Extended{scene.t1} - scene.t0);
  result.error_estimate = kOfAngle * static_cast<double>(rates * way) + 4 * kRounding;
  const double sign = scene.omega.frame() == Frame::kSpace ? 1 : -1;
  result.flow = std::make_shared<TurningFlow>(sign * omega.vector(), omega, scene.t0, scene.t1);
  result.t1 = scene.t1;
}

}  // namespace rotor
