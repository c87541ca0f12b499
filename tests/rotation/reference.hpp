// What the tests of this floor compare with: values known beyond double, and errors against them.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "catch.hpp"
#include "rotation/rotation.hpp"
#include "rotation/text.hpp"
#include "table.hpp"

namespace rotor::reference {

/// The promises of floor 0. Lengths of error vectors, so every component keeps them too; of a
/// matrix the Frobenius norm.
constexpr double kAxis = 4.5e-16;
constexpr double kQuaternion = 4.5e-16;
constexpr double kMatrix = 1.0e-15;
constexpr double kVectorUlps = 4;  // of the largest component
constexpr double kFromMatrix = 1.5e-15;
constexpr double kComposition = 8e-16;
constexpr double kCancelled = 4.5e-16;

/// The true value is hi + lo, hi a double. `lo` is wide, to stay non-zero below the smallest
/// double.
struct Exact {
  double hi = 0;
  Extended lo = 0;
};

/// Exact to the last bits of Extended: measured - hi of nearby doubles has no rounding error.
inline Extended error(double measured, const Exact& exact) {
  return (Extended(measured) - exact.hi) - exact.lo;
}

template <class Derived, std::size_t N>
Eigen::Matrix<Extended, int(N), 1> errors(const Eigen::MatrixBase<Derived>& measured,
                                          const std::array<Exact, N>& exact) {
  static_assert(Derived::SizeAtCompileTime == int(N));
  Eigen::Matrix<Extended, int(N), 1> all;
  for (std::size_t i = 0; i < N; ++i) all[int(i)] = error(measured[int(i)], exact[i]);
  return all;
}

/// The distance from x to the next double away from zero (4.9e-324 for subnormals).
inline double ulp(double x) {
  return std::nextafter(std::abs(x), std::numeric_limits<double>::infinity()) - std::abs(x);
}

/// The largest component's error in ulp of the largest component. NaN if any component is.
template <class Derived>
double ulps(const Eigen::MatrixBase<Derived>& measured, const std::array<Exact, 3>& exact) {
  double largest = 0;
  for (const Exact& e : exact) largest = std::max(largest, std::abs(e.hi));
  const auto scaled = (errors(measured, exact) / Extended(ulp(largest))).eval();
  return double(scaled.template lpNorm<Eigen::Infinity>() + 0 * scaled.sum());
}

inline Eigen::Vector4d components(const Quaternion& q) { return {q.w(), q.x(), q.y(), q.z()}; }
inline Eigen::Matrix<double, 9, 1> entries(const Matrix& m) { return m.transpose().reshaped(); }

/// Every face of one rotation.
struct Faces {
  std::array<Exact, 3> axis;
  std::array<Exact, 4> quaternion;
  std::array<Exact, 9> matrix;
  std::array<Exact, 3> euler_vector, modified_gibbs, gibbs, mrp;
};

/// The largest of many errors and what it was found at; NaN is larger than anything.
class Worst {
 public:
  /// `where` is called for the description only if this is the largest error yet.
  template <class Where>
  void add(Extended size, const Where& where) {
    if (size <= size_ || std::isnan(size_)) return;
    size_ = size;
    where_ = where();
  }
  void within(const std::string& what, double bound) const {
    INFO(what << ": " << text(double(size_), 3) << " of " << text(bound, 3) << ", at " << where_);
    CHECK(double(size_) <= bound);
  }

 private:
  Extended size_ = 0;
  std::string where_ = "no input";
};

inline void within(Extended size, double bound) {
  INFO(text(double(size), 3) << " of " << text(bound, 3));
  CHECK(double(size) <= bound);
}

inline std::string described(const Vector& axis, double angle) {
  return "axis " + text(axis) + " angle " + text(angle);
}
inline std::string described(const Rotation& r) { return described(r.axis(), r.angle()); }

}  // namespace rotor::reference
