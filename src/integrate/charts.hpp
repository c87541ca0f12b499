// The equations of motion in the charts of the paper: the columns of the operator, the Euler
// vector, the Gibbs vector, axis and angle. (That of the user's own f is in generalized.hpp.)
//
// Rates are good to the last digits of a double at small angles and next to full turns.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <string>

#include "integrate/equation.hpp"
#include "rotation/rotation.hpp"

namespace rotor {

/// [P1] r' = omega x r for the images of e1, e2, e3, the columns of the operator: every point of
/// the body is their combination. Linear, never singular.
struct BodyPointsEquation : RegularEquation<Matrix> {
  /// 1, whatever the start: linear, U(t) serves every one.
  static Value start(const Rotation&) { return Matrix::Identity(); }
  static Value rate(const Vector& omega, const Value& r);
  static Vector body_error(const Value& r, const Value& dr);
  static Value turning(const Value& r, const Vector& v);
  static Value restoring(const Value& r);
  /// Of the nearest rotation.
  static Quaternion quaternion(const Value& r);
};

/// [P7] E' = omega - {omega |E|^2 - E (omega . E)} (1 - g)/|E|^2 + omega x E / 2,
/// g = (theta/2) cot(theta/2), for the Euler vector E = n theta. Singular at |E| = 2 pi k, k >= 1.
class EulerEquation : public RegularEquation<Vector> {
 public:
  /// With `restart`, where |E| exceeds 3 pi/2 the run goes on from E (1 - 2 pi/|E|). With
  /// `straight` it goes through 2 pi k as if nothing were there, by steps that do not see the
  /// singularity: how wrong it is then depends on how near their nodes come to it.
  EulerEquation(bool restart, bool straight) : restart_(restart), straight_(straight) {}

  Value start(const Rotation& r) const;
  static Value rate(const Vector& omega, const Value& e);
  static Vector body_error(const Value& e, const Value& de);
  static Value turning(const Value& e, const Vector& v) { return rate(v, -e); }
  static Quaternion quaternion(const Value& e);

  double distance(const Value& e) const;
  double reach(const Value& e0, const Vector& turn, const Value& e1) const;
  static std::string singularity(const Value& e);
  static double stretch(const Value& e) { return norm(e); }
  bool is_due(const Value& e) const;
  static Value restarted(const Value& e);

 private:
  bool restart_;
  bool straight_;
};

/// [P10] G' = omega/2 + G (omega . G)/2 + omega x G / 2 for the Gibbs vector G = n tan(theta/2),
/// which is infinite at theta = pi.
struct GibbsEquation : RegularEquation<Vector> {
  static Value start(const Rotation& r);
  static Value rate(const Vector& omega, const Value& g) {
    return 0.5 * (omega + g * omega.dot(g) + omega.cross(g));
  }
  static Vector body_error(const Value& g, const Value& dg) {
    return 2 / (1 + g.squaredNorm()) * (dg - g.cross(dg));
  }
  static Value turning(const Value& g, const Vector& v) { return rate(v, -g); }
  static Quaternion quaternion(const Value& g);

  static double distance(const Value& g);
  static double reach(const Value& g0, const Vector& turn, const Value& g1);
  static std::string singularity(const Value& g);
  static double stretch(const Value& g);
};

/// [P5] theta' = omega . n, n' = (omega - n (omega . n)) cot(theta/2)/2 + omega x n / 2. Singular
/// at theta = 2 pi k, 0 too.
struct AxisAngleEquation : RegularEquation<Eigen::Vector4d> {
  // Value: n and theta.
  static Value start(const Rotation& r);
  static Value rate(const Vector& omega, const Value& y);
  /// [N15] in the body frame.
  static Vector body_error(const Value& y, const Value& dy);
  static Value turning(const Value& y, const Vector& v);
  static Value restoring(const Value& y);
  static Quaternion quaternion(const Value& y);

  static double distance(const Value& y);
  static double reach(const Value& y0, const Vector& turn, const Value& y1);
  static std::string singularity(const Value& y);
  static double stretch(const Value& y) { return std::abs(y.w()); }
};

/// Throws std::invalid_argument, with the angle, for a start at a singularity or as near to one as
/// the rounding of its angle is.
void refuse_start(const std::string& singularity, const Rotation& r, double distance);
/// The distance of an angle from the nearest 2 pi k, k != 0.
double distance_from_full_turns(double theta);
/// Whether theta0 and theta1 are between the same two neighbours of 2 pi k.
bool same_turn(double theta0, double theta1);
/// The part of `turn` across n: by that much a step moves past the singularity on the axis n.
double across(const Vector& turn, const Vector& n);
/// The reach of a step in a chart n f(theta), by its turn across n. Next to a full turn, at a
/// distance d, n moves by across/d. That is a chord of length theta across/d, and the motion an
/// arc: what lies between, theta (across/d)^2 / 2, must be twice d at most, or the stages of a step
/// see nothing of the motion.
double reach_across(double theta, double across);
/// "2 pi", "-4 pi", "0": the multiple of 2 pi nearest to theta.
std::string full_turns_text(double theta);

}  // namespace rotor
