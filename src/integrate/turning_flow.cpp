// omega constant in a uniformly turning frame: the closed form.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include "integrate/exact.hpp"
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
  return turn(axis, angle) * turn(axis, rest);
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
    return (turn_by_product(about_, rate_, t) * own * back_).cast<double>();
  }

  Vector generator(double t) const override {
    return (turn_by_product(about_, rate_, t) * v_).cast<double>();
  }

  // The turning of the frame is part of the motion: it too is followed.
  std::vector<double> mesh() const override {
    const Extended rate = v_.isZero(0) ? Extended{0} : v_.norm() + std::abs(Extended{rate_});
    return even_mesh(t0_, t1_, static_cast<double>(rate * std::abs(Extended{t1_} - t0_)));
  }

  // <U, target> is bilinear in (cos, sin) of the two half angles. Were these independent, it would
  // reach the greatest singular value s of its matrix, at the distance (2 - 2s)^(1/2).
  bool can_reach(const Quaternion& target, double distance) const override {
    const ExtendedQuaternion aim = target.cast<Extended>().normalized() * back_.conjugate();
    const ExtendedQuaternion one = ExtendedQuaternion::Identity();
    const ExtendedQuaternion frame = pure(rate_ == 0 ? ExtendedVector::Zero().eval() : about_);
    const ExtendedQuaternion own = pure(own_axis_);
    const Extended a = one.dot(aim);
    const Extended b = own.dot(aim);
    const Extended c = frame.dot(aim);
    const Extended d = (frame * own).dot(aim);
    const Extended squares = a * a + b * b + c * c + d * d;
    const Extended determinant = a * d - b * c;
    constexpr Extended kRounding = 64 * std::numeric_limits<Extended>::epsilon();
    // Where both singular values are nearly the same, the root of a rounding is more than one.
    const Extended root = std::sqrt(
        std::max(Extended{0}, squares * squares - 4 * determinant * determinant) + kRounding);
    const Extended greatest = std::sqrt((squares + root) / 2);
    return 2 - 2 * greatest <= Extended{distance} * distance + kRounding;
  }

 private:
  static ExtendedQuaternion pure(const ExtendedVector& v) { return {0, v.x(), v.y(), v.z()}; }

  ExtendedVector v_;      // the generator at t = 0
  ExtendedVector about_;  // k, unit
  double rate_;
  double t0_;
  double t1_;
  ExtendedQuaternion back_;                           // R(t0)*
  ExtendedVector own_axis_ = ExtendedVector::Zero();  // p/|p|
  Extended own_rate_ = 0;
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
