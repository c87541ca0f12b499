// A generator sampled at the nodes of one step.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "integrate/fgl_kernel.hpp"
#include "integrate/fgl_tables.hpp"
#include "rotation/rotation.hpp"

namespace rotor {

/// A stretch of time, its middle to twice the digits of a double.
class Stretch {
 public:
  Stretch(double begin, double end) : Stretch(0.5 * begin, 0.5 * end, 0, 0.5 * end - 0.5 * begin) {}

  double half() const { return half_; }
  /// The part around the place z, of half the length `half` (both for -1 to 1).
  Stretch part(double z, double half) const { return {middle_, z * half_, low_, half * half_}; }

  /// The double nearest to a node, or its neighbour.
  double time(const Node& node) const { return middle_ + node.place * half_; }
  /// By how much that is too late, in units of half the stretch.
  double late(const Node& node) const {
    if (half_ == 0) return 0;
    const double offset = node.place * half_;
    return (rest(middle_, offset, middle_ + offset) - low_) / half_ + node.more;
  }

 private:
  Stretch(double a, double b, double low, double half)
      : middle_(a + b), low_(low - rest(a, b, middle_)), half_(half) {}
  // sum - (a + b), exactly, for sum = a + b rounded.
  static double rest(double a, double b, double sum) {
    const double b_taken = sum - a;
    return ((sum - b_taken) - a) + (b_taken - b);
  }

  double middle_;
  double low_;
  double half_;
};

struct StepSamples {
  NodeVectors w;  // the generator times half the step
  NodeSlopes slopes;
};

/// 16 calls of f, Vector(double). The nodes are rounded to doubles: a sample is off by its slope
/// times that, to first order. Far from t = 0 the slopes themselves are the better for it.
template <class Function>
StepSamples sample_step(Function&& f, const Stretch& stretch) {
  StepSamples s;
  double latest = 0;
  NodeVectors given;
  std::array<double, kFglNodes> late{};
  for (std::size_t l = 0; l < kFglNodes; ++l) {
    const Node& node = kFglNodePlaces[l];
    late[l] = stretch.late(node);
    latest = std::max(latest, std::abs(late[l]));
    const Vector w = stretch.half() * f(stretch.time(node));
    for (std::size_t c = 0; c < 3; ++c) given.v[c][l] = w(static_cast<Eigen::Index>(c));
  }
  s.w = given;
  const auto& d = s.slopes.slopes.v;
  for (int pass = 0; pass < (latest > 1e-9 ? 3 : 1); ++pass) {
    fgl_kernel().slope(s.w, s.slopes);
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t l = 0; l < kFglNodes; ++l) s.w.v[c][l] = given.v[c][l] - late[l] * d[c][l];
    }
  }
  return s;
}

/// The greatest length of the vectors.
inline double longest(const NodeVectors& w) {
  double square = 0;
  for (std::size_t l = 0; l < kFglNodes; ++l) {
    square =
        std::max(square, w.v[0][l] * w.v[0][l] + w.v[1][l] * w.v[1][l] + w.v[2][l] * w.v[2][l]);
  }
  if (square > 1e-280 && square < 1e300) return std::sqrt(square);
  double length = 0;
  for (std::size_t l = 0; l < kFglNodes; ++l) {
    length = std::max(length, std::hypot(w.v[0][l], w.v[1][l], w.v[2][l]));
  }
  return length;
}

}  // namespace rotor
