// The angular velocity of a log of attitudes.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "rotation/spline.hpp"
#include "spin/model.hpp"

namespace rotor {

/// omega = axial(Q' Q^T) of the spline through attitudes, in the space frame: what turns the first
/// of them into the others, at their times.
class AttitudeSpin : public SpinModel {
 public:
  explicit AttitudeSpin(Spline spline) : spline_(std::move(spline)) {}

  /// Throws std::out_of_range outside the times of the attitudes.
  Vector value(double t) const override { return spline_.omega(t); }
  /// Of the curve between two attitudes; at one of them, but for the first and the last, it has
  /// none.
  VectorJet jet(double t) const override;
  std::string description() const override;
  /// The times of the attitudes, where the second derivative of omega jumps.
  std::vector<double> breaks(double low, double high) const override;

  const Spline& spline() const { return spline_; }

 private:
  Spline spline_;
};

}  // namespace rotor
