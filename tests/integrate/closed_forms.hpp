// Motions known in closed form, in extended precision, and the distance of a run from them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "integrate/propagator.hpp"
#include "rotation/rotation.hpp"

namespace rotor::closed_form {

using ExtendedVector = Eigen::Matrix<Extended, 3, 1>;
using ExtendedQuaternion = Eigen::Quaternion<Extended>;

/// exp(v/2): the turn about v by |v|.
inline ExtendedQuaternion turn(const ExtendedVector& v) {
  const Extended angle = v.norm();
  ExtendedQuaternion q = ExtendedQuaternion::Identity();
  q.w() = std::cos(angle / 2);
  if (angle != 0) q.vec() = v * (std::sin(angle / 2) / angle);
  return q;
}

/// [P15] omega = s (cos a s t, sin a s t, 0), turning uniformly about k, faster or slower by s.
struct Turning {
  double a;
  double s = 1;

  AngularVelocity omega() const {
    return AngularVelocity([*this](double t) {
      const double phase = a * (s * t);
      return Vector(s * std::cos(phase), s * std::sin(phase), 0);
    });
  }
  /// U(t) from t = 0: constant in the frame that turns with omega [theory 4.4].
  ExtendedQuaternion operator()(double t) const {
    const Extended x = Extended{s} * Extended{t};
    return turn(ExtendedVector(0, 0, a * x)) * turn(ExtendedVector(x, 0, -a * x));
  }
};
/// The paper's drives: omega turns once in T.
inline Turning turning(double period) { return {2 * std::numbers::pi / period}; }

/// omega constant between the times t[i]: value[i] up to t[i], value.back() after the last. From 0.
struct Piecewise {
  std::vector<double> t;
  std::vector<Vector> value;

  AngularVelocity omega() const {
    return AngularVelocity([*this](double time) {
      const auto next = std::upper_bound(t.begin(), t.end(), time);
      return value[static_cast<std::size_t>(next - t.begin())];
    });
  }
  ExtendedQuaternion operator()(double time) const {
    ExtendedQuaternion q = ExtendedQuaternion::Identity();
    double begin = 0;
    for (std::size_t i = 0; i < value.size() && begin < time; ++i) {
      const double end = i < t.size() ? std::min(t[i], time) : time;
      q = turn(value[i].cast<Extended>() * (Extended{end} - Extended{begin})) * q;
      begin = end;
    }
    return q;
  }
};

/// The angle (rad) between a computed quaternion and the true one; near 2 pi for the wrong sign.
inline double rotation_error(const Quaternion& computed, const ExtendedQuaternion& truth) {
  const ExtendedQuaternion d = truth.conjugate() * computed.cast<Extended>();
  return static_cast<double>(2 * std::atan2(d.vec().norm(), d.w()));
}

/// The greatest error of a run at its nodes and at `parts` - 1 places between, on at most `pieces`
/// pieces.
template <class Truth>
double greatest_error(const Propagator& run, const Truth& truth, std::size_t pieces = 2000,
                      int parts = 10) {
  const std::vector<double> mesh = run.flow->mesh();
  const std::size_t stride = mesh.size() / pieces + 1;
  double greatest = 0;
  for (std::size_t i = 0; i + 1 < mesh.size(); i += stride) {
    for (int part = 1; part <= parts; ++part) {
      const double t =
          part == parts ? mesh[i + 1] : mesh[i] + (mesh[i + 1] - mesh[i]) * part / parts;
      const double error = rotation_error(run(t), truth(t));
      if (!(error <= greatest)) greatest = error;  // NaN stays
    }
  }
  return std::max(greatest, rotation_error(run(run.t1), truth(run.t1)));
}

inline Scene scene(AngularVelocity omega, double t0, double t1) {
  Scene result{std::move(omega)};
  result.t0 = t0;
  result.t1 = t1;
  return result;
}
inline Scene to_accuracy(double accuracy, Scene s) {
  s.accuracy = accuracy;
  return s;
}
inline Scene by_dop853(double accuracy, Scene s) {
  s.method = Method::kDop853;
  s.accuracy = accuracy;
  return s;
}
inline Scene by_rk4(double step, Scene s) {
  s.method = Method::kRk4;
  s.step = step;
  return s;
}

}  // namespace rotor::closed_form
