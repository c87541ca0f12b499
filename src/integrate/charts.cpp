#include "integrate/charts.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "rotation/extended.hpp"
#include "rotation/kinematics.hpp"
#include "rotation/operators.hpp"
#include "rotation/small_angle.hpp"
#include "rotation/text.hpp"

namespace rotor {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Extended kTwoPi = 2 * std::numbers::pi_v<Extended>;

// The stretch of a matrix near the rotations: R = Q S, S^2 = R^T R, to second order in S - 1.
Matrix stretch_of(const Matrix& r) { return 0.5 * (Matrix::Identity() + r.transpose() * r); }

}  // namespace

void refuse_start(const std::string& singularity, const Rotation& r, double distance) {
  if (!(distance > 4 * std::numeric_limits<double>::epsilon() * std::abs(r.angle()))) {
    throw std::invalid_argument(singularity + "; the start's angle is " + text(r.angle()));
  }
}

double distance_from_full_turns(double theta) {
  const Extended turns = std::max(Extended{1}, std::round(std::abs(theta) / kTwoPi));
  return static_cast<double>(std::abs(std::abs(theta) - turns * kTwoPi));
}

bool same_turn(double theta0, double theta1) {
  return std::floor(theta0 / kTwoPi) == std::floor(theta1 / kTwoPi);
}

double across(const Vector& turn, const Vector& n) { return norm(turn - n * n.dot(turn)); }

double reach_across(double theta, double across) {
  const double d = distance_from_full_turns(theta);
  return across / d * std::max(1.0, std::sqrt(theta / d) / 2);
}

std::string full_turns_text(double theta) {
  const std::string twice = text(static_cast<double>(2 * std::round(theta / kTwoPi)));
  const bool whole = twice.ends_with(".0");
  return twice == "0.0" ? "0" : twice.substr(0, twice.size() - (whole ? 2 : 0)) + " pi";
}

// --- [P1]

Matrix BodyPointsEquation::rate(const Vector& omega, const Value& r) { return skew(omega) * r; }

// R' = Q (Omega S + S') for R = Q S, so that the skew part of Q^T R' is (Omega S + S Omega)/2, and
// that of (S x) is (tr S - S) x / 2.
Vector BodyPointsEquation::body_error(const Value& r, const Value& dr) {
  const Matrix s = stretch_of(r);
  const Vector twice = 2 * axial(s.inverse() * r.transpose() * dr);
  return (s.trace() * Matrix::Identity() - s).inverse() * twice;
}

Matrix BodyPointsEquation::turning(const Value& r, const Vector& v) { return r * skew(v); }

// R S^-1 to first order.
Matrix BodyPointsEquation::restoring(const Value& r) {
  return 0.5 * r * (Matrix::Identity() - r.transpose() * r);
}

Quaternion BodyPointsEquation::quaternion(const Value& r) {
  // What is left of a deviation d is 3/2 d^2: from 1e-2 in three rounds below rounding.
  Matrix q = r;
  for (int round = 0; round < 3; ++round) q += restoring(q);
  return Quaternion(q).normalized();
}

// --- [P7]

Vector EulerEquation::start(const Rotation& r) const {
  Value e = r.euler_vector();
  refuse_start(singularity(e), r, distance_from_full_turns(norm(e)));
  return is_due(e) ? r.canonical().euler_vector() : e;  // what restarting comes to
}

Vector EulerEquation::rate(const Vector& omega, const Value& e) {
  const ExtendedVector wide = e.cast<Extended>();
  const ExtendedVector cross = wide.cross(omega.cast<Extended>());
  return (omega.cast<Extended>() - cross / 2 + one_minus_half_cot(wide.norm()) * wide.cross(cross))
      .cast<double>();
}

// The right Jacobian.
Vector EulerEquation::body_error(const Value& e, const Value& de) {
  const ExtendedVector wide = e.cast<Extended>();
  const Extended theta = wide.norm();
  const ExtendedVector cross = wide.cross(de.cast<Extended>());
  return (de.cast<Extended>() - one_minus_cos(theta) * cross +
          angle_minus_sin(theta) * wide.cross(cross))
      .cast<double>();
}

Quaternion EulerEquation::quaternion(const Value& e) { return from_euler_vector(e).quaternion(); }

double EulerEquation::distance(const Value& e) const {
  return straight_ ? kInfinity : distance_from_full_turns(norm(e));
}

double EulerEquation::reach(const Value& e0, const Vector& turn, const Value& e1) const {
  if (straight_) return 0;
  const double theta = norm(e0);
  if (!same_turn(theta, norm(e1))) return kInfinity;
  return reach_across(theta, across(turn, e0.stableNormalized()));
}

std::string EulerEquation::singularity(const Value& e) {
  return "equation = \"euler\" [P7] is singular at |E| = " +
         full_turns_text(std::max(norm(e), 2 * kPi)) +
         "; restart = true goes on from E (1 - 2 pi/|E|), equation = \"quaternion\" is never "
         "singular";
}

bool EulerEquation::is_due(const Value& e) const { return restart_ && norm(e) > 1.5 * kPi; }

Vector EulerEquation::restarted(const Value& e) {
  const ExtendedVector wide = e.cast<Extended>();
  const Extended theta = wide.norm();
  if (theta == 0) return e;
  return (wide * (1 - kTwoPi / theta)).cast<double>();
}

// --- [P10]

Vector GibbsEquation::start(const Rotation& r) {
  const Value g = r.gibbs();
  refuse_start(singularity(g), r, distance(g));
  return g;
}

Quaternion GibbsEquation::quaternion(const Value& g) {
  return Quaternion(1, g.x(), g.y(), g.z()).normalized();
}

double GibbsEquation::distance(const Value& g) { return 2 * std::atan2(1, norm(g)); }

// A uniform turn by v makes (1, G) cos(theta/2) go as cos(s + a), sin(s + a), s from 0 to |v|/2,
// on the great circle of v, with tan a = G . v/|v|.
double GibbsEquation::reach(const Value& g0, const Vector& turn, const Value&) {
  return norm(turn) / (kPi - 2 * std::atan(g0.dot(turn.stableNormalized())));
}

std::string GibbsEquation::singularity(const Value&) {
  return "equation = \"gibbs\" [P10] is singular at theta = pi, where |G| is infinite; "
         "equation = \"quaternion\" is never singular";
}

double GibbsEquation::stretch(const Value& g) {
  const double size = norm(g);
  return 2 / (1 / size + size);
}

// --- [P5]

Eigen::Vector4d AxisAngleEquation::start(const Rotation& r) {
  const Vector& n = r.axis();
  const Value y(n.x(), n.y(), n.z(), r.angle());
  refuse_start(singularity(y), r, distance(y));
  return y;
}

Eigen::Vector4d AxisAngleEquation::rate(const Vector& omega, const Value& y) {
  const double length = y.head<3>().norm();
  const Vector n = y.head<3>() / length;
  Value dy;
  dy.head<3>() = length * axis_rate(n, 1 / std::tan(Extended{y.w()} / 2), omega);
  dy.w() = omega.dot(n);
  return dy;
}

Vector AxisAngleEquation::body_error(const Value& y, const Value& dy) {
  const double length = y.head<3>().norm();
  const Vector n = y.head<3>() / length;
  const Vector dn = (dy.head<3>() - n * n.dot(dy.head<3>())) / length;
  const double half_sine = std::sin(y.w() / 2);
  return dy.w() * n - 2 * half_sine * half_sine * n.cross(dn) + std::sin(y.w()) * dn;
}

// The sign of the product with n is the other one in the body frame.
Eigen::Vector4d AxisAngleEquation::turning(const Value& y, const Vector& v) {
  const double length = y.head<3>().norm();
  const Vector n = y.head<3>() / length;
  Value dy;
  dy.head<3>() = length * axis_rate(-n, 1 / std::tan(Extended{y.w()} / 2), v);
  dy.w() = v.dot(n);
  return dy;
}

Eigen::Vector4d AxisAngleEquation::restoring(const Value& y) {
  Value dy = y * (1 / y.head<3>().norm() - 1);
  dy.w() = 0;
  return dy;
}

Quaternion AxisAngleEquation::quaternion(const Value& y) {
  return Rotation(y.head<3>(), y.w()).quaternion();
}

double AxisAngleEquation::distance(const Value& y) {
  return std::min(distance_from_full_turns(y.w()), std::abs(y.w()));
}

double AxisAngleEquation::reach(const Value& y0, const Vector& turn, const Value& y1) {
  if (!same_turn(y0.w(), y1.w())) return kInfinity;
  return across(turn, y0.head<3>()) / distance(y0);
}

std::string AxisAngleEquation::singularity(const Value& y) {
  return "equation = \"axis_angle\" [P5] is singular at theta = " +
         full_turns_text(std::abs(y.w())) + "; equation = \"quaternion\" is never singular";
}

}  // namespace rotor
