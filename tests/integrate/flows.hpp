// What every flow of an exact model is tested against.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "catch.hpp"
#include "integrate/propagator.hpp"
#include "rotation/rotation.hpp"
#include "rotation/text.hpp"

namespace rotor::flows {

/// A model given as the function of t that it is, in the same frame: what nothing is known of.
inline AngularVelocity plain(const AngularVelocity& omega) {
  const AngularVelocity same([omega](double t) { return omega(t); });
  return omega.frame() == Frame::kBody ? same.in_body_frame() : same;
}

/// The angle (rad) between two quaternions, 2 pi for opposite ones.
inline double angle_between(const Quaternion& a, const Quaternion& b) {
  const Eigen::Quaternion<Extended> d = a.cast<Extended>().conjugate() * b.cast<Extended>();
  return static_cast<double>(2 * std::atan2(d.vec().norm(), d.w()));
}

/// 400 times from t0 to t1, evenly by an irrational part, and the ends.
inline std::vector<double> times(double t0, double t1) {
  std::vector<double> result{t0, t1};
  for (int i = 1; i <= 400; ++i)
    result.push_back(t0 + (t1 - t0) * std::fmod(i * 0.618033988749, 1));
  return result;
}

/// The same omega as a plain function, by DOP853 to `accuracy`, and the run agree within the sum
/// of what they state.
inline void check_against_dop853(const Scene& scene, double accuracy) {
  Scene independent = scene;
  independent.omega = plain(scene.omega);
  independent.method = Method::kDop853;
  independent.accuracy = accuracy;
  for (const double t :
       scene.omega.breaks(std::min(scene.t0, scene.t1), std::max(scene.t0, scene.t1))) {
    independent.breaks.push_back(t);
  }
  const Propagator run = propagate(scene);
  const Propagator other = propagate(independent);
  INFO(scene.omega.description() << "  from " << scene.t0 << " to " << scene.t1);
  INFO(run.why);
  REQUIRE(!run.stop);
  REQUIRE(!other.stop);
  CHECK(run.t1 == scene.t1);
  CHECK(run.frame == scene.omega.frame());
  // DOP853 states its error to a fifth (its own tests).
  const double allowed = run.error_estimate + other.error_estimate / 0.8;
  CHECK(allowed < 10 * accuracy);
  double worst = 0;
  for (const double t : times(scene.t0, scene.t1)) {
    const double error = angle_between(run.flow->at(t), other.flow->at(t));
    if (!(error <= worst)) worst = error;
  }
  CAPTURE(text(worst), text(run.error_estimate), text(other.error_estimate));
  CHECK(worst <= allowed);
}

/// The generator is what `at` has: U(t + h) U(t - h)* = exp(2h g(t) + O(h^3)). The third order is
/// at most h^3/3 (|g''| + |g||g'|), which `rate`, |g| and the rates of its change together, bounds
/// by h^3 rate^3/3 and more. The two quaternions are rounded, and t itself by u |t|.
inline void check_generator(const Flow& flow, double t, double rate) {
  constexpr double u = std::numeric_limits<double>::epsilon();
  const double h = 1e-4 / rate;
  const double after = t + h;
  const double before = t - h;
  const Quaternion d = flow.at(after) * flow.at(before).conjugate();
  const Vector measured = 2 * d.vec() / (after - before);
  CAPTURE(t, measured.transpose(), flow.generator(t).transpose());
  CHECK((measured - flow.generator(t)).norm() <=
        rate * 1e-8 + 4 * u / h + rate * rate * u * std::abs(t));
}

/// The mesh goes from t0 to t1 in order, by turns of at most 6 rad a step.
inline void check_mesh(const Flow& flow, double t0, double t1) {
  const std::vector<double> mesh = flow.mesh();
  REQUIRE(mesh.size() >= (t0 == t1 ? 1U : 2U));
  CHECK(mesh.front() == t0);
  CHECK(mesh.back() == t1);
  for (std::size_t i = 1; i < mesh.size(); ++i) {
    CHECK((t1 > t0 ? mesh[i] > mesh[i - 1] : mesh[i] < mesh[i - 1]));
    // The way between, by chords.
    double way = 0;
    for (int part = 0; part < 16; ++part) {
      const double h = (mesh[i] - mesh[i - 1]) / 16;
      way += angle_between(flow.at(mesh[i - 1] + part * h), flow.at(mesh[i - 1] + (part + 1) * h));
    }
    CHECK(way <= 6);
  }
}

inline Scene scene(AngularVelocity omega, double t0, double t1, double accuracy = 1e-10) {
  Scene result{std::move(omega)};
  result.t0 = t0;
  result.t1 = t1;
  result.accuracy = accuracy;
  return result;
}

/// A model in either frame.
template <class Model, class... Arguments>
std::vector<AngularVelocity> in_both_frames(const Arguments&... arguments) {
  const auto model = std::make_shared<const Model>(arguments...);
  return {{model, Frame::kSpace}, {model, Frame::kBody}};
}

}  // namespace rotor::flows
