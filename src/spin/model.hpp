// What a model of an angular velocity must tell.
#pragma once

#include <string>
#include <vector>

#include "rotation/rotation.hpp"
#include "spin/jet.hpp"

namespace rotor {

/// omega as a function of t alone, rad per unit of t, in the frame that its owner says.
class SpinModel {
 public:
  SpinModel() = default;
  virtual ~SpinModel() = default;
  SpinModel(const SpinModel&) = delete;
  SpinModel& operator=(const SpinModel&) = delete;

  virtual Vector value(double t) const = 0;
  /// "(0, 0, 1)", "omega (function at script.lua:3)", "sampled gyro.csv, linear": for people.
  virtual std::string description() const = 0;
  /// The value with eight derivatives; throws NotDifferentiable, as it does by default.
  virtual VectorJet jet(double t) const;
  /// The times in (low, high), rising, at which omega or a derivative of it jumps.
  virtual std::vector<double> breaks(double low, double high) const;
  /// Whether a call costs more than some hundred operations, as a script's does: then omega is
  /// sampled sparsely and interpolated, where a method can.
  virtual bool dear() const { return false; }
};

}  // namespace rotor
