#include "motion/zero_of_m.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rotor {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr std::size_t kCount = Derivatives::kCount;

Quaternion pure(const Vector& v) { return {0, v.x(), v.y(), v.z()}; }

// When the term of that order comes out of an error of M.
double time_until(const Vector& coefficient, std::size_t order, double error) {
  const auto power = static_cast<double>(order + 1);
  return std::pow(2 * power * error / norm(coefficient), 1 / power);
}

// The time from t at which omega^(order - 1) is least, by Newton's method on its series.
double shift_to_least(const Derivatives& omega, std::size_t order) {
  double s = 0;
  for (int i = 0; i < 4; ++i) {
    Vector value = Vector::Zero();
    Vector slope = Vector::Zero();
    double binomial = 1;  // k over order - 1
    double power = 1;     // s^(k - order + 1)
    for (std::size_t k = order - 1; k < kCount; ++k) {
      value += binomial * power * omega.c[k];
      if (k + 1 == kCount) break;
      const auto up = static_cast<double>(k + 1);
      const auto above = static_cast<double>(k + 2 - order);
      binomial *= up / above;
      slope += binomial * above * power * omega.c[k + 1];
      power *= s;
    }
    const double square = slope.squaredNorm();
    if (!(square > 0)) return s;
    s -= value.dot(slope) / square;
  }
  return s;
}

}  // namespace

// M = s^(i+1) P, from 2 (k + 1) q_(k+1) = sum_j omega_j q_(k-j), or q_(k-j) omega_j in the body
// frame.
AxisSeries::AxisSeries(const Derivatives& omega, std::size_t order, double w, Frame frame,
                       double time_error)
    : order_(order), time_error_(time_error) {
  std::array<Quaternion, kCount + 1> q;
  q[0] = Quaternion(w > 0 ? 1 : -1, 0, 0, 0);
  for (std::size_t k = 0; k < kCount; ++k) {
    Eigen::Vector4d sum = Eigen::Vector4d::Zero();
    for (std::size_t j = order; j <= k; ++j) {
      const Quaternion spin = pure(omega.c[j]);
      sum += (frame == Frame::kSpace ? spin * q[k - j] : q[k - j] * spin).coeffs();
    }
    q[k + 1].coeffs() = sum / (2 * static_cast<double>(k + 1));
  }
  for (std::size_t k = order; k < kCount && std::isfinite(omega.error[k]); ++k) {
    p_.emplace_back(q[k + 1].vec());
    e_.push_back(omega.error[k] / (2 * static_cast<double>(k + 1)));
  }
}

AxisSeries::Value AxisSeries::operator()(double s) const {
  Vector sum = Vector::Zero();
  Vector slope = Vector::Zero();
  for (std::size_t k = p_.size(); k-- > 0;) {
    slope = slope * s + sum;
    sum = sum * s + p_[k];
  }
  const Vector axis = unit(sum);
  return {axis, (slope - axis * axis.dot(slope)) / norm(sum)};
}

double AxisSeries::size(double s) const {
  Vector sum = Vector::Zero();
  for (std::size_t k = p_.size(); k-- > 0;) sum = sum * s + p_[k];
  return norm(sum) * std::pow(std::abs(s), static_cast<double>(order_ + 1));
}

// What is left out is taken for the greater of the last two terms (every other may be zero).
AxisSeries::Error AxisSeries::error(double s) const {
  const double far = std::abs(s);
  const std::size_t last = p_.size() - 1;
  const double size = norm(p_[0]);
  const double turning = norm((*this)(0).rate);
  // n'' is at most that of P, and twice the square of n'.
  const double bending = 2 * turning * turning + (last > 1 ? 2 * norm(p_[2]) / size : 0);
  Error error{e_[0] / size + turning * time_error_, turning * e_[0] / size + bending * time_error_};
  double left_out = last == 0 ? std::numeric_limits<double>::infinity() : 0;
  double power = 1;  // far^(k - 1)
  for (std::size_t k = 1; k <= last; ++k) {
    error.rate += static_cast<double>(k) * e_[k] * power / size;
    if (k + 1 >= last) left_out = std::max(left_out, norm(p_[k]) * power / size);
    power *= far;
    error.axis += e_[k] * power / size;
  }
  if (last == 0) error.rate = left_out;
  if (far > 0) {
    error.rate += left_out * static_cast<double>(std::max<std::size_t>(last, 1));
    error.axis += left_out * far;
  }
  return error;
}

std::optional<ZeroOrder> order_of_zero(const AngularVelocity& omega, double t, double error,
                                       double low, double high) {
  const Derivatives at_t = derivatives_at(omega, t, low, high);
  for (std::size_t i = kCount; i-- > 0;) {
    if (!at_t.differs_from_zero(i)) continue;
    ZeroOrder zero{i, t, 0, at_t};
    const double farthest = 2 * time_until(at_t.c[i], i, error);
    for (int round = 0; round < 3 && i > 0; ++round) {  // the series at t may be short
      zero.t = std::clamp(zero.t + shift_to_least(zero.omega, i), low, high);
      if (!(std::abs(zero.t - t) <= farthest)) break;
      zero.omega = derivatives_at(omega, zero.t, low, high);
    }
    if (!(std::abs(zero.t - t) <= farthest) || !zero.omega.differs_from_zero(i)) continue;
    const double until = time_until(zero.omega.c[i], i, error);
    zero.t_error = until + kEpsilon * std::abs(zero.t);
    bool first = true;
    for (std::size_t j = 0; j < i; ++j) {
      first = first && (!zero.omega.differs_from_zero(j) ||
                        time_until(zero.omega.c[j], j, error) > 2 * until);
    }
    if (first) return zero;
  }
  return std::nullopt;
}

}  // namespace rotor
