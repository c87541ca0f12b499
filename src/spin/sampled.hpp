// An angular velocity that is known at some times: interpolation between samples.
#pragma once

#include <atomic>
#include <cstddef>
#include <string>
#include <vector>

#include "spin/model.hpp"
#include "spin/samples.hpp"

namespace rotor {

/// Between the samples: straight lines, or the cubic spline with two continuous derivatives whose
/// third is continuous at the last sample but one too, at both ends ("not a knot": of fourth order
/// up to the ends; of three samples it is the parabola, of two the line).
enum class Interpolation { kLinear, kCubic };

/// omega between samples.
class SampledSpin : public SpinModel {
 public:
  /// The samples, of any rising times. Outside them omega is an error, or with `hold` the value at
  /// the nearer end. Throws std::invalid_argument as cleaned(samples) does.
  SampledSpin(Samples samples, Interpolation interpolation, bool hold = false);

  /// Fast where t is near the t of the call before. Throws std::out_of_range outside the samples,
  /// unless they hold.
  Vector value(double t) const override;
  /// Of the polynomial between two samples, which at a sample is not defined (but for the first and
  /// the last, unless omega holds there).
  VectorJet jet(double t) const override;
  std::string description() const override;
  /// The times of the samples.
  std::vector<double> breaks(double low, double high) const override;

  const std::vector<double>& times() const { return times_; }

 private:
  // Of the cubic in an interval of length h: h^2/6 times its second derivatives at both ends.
  struct Bend {
    Vector start = Vector::Zero();
    Vector end = Vector::Zero();
  };
  void bend(const Samples& samples);
  bool is_outside(double t) const { return !(t >= times_.front() && t <= times_.back()); }
  // The end value that holds at a t outside.
  const Vector& held(double t) const;
  std::size_t interval(double t) const;

  std::string name_;
  std::vector<double> times_;
  std::vector<Vector> values_;
  std::vector<Bend> bends_;  // one an interval; none where lines join the samples
  bool hold_;
  // Where t was last. Any value is right; atomic, so that runs may share the samples.
  mutable std::atomic<std::size_t> last_interval_ = 0;
};

}  // namespace rotor
