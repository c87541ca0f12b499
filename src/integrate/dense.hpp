// Dense output: the solution between the nodes of a run.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace rotor {

/// One piece, y(x) = y0 + x (F0 + x' (F1 + x (F2 + x' (F3 + ...)))), and its derivative by x.
template <class Value>
struct PieceValue {
  Value value;
  Value slope;
};
template <class Value>
PieceValue<Value> evaluate_piece(const Value& y0, const Value* f, std::size_t terms, double x) {
  Value sum = f[terms - 1];
  Value slope = Value::Zero();
  for (std::size_t k = terms - 1; k-- > 0;) {
    const double factor = k % 2 == 0 ? 1 - x : x;
    slope = (k % 2 == 0 ? -1 : 1) * sum + factor * slope;
    sum = f[k] + factor * sum;
  }
  return {y0 + x * sum, sum + x * slope};
}

/// Piecewise polynomials on a mesh t_0, t_1, ... (rising or falling). On each piece, with x the
/// fraction of the way and x' = 1 - x, they have the form of evaluate_piece: F0, F1, F2 are the
/// Hermite cubic of the two ends (F0 = y1 - y0, F1 = h f0 - F0, F2 = 2 F0 - h (f0 + f1)), further
/// terms vanish at the ends with their slopes.
template <class Value>
class DenseOutput {
 public:
  /// `terms`: the number of F's a piece has.
  DenseOutput(double t0, std::size_t terms) : terms_(terms), mesh_{t0} {}

  /// Adds the piece up to t: y0 and F0 ... F(terms - 1).
  template <class Terms>
  void append(double t, const Value& y0, const Terms& f) {
    mesh_.push_back(t);
    data_.push_back(y0);
    data_.insert(data_.end(), f.begin(), f.end());
  }

  const std::vector<double>& mesh() const { return mesh_; }
  std::size_t pieces() const { return mesh_.size() - 1; }

  /// The piece that holds t; needs at least one.
  std::size_t piece_at(double t) const {
    const bool rising = mesh_.back() >= mesh_.front();
    const auto next =
        std::upper_bound(mesh_.begin() + 1, mesh_.end() - 1, t,
                         [rising](double a, double b) { return rising ? a < b : a > b; });
    return static_cast<std::size_t>(next - mesh_.begin() - 1);
  }
  /// The value of a piece at the fraction x of its way, and its derivative by x.
  PieceValue<Value> at(std::size_t piece, double x) const {
    const Value* y0 = &data_[piece * (terms_ + 1)];
    return evaluate_piece(*y0, y0 + 1, terms_, x);
  }
  double length(std::size_t piece) const { return mesh_[piece + 1] - mesh_[piece]; }
  double fraction(std::size_t piece, double t) const { return (t - mesh_[piece]) / length(piece); }
  /// The value at t within the mesh; needs at least one piece.
  Value at(double t) const {
    const std::size_t piece = piece_at(t);
    return at(piece, fraction(piece, t)).value;
  }

 private:
  std::size_t terms_;
  std::vector<double> mesh_;
  std::vector<Value> data_;
};

}  // namespace rotor
