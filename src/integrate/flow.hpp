// The motion of all bodies under one omega.
#pragma once

#include <vector>

#include "rotation/extended.hpp"
#include "rotation/rotation.hpp"

namespace rotor {

/// A stretch of time, in the order of the motion.
struct TimeSpan {
  double begin;
  double end;
};

/// U(t) with U(t0) = 1 and U' = g U / 2 for a generator g(t): omega in the space frame, when the
/// motion from q0 is U q0; or -omega in the body frame, when it is q0 U*. Linear: it knows no
/// start.
class Flow {
 public:
  Flow() = default;
  virtual ~Flow() = default;
  Flow(const Flow&) = delete;
  Flow& operator=(const Flow&) = delete;

  /// U(t), unit, continuous in t, for t between t0 and the end reached.
  virtual Quaternion at(double t) const = 0;
  /// The generator that `at` really has there, as a space vector: 2 vec(U' U*). It differs from the
  /// one that was integrated by the defect.
  virtual Vector generator(double t) const = 0;
  /// t0, ..., the end: so near one another that U turns by no more than some 6 rad in between.
  /// Throws std::length_error where these would be more than ten million.
  virtual std::vector<double> mesh() const = 0;
  /// Where U can come as near as `distance` (of quaternions) to plus or minus `target`, in the
  /// order of the motion, in stretches in which it turns by no more than some 6 rad: between them
  /// it does not. The whole mesh, unless more is known. Throws std::length_error where these would
  /// be more than ten million.
  virtual std::vector<TimeSpan> approaches(const Quaternion& target, double distance) const;
};

/// t0, ..., t1, evenly, for a motion that turns by `turning` rad in all: as Flow::mesh wants them.
std::vector<double> even_mesh(double t0, double t1, double turning);

/// A turn about one fixed direction: U(t) = exp(direction angle(t)), angle(t0) = 0.
class FixedAxisFlow : public Flow {
 public:
  explicit FixedAxisFlow(const Vector& direction) : direction_(direction) {}
  /// Unit; e1 where nothing turns.
  const Vector& direction() const { return direction_; }
  virtual Extended angle(double t) const = 0;
  /// d angle / dt.
  virtual double rate(double t) const = 0;

  Quaternion at(double t) const final;
  Vector generator(double t) const final { return direction_ * rate(t); }
  /// U stays on the great circle of its direction.
  std::vector<TimeSpan> approaches(const Quaternion& target, double distance) const final;

 private:
  Vector direction_;
};

/// U(t) = exp(direction rate (t - t0)).
class UniformTurn final : public FixedAxisFlow {
 public:
  /// About a constant omega. Throws std::invalid_argument where its angle at t1 overflows.
  UniformTurn(const Vector& omega, double t0, double t1);
  Extended rate() const { return rate_; }
  Extended angle(double t) const override { return rate_ * (Extended{t} - Extended{t0_}); }
  double rate(double) const override { return static_cast<double>(rate_); }
  std::vector<double> mesh() const override;

 private:
  Extended rate_;
  double t0_;
  double t1_;
};

}  // namespace rotor
