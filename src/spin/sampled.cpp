#include "spin/sampled.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "rotation/extended.hpp"
#include "rotation/text.hpp"

namespace rotor {
namespace {

// m_i, a sixth of the second derivative at knot i, of the spline through at least three samples.
// With d_i = (v_i+1 - v_i)/h_i the first derivative is continuous at the knots between where
//   h_i-1 m_i-1 + 2 (h_i-1 + h_i) m_i + h_i m_i+1 = d_i - d_i-1,
// and the third at knot 1 where m_0 = (1 + r) m_1 - r m_2, r = h_0/h_1; likewise at the other end.
// These eliminate m_0 and m_n. What is left is tridiagonal, each diagonal entry larger than the
// others of its row together, and in no need of pivots.
std::vector<ExtendedVector> sixths_of_curvature(const std::vector<Extended>& h,
                                                const std::vector<ExtendedVector>& slopes) {
  const std::size_t n = h.size();
  std::vector<ExtendedVector> m(n + 1, ExtendedVector::Zero());
  if (n == 2) {
    m[0] = m[1] = m[2] = (slopes[1] - slopes[0]) / (3 * (h[0] + h[1]));
    return m;
  }
  std::vector<Extended> after(n, 0);  // m[i] + after[i] m[i+1] = what m[i] holds till then
  for (std::size_t i = 1; i < n; ++i) {
    Extended left = h[i - 1];
    Extended here = 2 * (h[i - 1] + h[i]);
    Extended right = h[i];
    if (i == 1) {
      here += h[0] * (1 + h[0] / h[1]);
      right -= h[0] * (h[0] / h[1]);
      left = 0;
    }
    if (i == n - 1) {
      here += h[n - 1] * (1 + h[n - 1] / h[n - 2]);
      left -= h[n - 1] * (h[n - 1] / h[n - 2]);
      right = 0;
    }
    const Extended pivot = here - left * after[i - 1];
    after[i] = right / pivot;
    m[i] = (slopes[i] - slopes[i - 1] - left * m[i - 1]) / pivot;
  }
  for (std::size_t i = n - 1; i-- > 1;) m[i] -= after[i] * m[i + 1];
  m[0] = m[1] + (m[1] - m[2]) * (h[0] / h[1]);
  m[n] = m[n - 1] + (m[n - 1] - m[n - 2]) * (h[n - 1] / h[n - 2]);
  return m;
}

}  // namespace

SampledSpin::SampledSpin(Samples samples, Interpolation interpolation, bool hold)
    : name_(samples.name), hold_(hold) {
  samples = cleaned(std::move(samples));
  times_.reserve(samples.rows.size());
  values_.reserve(samples.rows.size());
  for (const Sample& sample : samples.rows) {
    times_.push_back(sample.t);
    values_.push_back(sample.omega);
  }
  if (interpolation == Interpolation::kCubic) bend(samples);
}

void SampledSpin::bend(const Samples& samples) {
  const std::size_t n = times_.size() - 1;
  bends_.resize(n);
  if (n == 1) return;
  std::vector<Extended> h(n);
  std::vector<ExtendedVector> slopes(n);
  for (std::size_t i = 0; i < n; ++i) {
    h[i] = Extended{times_[i + 1]} - times_[i];
    slopes[i] = (values_[i + 1].cast<Extended>() - values_[i].cast<Extended>()) / h[i];
  }
  const std::vector<ExtendedVector> m = sixths_of_curvature(h, slopes);
  for (std::size_t i = 0; i < n; ++i) {
    bends_[i] = {(m[i] * h[i] * h[i]).cast<double>(), (m[i + 1] * h[i] * h[i]).cast<double>()};
    if (!bends_[i].start.allFinite() || !bends_[i].end.allFinite()) {
      throw std::invalid_argument(
          said_of(samples, "the cubic spline overflows between t = " + text(times_[i]) + " and " +
                               text(times_[i + 1]) + "; interpolation = \"linear\" does not"));
    }
  }
}

const Vector& SampledSpin::held(double t) const {
  if (!hold_ || std::isnan(t)) {
    throw std::out_of_range("t = " + text(t) + " is outside the " + description() + ", " +
                            text(times_.front()) + " .. " + text(times_.back()) +
                            (hold_ ? "" : "; extrapolate = true holds the values at the ends"));
  }
  return t < times_.front() ? values_.front() : values_.back();
}

std::size_t SampledSpin::interval(double t) const {
  const std::size_t last = times_.size() - 2;
  const std::size_t guess = last_interval_.load(std::memory_order_relaxed);
  for (std::size_t i = guess; i <= std::min(guess + 1, last); ++i) {
    if (times_[i] <= t && t < times_[i + 1]) {
      if (i != guess) last_interval_.store(i, std::memory_order_relaxed);
      return i;
    }
  }
  const auto next = std::upper_bound(times_.begin() + 1, times_.end() - 1, t);
  const auto found = static_cast<std::size_t>(next - times_.begin()) - 1;
  last_interval_.store(found, std::memory_order_relaxed);
  return found;
}

// With x the fraction of the way through the interval: (1 - x) v0 + x v1, and for the cubic
// - x (1 - x) ((2 - x) start + (1 + x) end).
Vector SampledSpin::value(double t) const {
  if (is_outside(t)) return held(t);
  const std::size_t i = interval(t);
  const double x = (t - times_[i]) / (times_[i + 1] - times_[i]);
  Vector value = (1 - x) * values_[i] + x * values_[i + 1];
  if (!bends_.empty()) value -= x * (1 - x) * ((2 - x) * bends_[i].start + (1 + x) * bends_[i].end);
  return value;
}

VectorJet SampledSpin::jet(double t) const {
  const bool outside = is_outside(t);
  const Vector now = value(t);
  VectorJet jet{Jet::constant(now.x()), Jet::constant(now.y()), Jet::constant(now.z())};
  if (outside) return jet;
  const std::size_t i = interval(t);
  const bool at_end = t == times_.front() || t == times_.back();
  if (at_end ? hold_ : t == times_[i]) {
    throw NotDifferentiable("t = " + text(t) + " is that of a sample (" + description() +
                            "): a derivative of omega jumps there");
  }
  const double h = times_[i + 1] - times_[i];
  const double x = (t - times_[i]) / h;
  const Bend bend = bends_.empty() ? Bend{} : bends_[i];
  // The value is v0 + a x + b x^2 + c x^3.
  const Vector a = values_[i + 1] - values_[i] - 2 * bend.start - bend.end;
  const Vector b = 3 * bend.start;
  const Vector c = bend.end - bend.start;
  const Vector first = (a + x * (2 * b + x * 3 * c)) / h;
  const Vector second = (b + x * 3 * c) / h / h;
  const Vector third = c / h / h / h;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    jet[k].c[1] = first(axis);
    jet[k].c[2] = second(axis);
    jet[k].c[3] = third(axis);
  }
  return jet;
}

std::string SampledSpin::description() const {
  return "samples" + (name_.empty() ? "" : " of " + name_) + " (" + std::to_string(times_.size()) +
         " rows, " + (bends_.empty() ? "linear" : "cubic") + ")";
}

std::vector<double> SampledSpin::breaks(double low, double high) const {
  const auto first = std::upper_bound(times_.begin(), times_.end(), low);
  return {first, std::lower_bound(first, times_.end(), high)};
}

}  // namespace rotor
