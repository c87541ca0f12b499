#include "spin/models.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "rotation/extended.hpp"
#include "rotation/text.hpp"
#include "spin/jet_check.hpp"

namespace rotor {
namespace {

void require(bool holds, const std::string& message) {
  if (!holds) throw std::invalid_argument(message);
}

void require_space_frame(const AngularVelocity& omega) {
  require(omega.frame() == Frame::kSpace,
          "the frame is said of the whole: body(the whole), not of a part");
}

Vector direction_of(const Vector& v, const std::string& name) {
  require(v.allFinite() && !v.isZero(0),
          name + ": expected a finite vector that is not zero, got " + text(v));
  return unit(v);
}

}  // namespace

ConstantSpin::ConstantSpin(const Vector& vector) : vector_(vector) {
  require(vector.allFinite(), "omega: expected three finite numbers, got " + text(vector));
}

VectorJet ConstantSpin::jet(double) const {
  return {Jet::constant(vector_.x()), Jet::constant(vector_.y()), Jet::constant(vector_.z())};
}

std::string ConstantSpin::description() const { return text(vector_); }

TurningSpin::TurningSpin(const Vector& vector, const Vector& about, double rate)
    : vector_(vector), about_(about.cast<Extended>().normalized()), rate_(rate) {
  direction_of(about, "about");
  require(vector.allFinite(), "vector: expected three finite numbers, got " + text(vector));
  require(std::isfinite(rate), "rate: expected a finite number, got " + text(rate));
}

Vector TurningSpin::value(double t) const {
  const double angle = rate_ * t;
  const Vector about = about_.cast<double>();
  const Vector along = about * about.dot(vector_);
  return along + (vector_ - along) * std::cos(angle) + about.cross(vector_) * std::sin(angle);
}

// omega' = rate about x omega, so that (k + 1) c_(k+1) = rate about x c_k.
VectorJet TurningSpin::jet(double t) const {
  VectorJet result;
  const Vector about = about_.cast<double>();
  Vector c = value(t);
  for (std::size_t k = 0; k <= Jet::kOrder; ++k) {
    for (int i = 0; i < 3; ++i) result[static_cast<std::size_t>(i)].c[k] = c(i);
    c = about.cross(c) * (rate_ / static_cast<double>(k + 1));
  }
  return result;
}

std::string TurningSpin::description() const {
  return text(vector_) + " turning about " + text(Vector(about_.cast<double>())) + " at " +
         text(rate_);
}

AlongSpin::AlongSpin(const Vector& direction, ScalarFunction rate)
    : direction_(direction_of(direction, "direction")), rate_(std::move(rate)) {}

VectorJet AlongSpin::jet(double t) const {
  if (!rate_.jet) return SpinModel::jet(t);
  const Jet rate = rate_.jet(t);
  return {rate * direction_.x(), rate * direction_.y(), rate * direction_.z()};
}

std::string AlongSpin::description() const { return rate_.name + " along " + text(direction_); }

PeriodicSpin::PeriodicSpin(double period, AngularVelocity one)
    : period_(period), one_(std::move(one)) {
  require(period > 0 && std::isfinite(period),
          "period: expected a positive number, got " + text(period));
  require_space_frame(one_);
}

std::string PeriodicSpin::description() const {
  return one_.description() + ", period " + text(period_);
}

// fmod is exact.
double PeriodicSpin::phase(double t) const {
  const double rest = std::fmod(t, period_);
  return rest < 0 ? rest + period_ : rest;
}

// Where one period meets the next, only the values about it tell whether they fit.
VectorJet PeriodicSpin::jet(double t) const {
  const VectorJet jets = one_.jet(phase(t));
  if (phase(t) == 0) check_jet(jets, t, [this](double s) { return value(s); });
  return jets;
}

std::vector<double> PeriodicSpin::breaks(double low, double high) const {
  std::vector<double> within = one_.breaks(0, period_);
  within.insert(within.begin(), 0.0);
  std::vector<double> result;
  for (double k = std::floor(low / period_); k * period_ < high; ++k) {
    for (const double place : within) {
      const double t = k * period_ + place;
      if (low < t && t < high) result.push_back(t);
    }
  }
  return result;
}

PiecewiseSpin::PiecewiseSpin(std::vector<double> ends, std::vector<AngularVelocity> pieces)
    : ends_(std::move(ends)), pieces_(std::move(pieces)) {
  require(pieces_.size() == ends_.size() + 1, "expected one time between every two pieces");
  for (const double end : ends_) {
    require(std::isfinite(end), "expected finite times, got " + text(end));
  }
  for (std::size_t i = 1; i < ends_.size(); ++i) {
    require(ends_[i - 1] < ends_[i],
            "times must rise, got " + text(ends_[i]) + " after " + text(ends_[i - 1]));
  }
  for (const AngularVelocity& piece : pieces_) require_space_frame(piece);
}

const AngularVelocity& PiecewiseSpin::at(double t) const {
  const auto end = std::upper_bound(ends_.begin(), ends_.end(), t);
  return pieces_[static_cast<std::size_t>(end - ends_.begin())];
}

VectorJet PiecewiseSpin::jet(double t) const {
  if (std::binary_search(ends_.begin(), ends_.end(), t)) {
    throw NotDifferentiable("one piece ends and the next begins at t = " + text(t));
  }
  return at(t).jet(t);
}

std::string PiecewiseSpin::description() const {
  return std::to_string(pieces_.size()) + " pieces, the first " + pieces_.front().description();
}

std::vector<double> PiecewiseSpin::breaks(double low, double high) const {
  std::vector<double> result;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const double begin = i == 0 ? low : std::max(low, ends_[i - 1]);
    const double end = i == ends_.size() ? high : std::min(high, ends_[i]);
    if (!(begin < end)) continue;
    if (begin > low) result.push_back(begin);
    const std::vector<double> within = pieces_[i].breaks(begin, end);
    result.insert(result.end(), within.begin(), within.end());
  }
  return result;
}

bool PiecewiseSpin::dear() const {
  return std::any_of(pieces_.begin(), pieces_.end(), [](auto& piece) { return piece.dear(); });
}

}  // namespace rotor
