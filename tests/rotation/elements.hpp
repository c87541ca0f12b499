// Rotations to try laws on: awkward ones and seeded random ones, and a measure of their difference
// that uses nothing of the floor but axis() and angle().
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "reference.hpp"

namespace rotor::reference {

constexpr double kPi = std::numbers::pi;

/// Draws that are the same on every machine (the distributions of <random> are not).
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}

  double uniform(double low, double high) {
    return low + (high - low) * std::ldexp(double(engine_() >> 11), -53);
  }
  int below(int count) { return int(uniform(0, count)); }
  /// Uniform in the cube: no length, no direction is special to the laws tested.
  Vector vector() {
    const double x = uniform(-1, 1), y = uniform(-1, 1);
    return {x, y, uniform(-1, 1)};
  }
  /// Any axis length a double can have, some axes close to a coordinate axis or plane.
  Vector awkward_axis() {
    Vector axis = vector();
    if (below(4) == 0) axis[below(3)] *= std::pow(10, uniform(-20, 0));
    if (below(4) == 0) axis[below(3)] *= std::pow(10, uniform(-300, 0));
    if (below(2) == 0) axis *= std::pow(10, uniform(-300, 308));
    if (axis.isZero(0)) axis = Vector::UnitZ();
    return axis;
  }
  /// Angles of all sizes, a third of them ordinary and a third close to a multiple of pi/2.
  double awkward_angle() {
    const double sign = below(2) == 0 ? 1 : -1;
    switch (below(3)) {
      case 0:
        return uniform(-4 * kPi, 4 * kPi);
      case 1:
        return below(9) * kPi / 2 + sign * std::pow(10, uniform(-17, 0));
      default:
        return sign * std::pow(10, uniform(-323, 22));
    }
  }
  Rotation rotation() { return {vector(), uniform(-4 * kPi, 4 * kPi)}; }

 private:
  std::mt19937_64 engine_;
};

inline std::vector<double> awkward_angles() {
  const double below_pi = std::nextafter(kPi, 0), above_pi = std::nextafter(kPi, 4);
  return {0,        -0.0, 5e-324,          1e-300,   1e-8,
          -1,       2.5,  kPi - 1e-9,      below_pi, kPi,
          above_pi, -kPi, 2 * kPi - 1e-12, 2 * kPi,  2 * kPi + 1e-8,
          4 * kPi,  1e6,  -1e15,           1e22};
}

inline std::vector<Vector> awkward_axes() {
  return {Vector(1, 0, 0),      Vector(0, -1, 0),           Vector(0, 0, 1),
          Vector(1, 1e-200, 0), Vector(1e-9, -1e-9, -1),    Vector(1.7e308, -1.7e308, 1.7e308),
          Vector(0, 5e-324, 0), Vector(-1e-200, 0, 1e-200), Vector(0.3, -0.5, 0.8)};
}

/// All awkward axes with all awkward angles, and `random` seeded ones.
inline std::vector<Rotation> elements(int random, std::uint64_t seed) {
  std::vector<Rotation> all;
  for (const Vector& axis : awkward_axes())
    for (double angle : awkward_angles()) all.emplace_back(axis, angle);
  Draw draw(seed);
  for (int i = 0; i < random; ++i) all.push_back(draw.rotation());
  return all;
}

using Wide = Eigen::Quaternion<Extended>;

/// The unit quaternion of r as a value, without double rounding.
inline Wide wide(const Rotation& r) {
  const Extended half = Extended(r.angle()) / 2;
  const Eigen::Matrix<Extended, 3, 1> v = r.axis().cast<Extended>().normalized() * std::sin(half);
  return {std::cos(half), v.x(), v.y(), v.z()};
}

/// Difference of the unit quaternions: tells theta from theta + 2 pi.
inline Extended spinor_error(const Wide& p, const Wide& q) {
  return (p.coeffs() - q.coeffs()).norm();
}
inline Extended spinor_error(const Rotation& r, const Rotation& s) {
  return spinor_error(wide(r), wide(s));
}

/// The angle between two operators: unit quaternions at chord d are 4 asin(d/2) of rotation apart.
inline Extended operator_error(const Wide& p, const Wide& q) {
  const Extended chord =
      std::min((p.coeffs() - q.coeffs()).norm(), (p.coeffs() + q.coeffs()).norm());
  return 4 * std::asin(std::min<Extended>(chord / 2, 1));
}
inline Extended operator_error(const Rotation& r, const Rotation& s) {
  return operator_error(wide(r), wide(s));
}

}  // namespace rotor::reference
