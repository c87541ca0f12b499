#include "integrate/fgl_flow.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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

// Half a step in 64 parts turns by a tenth of a radian at most: if that does not resolve it, it is
// w that is rough there.
constexpr std::size_t kMostParts = 64;
constexpr double kRounding = 4 * std::numeric_limits<double>::epsilon();

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

// What `end` differs by from the end of the values is spread over the parts.
Quaternion FglFlow::fill(const Span& span, std::size_t half, std::size_t parts,
                         const Quaternion& from, const Quaternion* end,
                         std::vector<FglPiece>& pieces) const {
  const auto all = static_cast<double>(2 * span.steps * parts);
  std::vector<FglInterior> motions;
  motions.reserve(parts);
  Quaternion u = from;
  for (std::size_t i = 0; i < parts; ++i) {
    const auto place = static_cast<double>(2 * (half * parts + i) + 1);
    motions.push_back(interior(span, place / all - 1, 1 / all));
    u = quaternion(motions.back().end) * u;
  }
  Quaternion turn(0, 0, 0, 0);
  if (end != nullptr) {
    turn = Quaternion(Eigen::Vector4d(end->coeffs() - u.coeffs())) * u.conjugate();
    turn.coeffs() /= static_cast<double>(parts);
  }
  pieces.resize(parts);
  u = from;
  for (std::size_t i = 0; i < parts; ++i) {
    fgl_kernel().fit(motions[i], components(u), components(turn), pieces[i]);
    u = quaternion(motions[i].end) * u;
    u.coeffs() += (turn * u).coeffs();
  }
  return u;
}

// What a polynomial leaves out, if its terms go on falling as they last did.
bool FglFlow::is_resolved(const std::vector<FglPiece>& pieces) const {
  return std::all_of(pieces.begin(), pieces.end(), [this](const FglPiece& piece) {
    const auto size = [&](std::size_t n) {
      return Eigen::Map<const Eigen::Vector4d>(piece.terms[n].data()).norm();
    };
    const double before = std::max(size(14), size(15));
    const double last = std::max(size(16), size(17));
    return last * std::min(1.0, last / before) <= std::max(allowed_, kRounding);
  });
}

// The next half of the step, in as few parts as resolve it. The two together are more accurate than
// the step, but it is the step's U that the run goes on with: what they differ by is spread over
// the second, so that U is continuous and the generator knows of it.
void FglFlow::fill_next() const {
  const Span& span = spans_[step_->span];
  const std::size_t half = 2 * step_->number + step_->known;
  const std::size_t first = span.first + step_->number;
  const bool second = step_->known == 1;
  const Quaternion& from = second ? step_->middle : values_[first];
  const Quaternion* const end = second ? &values_[first + 1] : nullptr;
  std::vector<FglPiece>& pieces = step_->halves[step_->known];
  Quaternion reached = fill(span, half, 1, from, end, pieces);
  for (std::size_t parts = 2; parts <= kMostParts && !is_resolved(pieces); parts *= 2) {
    reached = fill(span, half, parts, from, end, pieces);
  }
  if (!second) step_->middle = reached;
  ++step_->known;
}

std::size_t FglFlow::Part::number(double t, std::size_t among) const {
  const auto most = static_cast<double>(among) - 1;
  return static_cast<std::size_t>(std::clamp(std::floor(z(t) / 2), 0.0, most));
}

// Whether t is, beyond rounding, in the part that was asked for last: which one it is in must not
// depend on that.
bool FglFlow::is_in_part(double t) const {
  return part_.piece != nullptr && std::abs(part_.z(t)) < 1 - 1e-9;
}

// Finds the part that t is in; false where that is no step, but a turn about one direction.
bool FglFlow::find_part(double t) const {
  const std::size_t index = span_at(t);
  const Span& span = spans_[index];
  if (span.steps == 0) return false;
  part_.piece = nullptr;
  // Place 0 is where the span begins, and a part is 2 long.
  const auto around = [&](std::size_t parts) {
    const auto all = static_cast<double>(parts);
    return Part{nullptr, span.begin, span.end, all, all};
  };
  const std::size_t halves = 2 * span.steps;
  const std::size_t half = around(halves).number(t, halves);
  if (!step_ || step_->span != index || step_->number != half / 2) {
    step_.emplace();
    step_->span = index;
    step_->number = half / 2;
  }
  while (step_->known <= half % 2) fill_next();
  const std::vector<FglPiece>& pieces = step_->halves[half % 2];
  part_ = around(halves * pieces.size());
  const std::size_t first = half * pieces.size();
  const std::size_t number =
      std::clamp(part_.number(t, halves * pieces.size()), first, first + pieces.size() - 1);
  part_.piece = &pieces[number - first];
  part_.shift -= 2 * static_cast<double>(number) + 1;
  return true;
}

Quaternion FglFlow::at(double t) const {
  if (t == t0_) return Quaternion::Identity();
  if (!is_in_part(t) && !find_part(t)) {
    const Span& span = spans_[span_at(t)];
    const Panel& panel = panels_[span.panel];
    return (exp_half(panel.integral(panel.place(t))) * values_[span.first]).normalized();
  }
  Quaternion u;
  fgl_kernel().value(*part_.piece, part_.z(t), u.coeffs().data());
  return u;
}

// Clenshaw's recurrence for T_(n+1) = 2 z T_n - T_(n-1), and its derivative by z.
Vector FglFlow::generator(double t) const {
  if (spans_.empty()) return sign_ * omega_(t);
  if (!is_in_part(t) && !find_part(t)) {
    const Panel& panel = panels_[spans_[span_at(t)].panel];
    return panel.at(static_cast<double>(panel.place(t)));
  }
  const double z = part_.z(t);
  const auto term = [&](std::size_t n) {
    return Eigen::Map<const Eigen::Vector4d>(part_.piece->terms[n].data());
  };
  Eigen::Vector4d b1 = Eigen::Vector4d::Zero();
  Eigen::Vector4d b2 = b1;
  Eigen::Vector4d d1 = b1;
  Eigen::Vector4d d2 = b1;
  for (std::size_t n = part_.piece->terms.size(); n-- > 1;) {
    const Eigen::Vector4d d = 2 * b1 + 2 * z * d1 - d2;
    const Eigen::Vector4d b = term(n) + 2 * z * b1 - b2;
    b2 = b1;
    b1 = b;
    d2 = d1;
    d1 = d;
  }
  const Eigen::Vector4d u = term(0) + z * b1 - b2;
  const Eigen::Vector4d u_rate = b1 + z * d1 - d2;
  const double rate = 2 * part_.parts / (part_.end - part_.begin);  // dz/dt
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
