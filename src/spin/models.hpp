// The models of an angular velocity that have a closed form, or a cheaper way to be followed.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "rotation/extended.hpp"
#include "spin/angular_velocity.hpp"

namespace rotor {

/// omega does not depend on t.
class ConstantSpin : public SpinModel {
 public:
  /// Throws std::invalid_argument unless the vector is finite.
  explicit ConstantSpin(const Vector& vector);
  Vector value(double) const override { return vector_; }
  VectorJet jet(double) const override;
  std::string description() const override;

 private:
  Vector vector_;
};

/// Any function of t.
class FunctionSpin : public SpinModel {
 public:
  FunctionSpin(AngularVelocity::Function function, std::string name)
      : function_(std::move(function)), name_(std::move(name)) {}
  Vector value(double t) const override { return function_(t); }
  std::string description() const override { return name_; }

 private:
  AngularVelocity::Function function_;
  std::string name_;
};

/// Constant in a frame that turns uniformly: exp(about rate t) vector. [P15], coning.
class TurningSpin : public SpinModel {
 public:
  /// `vector` is the value at t = 0; `about`, of any length but zero, and `rate` (rad per unit of
  /// t) say how the frame turns. Throws std::invalid_argument for what is zero or not finite.
  TurningSpin(const Vector& vector, const Vector& about, double rate);
  Vector value(double t) const override;
  VectorJet jet(double t) const override;
  std::string description() const override;
  const Vector& vector() const { return vector_; }
  /// Unit, beyond the digits of a double: the motion of t = 1e9 depends on them.
  const ExtendedVector& about() const { return about_; }
  double rate() const { return rate_; }

 private:
  Vector vector_;
  ExtendedVector about_;
  double rate_;
};

/// A scalar function of t, with its derivatives where it has them.
struct ScalarFunction {
  std::function<double(double)> value;
  std::function<Jet(double)> jet;  // may be empty
  std::string name;
  bool dear = false;
};

/// A fixed direction: omega = direction s(t).
class AlongSpin : public SpinModel {
 public:
  /// `direction`, of any length but zero, is made unit: s is the rate. Throws
  /// std::invalid_argument for what is zero or not finite.
  AlongSpin(const Vector& direction, ScalarFunction rate);
  Vector value(double t) const override { return direction_ * rate_.value(t); }
  VectorJet jet(double t) const override;
  std::string description() const override;
  bool dear() const override { return rate_.dear; }
  const Vector& direction() const { return direction_; }  // unit
  const ScalarFunction& rate() const { return rate_; }

 private:
  Vector direction_;
  ScalarFunction rate_;
};

/// omega(t + period) = omega(t): another one, asked for t in [0, period) only.
class PeriodicSpin : public SpinModel {
 public:
  /// Throws std::invalid_argument unless the period is positive and finite and `one` is in the
  /// space frame (the frame is said of the whole).
  PeriodicSpin(double period, AngularVelocity one);
  Vector value(double t) const override { return one_(phase(t)); }
  VectorJet jet(double t) const override;
  std::string description() const override;
  std::vector<double> breaks(double low, double high) const override;
  bool dear() const override { return one_.dear(); }
  double period() const { return period_; }
  const AngularVelocity& one() const { return one_; }

 private:
  double phase(double t) const;
  double period_;
  AngularVelocity one_;
};

/// One after the other: piece i drives until ends[i], the last one for ever; before ends[0] the
/// first. Each is asked for t itself.
class PiecewiseSpin : public SpinModel {
 public:
  /// `ends` rise, one fewer than the pieces, which are in the space frame. Throws
  /// std::invalid_argument.
  PiecewiseSpin(std::vector<double> ends, std::vector<AngularVelocity> pieces);
  Vector value(double t) const override { return at(t)(t); }
  VectorJet jet(double t) const override;
  std::string description() const override;
  std::vector<double> breaks(double low, double high) const override;
  bool dear() const override;
  const std::vector<double>& ends() const { return ends_; }
  const std::vector<AngularVelocity>& pieces() const { return pieces_; }

 private:
  const AngularVelocity& at(double t) const;  // from its start on: pieces own their first instant
  std::vector<double> ends_;
  std::vector<AngularVelocity> pieces_;
};

}  // namespace rotor
