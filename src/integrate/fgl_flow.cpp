#include "integrate/fgl_flow.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "integrate/fgl_samples.hpp"
#include "integrate/fgl_tables.hpp"

namespace rotor {
namespace {

constexpr double kMostNodes = 1e7;
constexpr double kLongestTurn = 6;  // between two nodes of a mesh

Quaternion exp_half(const ExtendedVector& v) {
  const Extended angle = v.norm();
  if (angle == 0) return Quaternion::Identity();
  ExtendedQuaternion q;
  q.w() = std::cos(angle / 2);
  q.vec() = v / angle * std::sin(angle / 2);
  return q.cast<double>();
}

using Quaternion4 = std::array<double, 4>;
Quaternion4 components(const Quaternion& q) { return {q.w(), q.x(), q.y(), q.z()}; }
Quaternion quaternion(const Quaternion4& q) { return {q[0], q[1], q[2], q[3]}; }

}  // namespace

FglFlow::FglFlow(const AngularVelocity& omega, double t0)
    : omega_(omega),
      sign_(omega.frame() == Frame::kSpace ? 1 : -1),
      t0_(t0),
      values_{Quaternion::Identity()} {}

void FglFlow::append(double end, const Quaternion& u, double turn) {
  spans_.push_back({t1(), end, turn, values_.size() - 1, 1, kNoPanel});
  values_.push_back(u);
}

void FglFlow::append(const Panel& panel, const std::vector<Quaternion>& u, double turn) {
  spans_.push_back({t1(), panel.end(), turn, values_.size() - 1, u.size(), panels_.size()});
  panels_.push_back(panel);
  values_.insert(values_.end(), u.begin(), u.end());
}

void FglFlow::append_turn(const Panel& panel, double turn) {
  spans_.push_back({t1(), panel.end(), turn, values_.size() - 1, 0, panels_.size()});
  panels_.push_back(panel);
  values_.push_back((exp_half(panel.integral(1)) * last()).normalized());
}

std::size_t FglFlow::span_at(double t) const {
  const bool rising = t1() >= t0_;
  const auto next = std::upper_bound(
      spans_.begin(), spans_.end() - 1, t,
      [rising](double a, const Span& b) { return rising ? a < b.end : a > b.end; });
  return static_cast<std::size_t>(next - spans_.begin());
}

// The motion from place `middle` - `half` to `middle` + `half` of a span.
FglInterior FglFlow::interior(const Span& span, double middle, double half) const {
  NodeVectors w;
  if (span.panel == kNoPanel) {
    w = sample_step([this](double t) { return Vector(sign_ * omega_(t)); },
                    Stretch(span.begin, span.end).part(middle, half))
            .w;
  } else {
    LegendreLanes legendre;
    NodeVectors mirrored;
    fgl_kernel().legendre(middle, half, legendre);
    fgl_kernel().restrict_to(legendre, panels_[span.panel].coefficients(),
                             half * ((Extended{span.end} - Extended{span.begin}) / 2), w, mirrored);
  }
  FglInterior result;
  fgl_kernel().interior(w, result);
  return result;
}

// The next half of the step. The two together are more accurate than the step, but it is the
// step's U that the run goes on with: what they differ by is spread over the second, so that U is
// continuous and the generator knows of it.
void FglFlow::fill_next() const {
  const Span& span = spans_[step_->span];
  const double quarter = 0.5 / static_cast<double>(span.steps);
  const auto place = static_cast<double>(4 * step_->number + 2 * step_->known + 1);
  const FglInterior motion = interior(span, place * quarter - 1, quarter);
  const std::size_t first = span.first + step_->number;
  const Quaternion& from = step_->known == 0 ? values_[first] : step_->middle;
  const Quaternion end = quaternion(motion.end) * from;
  Quaternion turn(0, 0, 0, 0);
  if (step_->known == 0) {
    step_->middle = end;
  } else {
    const Quaternion miss(Eigen::Vector4d(values_[first + 1].coeffs() - end.coeffs()));
    turn = miss * end.conjugate();
  }
  fgl_kernel().fit(motion, components(from), components(turn), step_->halves[step_->known]);
  ++step_->known;
}

// Whether t is, beyond rounding, in the half that was asked for last: which one it is in must not
// depend on that.
bool FglFlow::is_in_half(double t) const {
  return half_.piece != nullptr && std::abs(half_.z(t)) < 1 - 1e-9;
}

// Finds the half that t is in; false where that is no step, but a turn about one direction.
bool FglFlow::find_half(double t) const {
  const std::size_t index = span_at(t);
  const Span& span = spans_[index];
  if (span.steps == 0) return false;
  half_.piece = nullptr;
  const auto steps = static_cast<double>(span.steps);
  const Half around{nullptr, span.begin, span.end, 2 * steps, 2 * steps};
  const double half = std::clamp(std::floor(around.z(t) / 2), 0.0, 2 * steps - 1);
  const auto number = static_cast<std::size_t>(half) / 2;
  const auto which = static_cast<std::size_t>(half) % 2;
  if (!step_ || step_->span != index || step_->number != number) {
    step_.emplace();
    step_->span = index;
    step_->number = number;
  }
  while (step_->known <= which) fill_next();
  half_ = around;
  half_.piece = &step_->halves[which];
  half_.shift -= 2 * half + 1;
  return true;
}

Quaternion FglFlow::at(double t) const {
  if (t == t0_) return Quaternion::Identity();
  if (!is_in_half(t) && !find_half(t)) {
    const Span& span = spans_[span_at(t)];
    const Panel& panel = panels_[span.panel];
    return (exp_half(panel.integral(panel.place(t))) * values_[span.first]).normalized();
  }
  Quaternion u;
  fgl_kernel().value(*half_.piece, half_.z(t), u.coeffs().data());
  return u;
}

// Clenshaw's recurrence for T_(n+1) = 2 z T_n - T_(n-1), and its derivative by z.
Vector FglFlow::generator(double t) const {
  if (spans_.empty()) return sign_ * omega_(t);
  if (!is_in_half(t) && !find_half(t)) {
    const Panel& panel = panels_[spans_[span_at(t)].panel];
    return panel.at(static_cast<double>(panel.place(t)));
  }
  const double z = half_.z(t);
  const auto term = [&](std::size_t n) {
    return Eigen::Map<const Eigen::Vector4d>(half_.piece->terms[n].data());
  };
  Eigen::Vector4d b1 = Eigen::Vector4d::Zero();
  Eigen::Vector4d b2 = b1;
  Eigen::Vector4d d1 = b1;
  Eigen::Vector4d d2 = b1;
  for (std::size_t n = half_.piece->terms.size(); n-- > 1;) {
    const Eigen::Vector4d d = 2 * b1 + 2 * z * d1 - d2;
    const Eigen::Vector4d b = term(n) + 2 * z * b1 - b2;
    b2 = b1;
    b1 = b;
    d2 = d1;
    d1 = d;
  }
  const Eigen::Vector4d u = term(0) + z * b1 - b2;
  const Eigen::Vector4d u_rate = b1 + z * d1 - d2;
  const double rate = 2 * half_.halves / (half_.end - half_.begin);  // dz/dt
  return 2 * rate / u.squaredNorm() * (Quaternion(u_rate) * Quaternion(u).conjugate()).vec();
}

std::vector<double> FglFlow::mesh() const {
  std::vector<double> result = {t0_};
  double nodes = 1;
  for (const Span& span : spans_) {
    const double steps = std::max(1.0, static_cast<double>(span.steps));
    const double parts = std::max(1.0, std::ceil(span.turn / steps / kLongestTurn)) * steps;
    nodes += parts;
    if (!(nodes <= kMostNodes)) {
      throw std::length_error("the run turns too far for a mesh of at most ten million times");
    }
    const auto count = static_cast<std::size_t>(parts);
    for (std::size_t i = 1; i < count; ++i) {
      const Extended part = static_cast<Extended>(i) / static_cast<Extended>(count);
      result.push_back(
          static_cast<double>(span.begin + (Extended{span.end} - Extended{span.begin}) * part));
    }
    result.push_back(span.end);
  }
  return result;
}

}  // namespace rotor
