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
constexpr std::size_t kTerms = kFglNodes + 2;

// P_(n+2) = (scale z^2 - shift) P_n - lower P_(n-2).
struct Recurrence {
  double scale;
  double shift;
  double lower;
};
// Twice z P_n = up P_(n+1) + down P_(n-1), up = (n + 1)/(2 n + 1), down = n/(2 n + 1).
constexpr std::array<Recurrence, kTerms> kBySquares = [] {
  std::array<Recurrence, kTerms> table{};
  for (std::size_t i = 0; i < kTerms; ++i) {
    const auto n = static_cast<double>(i);
    const double up = (n + 1) / (2 * n + 1);
    const double down = n / (2 * n + 1);
    const double scale = (2 * n + 3) / (n + 2) / up;
    const double same = up * (n + 1) / (2 * n + 3) + (i == 0 ? 0 : down * n / (2 * n - 1));
    const double lower = i < 2 ? 0 : down * (n - 1) / (2 * n - 1);
    table[i] = {scale, scale * same, scale * lower};
  }
  return table;
}();

double place_in(double begin, double end, double t) {
  return ((t - begin) - (end - t)) / (end - begin);
}

Quaternion exp_half(const ExtendedVector& v) {
  const Extended angle = v.norm();
  if (angle == 0) return Quaternion::Identity();
  ExtendedQuaternion q;
  q.w() = std::cos(angle / 2);
  q.vec() = v / angle * std::sin(angle / 2);
  return q.cast<double>();
}

// The interpolant at the 16 nodes, and P_16 (a + b z), which is 0 there, for the values at the
// ends: 33 z P_16 = 17 P_17 + 16 P_15.
void interpolate(const std::array<Eigen::Vector4d, kFglNodes>& at_nodes,
                 const Eigen::Vector4d& at_begin, const Eigen::Vector4d& at_end,
                 std::array<Eigen::Vector4d, kTerms>& terms) {
  terms.fill(Eigen::Vector4d::Zero());
  for (std::size_t j = 0; j < 8; ++j) {
    const std::array<Eigen::Vector4d, 2> part = {at_nodes[j] + at_nodes[8 + j],
                                                 at_nodes[j] - at_nodes[8 + j]};
    for (std::size_t n = 0; n < kFglNodes; ++n) {
      terms[n] += kFglTables.of[n % 2].terms[j][n / 2] * part[n % 2];
    }
  }
  std::array<Eigen::Vector4d, 2> sum = {Eigen::Vector4d::Zero(), Eigen::Vector4d::Zero()};
  for (std::size_t n = 0; n < kFglNodes; ++n) sum[n % 2] += terms[n];
  const Eigen::Vector4d a = (at_end + at_begin) / 2 - sum[0];
  const Eigen::Vector4d b = (at_end - at_begin) / 2 - sum[1];
  terms[15] += 16.0 / 33 * b;
  terms[16] = a;
  terms[17] = 17.0 / 33 * b;
}

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
  if (step_) {
    const Span& kept = spans_[step_->span];
    if (std::min(kept.begin, kept.end) < t && t < std::max(kept.begin, kept.end)) {
      return step_->span;
    }
  }
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

// The two halves together are more accurate than the step, but it is the step's U that the run goes
// on with: what they differ by is spread over the step, so that U is continuous and the generator
// knows of it.
void FglFlow::fill(std::size_t index, std::size_t number) const {
  const Span& span = spans_[index];
  const double half = 0.5 / static_cast<double>(span.steps);
  const double begin = static_cast<double>(4 * number) * half - 1;
  std::array<FglInterior, 2> motion;
  for (std::size_t i = 0; i < 2; ++i) {
    motion[i] = interior(span, begin + (i == 0 ? 1 : 3) * half, half);
  }
  const auto quaternion = [](const std::array<double, 4>& q) {
    return Quaternion(q[0], q[1], q[2], q[3]);
  };
  const Quaternion u0 = values_[span.first + number];
  const Quaternion u1 = values_[span.first + number + 1];
  const Quaternion middle = quaternion(motion[0].end) * u0;
  const Quaternion end = quaternion(motion[1].end) * middle;
  const Eigen::Vector4d miss = u1.coeffs() - end.coeffs();
  const Quaternion turn = Quaternion(miss) * end.conjugate();
  // (1 + s turn) q, s the part of the step that is done.
  const auto corrected = [&](const Quaternion& q, double s) {
    return Eigen::Vector4d(q.coeffs() + s * (turn * q).coeffs());
  };
  step_.emplace();
  step_->span = index;
  step_->number = number;
  for (std::size_t i = 0; i < 2; ++i) {
    const Quaternion& from = i == 0 ? u0 : middle;
    const double done = i == 0 ? 0 : 0.5;
    std::array<Eigen::Vector4d, kFglNodes> at_nodes;
    for (std::size_t l = 0; l < kFglNodes; ++l) {
      const auto z = static_cast<double>(fgl_node(l));
      const auto& n = motion[i].nodes;
      at_nodes[l] =
          corrected(Quaternion(n[0][l], n[1][l], n[2][l], n[3][l]) * from, done + (1 + z) / 4);
    }
    interpolate(at_nodes, corrected(from, done), corrected(i == 0 ? middle : end, done + 0.5),
                step_->halves[i]);
  }
}

FglFlow::Place FglFlow::place_of(std::size_t index, double t) const {
  const Span& span = spans_[index];
  const auto steps = static_cast<double>(span.steps);
  const double place = (place_in(span.begin, span.end, t) + 1) * steps;
  const double half = std::clamp(std::floor(place), 0.0, 2 * steps - 1);
  const auto number = static_cast<std::size_t>(half) / 2;
  if (!step_ || step_->span != index || step_->number != number) fill(index, number);
  return {&step_->halves[static_cast<std::size_t>(half) % 2], 2 * (place - half) - 1,
          4 * steps / (span.end - span.begin)};
}

// Even and odd terms apart, each by Clenshaw's recurrence for
// P_(n+2) = (scale z^2 - shift) P_n - lower P_(n-2): two short chains of operations, not a long
// one.
Quaternion FglFlow::at(double t) const {
  if (t == t0_) return Quaternion::Identity();
  const std::size_t span = span_at(t);
  if (spans_[span].steps == 0) {
    const Panel& panel = panels_[spans_[span].panel];
    const Quaternion turn = exp_half(panel.integral(panel.place(t)));
    return (turn * values_[spans_[span].first]).normalized();
  }
  const Place place = place_of(span, t);
  const Piece& c = *place.piece;
  const double square = place.z * place.z;
  std::array<Eigen::Vector4d, 2> b1 = {c[kTerms - 2], c[kTerms - 1]};
  std::array<Eigen::Vector4d, 2> b2 = {Eigen::Vector4d::Zero(), Eigen::Vector4d::Zero()};
  for (std::size_t n = kTerms - 2; n > 0; n -= 2) {
    for (std::size_t parity = 0; parity < 2; ++parity) {
      const Recurrence& here = kBySquares[n - 2 + parity];
      const Eigen::Vector4d b = (c[n - 2 + parity] - kBySquares[n + parity].lower * b2[parity]) +
                                (here.scale * square - here.shift) * b1[parity];
      b2[parity] = b1[parity];
      b1[parity] = b;
    }
  }
  return Quaternion(b1[0] + place.z * b1[1]).normalized();
}

// Clenshaw's recurrence for P_(n+1) = alpha z P_n - beta P_(n-1), and its derivative by z.
Vector FglFlow::generator(double t) const {
  if (spans_.empty()) return sign_ * omega_(t);
  const std::size_t span = span_at(t);
  if (spans_[span].steps == 0) {
    const Panel& panel = panels_[spans_[span].panel];
    return panel.at(static_cast<double>(panel.place(t)));
  }
  const Place place = place_of(span, t);
  Eigen::Vector4d b1 = Eigen::Vector4d::Zero();
  Eigen::Vector4d b2 = b1;
  Eigen::Vector4d d1 = b1;
  Eigen::Vector4d d2 = b1;
  for (std::size_t n = kTerms; n-- > 0;) {
    const auto k = static_cast<double>(n);
    const double alpha = (2 * k + 1) / (k + 1);
    const double beta = (k + 1) / (k + 2);
    const Eigen::Vector4d d = alpha * b1 + alpha * place.z * d1 - beta * d2;
    const Eigen::Vector4d b = (*place.piece)[n] + alpha * place.z * b1 - beta * b2;
    b2 = b1;
    b1 = b;
    d2 = d1;
    d1 = d;
  }
  const Quaternion slope(d1);
  return 2 * place.rate / b1.squaredNorm() * (slope * Quaternion(b1).conjugate()).vec();
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
