// The flow of a run in a chart.
#pragma once

#include <utility>
#include <vector>

#include "integrate/dense.hpp"
#include "integrate/flow.hpp"

namespace rotor {

/// U(t) = q(y(t)) q(y(t0))*, y the dense output of a run of an equation.
template <class Equation>
class ChartFlow final : public Flow {
 public:
  using Value = typename Equation::Value;

  ChartFlow(Equation equation, const Value& start, DenseOutput<Value> dense)
      : equation_(std::move(equation)),
        dense_(std::move(dense)),
        back_(equation_.quaternion(start).conjugate()) {
    anchors_.reserve(2 * dense_.pieces() + 1);
    anchors_.push_back(Quaternion::Identity());
    for (std::size_t piece = 0; piece < dense_.pieces(); ++piece) {
      for (const double x : {0.5, 1.0}) {
        anchors_.push_back(near(anchors_.back(), dense_.at(piece, x).value));
      }
    }
  }

  Quaternion at(double t) const override {
    if (dense_.pieces() == 0) return Quaternion::Identity();
    const std::size_t piece = dense_.piece_at(t);
    const double x = dense_.fraction(piece, t);
    const std::size_t anchor = 2 * piece + (x < 0.25 ? 0 : x < 0.75 ? 1 : 2);
    return near(anchors_[anchor], dense_.at(piece, x).value);
  }

  Vector generator(double t) const override {
    if (dense_.pieces() == 0) return Vector::Zero();
    const std::size_t piece = dense_.piece_at(t);
    const auto y = dense_.at(piece, dense_.fraction(piece, t));
    return equation_.quaternion(y.value) *
           (equation_.body_error(y.value, y.slope) / dense_.length(piece));
  }

  std::vector<double> mesh() const override { return dense_.mesh(); }
  /// y(t) itself; needs at least one piece.
  Value value(double t) const {
    const std::size_t piece = dense_.piece_at(t);
    return dense_.at(piece, dense_.fraction(piece, t)).value;
  }

 private:
  // Of the two signs, the one that continues from an anchor: it is less than half a turn away.
  Quaternion near(const Quaternion& anchor, const Value& y) const {
    Quaternion u = equation_.quaternion(y) * back_;
    if (u.dot(anchor) < 0) u.coeffs() *= -1;
    return u;
  }

  Equation equation_;
  DenseOutput<Value> dense_;
  Quaternion back_;
  std::vector<Quaternion> anchors_;  // U at the ends and in the middle of the pieces
};

}  // namespace rotor
