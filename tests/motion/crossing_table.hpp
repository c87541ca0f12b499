// The motions of make_crossings.py.
#pragma once

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "motions.hpp"
#include "table.hpp"

namespace rotor::crossing_table {

using motions::kEpsilon;

/// sum_k c_k (t - origin)^k, with its derivatives.
class Polynomial : public SpinModel {
 public:
  Polynomial(double origin, std::vector<Vector> c) : origin_(origin), c_(std::move(c)) {}
  Vector value(double t) const override {
    Vector sum = Vector::Zero();
    for (std::size_t k = c_.size(); k-- > 0;) sum = sum * (t - origin_) + c_[k];
    return sum;
  }
  /// What the value may be wrong by: a rounding of each sum and product.
  double rounding(double t) const {
    double sum = 0;
    for (std::size_t k = c_.size(); k-- > 0;) sum = sum * std::abs(t - origin_) + c_[k].norm();
    return 4 * kEpsilon * sum;
  }
  VectorJet jet(double t) const override {
    VectorJet sum{};
    const Jet s = Jet::variable(t) - Jet::constant(origin_);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = c_.size(); k-- > 0;) {
        sum[i] = sum[i] * s + Jet::constant(c_[k](static_cast<int>(i)));
      }
    }
    return sum;
  }
  std::shared_ptr<const Polynomial> opposite() const {
    std::vector<Vector> c;
    for (const Vector& coefficient : c_) c.emplace_back(-coefficient);
    return std::make_shared<const Polynomial>(origin_, c);
  }
  std::string description() const override { return "a polynomial"; }

 private:
  double origin_;
  std::vector<Vector> c_;
};

struct KnownCrossing {
  double t;
  std::size_t order;
  Passage kind;
  double turn_before, turn_after;
  Vector axis, axis_rate;
  double bend;  // |n''|
};

struct KnownState {
  double t, angle;
  Vector axis, axis_rate, euler_rate;
};

struct Motion {
  std::string name;
  double t0, t1;
  Rotation from;
  double miss;  // 2 pi less the greatest theta; 0 where theta is not near to 2 pi k, or is that
  std::shared_ptr<const Polynomial> omega;
  std::vector<KnownCrossing> crossings = {};
  std::vector<KnownState> states = {};

  bool starts_on_zero() const { return std::abs(std::sin(from.angle() / 2)) < 1e-15; }
  bool about_fixed_axis() const { return name.find("fixed axis") != std::string::npos; }
};

/// -omega in the body frame: q goes to q*, theta to -theta. From the identity theta rises in both.
inline Motion inverse(Motion motion) {
  motion.omega = motion.omega->opposite();
  const bool from_identity = motion.from.angle() == 0;
  if (!from_identity) motion.from = Rotation(motion.from.axis(), -motion.from.angle());
  for (KnownCrossing& crossing : motion.crossings) {
    crossing.turn_before = -crossing.turn_before - 1;
    crossing.turn_after = -crossing.turn_after - 1;
  }
  for (KnownState& state : motion.states) {
    state.euler_rate = -state.euler_rate;
    if (from_identity) {
      state.axis = -state.axis;
      state.axis_rate = -state.axis_rate;
    } else {
      state.angle = -state.angle;
    }
  }
  return motion;
}

inline std::vector<Motion> motion_table() {
  std::vector<Motion> result;
  for (reference::Row& row : reference::table("motion/crossing_runs.csv")) {
    const std::string name = row.word();
    const double t0 = row.number();
    const double t1 = row.number();
    const double angle = row.number();
    const Rotation from(row.vector(), angle);
    const double miss = row.number();
    const double origin = row.number();
    std::vector<Vector> c(6);
    for (Vector& coefficient : c) coefficient = row.vector();
    result.push_back({name, t0, t1, from, miss, std::make_shared<const Polynomial>(origin, c)});
  }
  // The rows of the others come in the same order.
  auto motion = result.begin();
  const auto of = [&](const std::string& name) -> Motion& {
    while (motion->name != name) ++motion;
    return *motion;
  };
  for (reference::Row& row : reference::table("motion/crossings.csv")) {
    Motion& its = of(row.word());
    KnownCrossing crossing{};
    crossing.t = row.number();
    crossing.order = static_cast<std::size_t>(row.number());
    crossing.kind = row.word() == "through" ? Passage::kThrough : Passage::kBack;
    crossing.turn_before = row.number();
    crossing.turn_after = row.number();
    crossing.axis = row.vector();
    crossing.axis_rate = row.vector();
    crossing.bend = row.number();
    its.crossings.push_back(crossing);
  }
  motion = result.begin();
  for (reference::Row& row : reference::table("motion/crossing_states.csv")) {
    Motion& its = of(row.word());
    KnownState state{};
    state.t = row.number();
    state.angle = row.number();
    state.axis = row.vector();
    state.axis_rate = row.vector();
    state.euler_rate = row.vector();
    its.states.push_back(state);
  }
  return result;
}

}  // namespace rotor::crossing_table
