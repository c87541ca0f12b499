// A stretch of time on which a vector function is sampled sparsely and known everywhere.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "rotation/extended.hpp"
#include "rotation/rotation.hpp"

namespace rotor {

/// A vector function f of t between two times, as the Legendre series of its interpolant at 64
/// Gauss nodes: f = sum_n c_n P_n(z), z from -1 at `begin` to 1 at `end`, which may be before
/// `begin`. It tells how well it knows f, from the decay of the c_n and from f at both ends, which
/// are no nodes.
///
/// Sizes of terms are root mean squares over the panel: |c_n| / sqrt(2 n + 1). An integral of what
/// is left out, with any weight of size 1, is at most |end - begin| times its size.
class Panel {
 public:
  static constexpr std::size_t kNodes = 64;
  static constexpr std::size_t kSamples = kNodes + 2;
  using Coefficients = std::array<std::array<double, kNodes>, 3>;  // [component][n]

  /// Calls f, Vector(double), 66 times, the last two at begin and end themselves: if f jumps there,
  /// it must give its limits from inside. begin and end are finite and differ.
  template <class Function>
  static Panel of(Function&& f, double begin, double end) {
    Panel panel(begin, end);
    Samples samples;
    for (std::size_t i = 0; i < kSamples; ++i) samples[i] = f(panel.time(i));
    panel.set(samples);
    return panel;
  }

  double begin() const { return begin_; }
  double end() const { return end_; }
  const Coefficients& coefficients() const { return coefficients_; }

  /// Where t lies in the panel.
  Extended place(double t) const {
    const Extended begin = begin_;
    const Extended end = end_;
    return ((t - begin) - (end - t)) / (end - begin);
  }
  Vector at(double z) const;
  /// The integral over t from `begin` to z.
  ExtendedVector integral(Extended z) const;
  /// Whether all samples were the same.
  bool is_constant() const;

  /// No less than any |sample|, and no more than twice the greatest.
  double greatest() const { return greatest_; }
  /// The size of what the series leaves out of f.
  double error() const { return error_; }
  /// The size of each term of the noise in the samples, in f and its argument both rounded to
  /// double, as it shows in the last terms or, where these still count, as it is expected. The
  /// panel's integral has from it a standard deviation of |end - begin| times that.
  double noise() const { return noise_; }
  /// By how much samples, their times rounded by up to half an ulp, are off in the mean where f
  /// curves as it does when it turns; after the correction of first order.
  double aside() const { return aside_; }
  /// What part of f's change (mean square) is along f itself: of its length, not its direction.
  double along() const { return along_; }
  /// The factor from this panel's length to that of one with an `error()` of `allowed`, or of noise
  /// where that is more: from 1/10 to 16.
  double length_factor(double allowed) const;

 private:
  using Samples = std::array<Vector, kSamples>;

  Panel(double begin, double end) : begin_(begin), end_(end) {}
  double time(std::size_t i) const;
  void set(const Samples& samples);
  void judge(const Vector& at_begin, const Vector& at_end, double steepest);

  double begin_;
  double end_;
  Coefficients coefficients_{};
  double greatest_ = 0;
  double error_ = 0;
  double noise_ = 0;
  double aside_ = 0;
  double along_ = 1;
};

/// The lengths of panels along a run, from what each tells of itself.
class PanelLengths {
 public:
  /// None longer than `longest`.
  explicit PanelLengths(double longest) : longest_(longest), length_(longest) {}

  /// Of the panel that is to be tried.
  double length() const { return length_; }
  /// Whether the panel will do: its error, |end - begin| times its size, is at most `allowed`.
  /// Either way the next length is set.
  bool accept(const Panel& panel, double allowed);
  /// The next panel is no longer than that.
  void limit(double length) { length_ = std::min(length_, length); }

 private:
  double longest_;
  double length_;
  bool after_rejection_ = false;
};

}  // namespace rotor
