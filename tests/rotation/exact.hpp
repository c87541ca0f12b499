// The faces once more, in 50 digits (Boost.Multiprecision), for inputs that no table holds.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>

#include "reference.hpp"

namespace rotor::reference {

using Real = boost::multiprecision::cpp_bin_float_50;
using RealVector = Eigen::Matrix<Real, 3, 1>;
using RealQuaternion = Eigen::Quaternion<Real>;

inline RealVector exact_unit(const Vector& v) {
  const RealVector wide = v.cast<Real>();
  return wide / sqrt(wide.squaredNorm());
}

inline RealQuaternion exact_quaternion(const Vector& axis, double angle) {
  const Real half = Real(angle) / 2;
  const RealVector v = exact_unit(axis) * sin(half);
  return {cos(half), v.x(), v.y(), v.z()};
}

/// q v q* for a unit q.
inline RealVector exact_action(const RealQuaternion& q, const Vector& v) {
  const RealVector wide = v.cast<Real>();
  return wide + 2 * q.vec().cross(q.w() * wide + q.vec().cross(wide));
}

inline Exact split(const Real& x) {
  const double hi = x.convert_to<double>();
  return {hi, Real(x - hi).convert_to<Extended>()};
}

template <std::size_t N>
std::array<Exact, N> split(const Eigen::Matrix<Real, int(N), 1>& v) {
  std::array<Exact, N> all;
  for (std::size_t i = 0; i < N; ++i) all[i] = split(v[int(i)]);
  return all;
}

inline std::array<Exact, 4> split(const RealQuaternion& q) {
  return {split(q.w()), split(q.x()), split(q.y()), split(q.z())};
}

inline Faces exact_faces(const Vector& axis, double angle) {
  const RealVector n = exact_unit(axis);
  const Real half = Real(angle) / 2, quarter = Real(angle) / 4;
  const Real s = sin(half), c = cos(half);
  Faces faces;
  faces.axis = split<3>(n);
  faces.quaternion = split(exact_quaternion(axis, angle));
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Real cross = i == j ? Real(0) : Real(n[3 - i - j] * ((j - i + 3) % 3 == 1 ? -1 : 1));
      faces.matrix[std::size_t(3 * i + j)] =
          split((i == j ? c * c - s * s : Real(0)) + 2 * s * s * n[i] * n[j] + 2 * s * c * cross);
    }
  }
  faces.euler_vector = split<3>(n * Real(angle));
  faces.modified_gibbs = split<3>(n * s);
  faces.gibbs = split<3>(n * Real(s / c));
  faces.mrp = split<3>(n * Real(sin(quarter) / cos(quarter)));
  return faces;
}

}  // namespace rotor::reference
