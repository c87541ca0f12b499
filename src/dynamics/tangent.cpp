#include "dynamics/tangent.hpp"

#include <cmath>
#include <numbers>

#include "rotation/extended.hpp"
#include "rotation/kinematics.hpp"
#include "rotation/operators.hpp"
#include "rotation/small_angle.hpp"

namespace rotor {
namespace {

// c(theta) = (1 - g)/theta^2 of [P7] and c'(theta)/theta.
struct EulerFactors {
  Extended c;
  Extended curvature;
};

// From theta g' = g - g^2 - theta^2/4 it is c'/theta = (1/4 - (g + 2) c)/theta^2. Below theta = 1/2
// the sum of (2k - 2) |B_2k|/(2k)! theta^(2k-4), k = 2, 3, ..., whose terms fall by (theta/2 pi)^2
// < 1/157 or so each: the first left out is 1e-16 of the sum. Beyond, the difference cancels at
// most to theta^4/360, 1.7e-4, and g = (theta/2) M0/|M| is known as the quaternion is: what its
// rounding does to c theta^2 and c' theta^3, which A is made of, is that of g.
EulerFactors euler_factors(const State& state) {
  const Extended theta2 = Extended{state.angle} * state.angle;
  if (theta2 < 0.25L) {
    constexpr Extended kTerms[] = {2.0L / 720,
                                   4.0L / 30240,
                                   6.0L / 1209600,
                                   8.0L / 47900160,
                                   10 * 691.0L / 1307674368000,
                                   12.0L / 74724249600,
                                   14 * 3617.0L / 10670622842880000};
    Extended sum = 0;
    for (int k = 6; k >= 0; --k) sum = sum * theta2 + kTerms[k];
    return {one_minus_half_cot(state.angle), sum};
  }
  const Quaternion& q = state.quaternion;
  const Extended g = Extended{state.angle} / 2 * q.w() / state.axis.dot(q.vec());
  const Extended c = (1 - g) / theta2;
  return {c, (0.25L - (g + 2) * c) / theta2};
}

// Of [P7]: omega - {omega |E|^2 - E (omega . E)} c + s omega x E / 2, s = 1 in the space frame, -1
// in the body frame.
Matrix euler_rate_jacobian(const State& state, const Vector& omega, double sign) {
  const Vector e = state.euler_vector();
  const EulerFactors factors = euler_factors(state);
  const auto c = static_cast<double>(factors.c);
  const Vector braces = omega * e.squaredNorm() - e * omega.dot(e);
  return -c * (2 * omega * e.transpose() - omega.dot(e) * Matrix::Identity() -
               e * omega.transpose()) -
         static_cast<double>(factors.curvature) * braces * e.transpose() + sign / 2 * skew(omega);
}

}  // namespace

Matrix chart_jacobian(Chart chart, const State& state) {
  const Matrix one = Matrix::Identity();
  switch (chart) {
    case Chart::kEulerVector:
      return exp_jacobian_inverse(state.euler_vector().cast<Extended>()).cast<double>();
    case Chart::kModifiedGibbs:
      return (state.quaternion.w() * one - skew(state.modified_gibbs())) / 2;
    case Chart::kGibbs: {
      const Vector g = state.gibbs();
      return (one + g * g.transpose() - skew(g)) / 2;
    }
    case Chart::kMrp: {
      const Vector p = state.mrp();
      return ((1 - p.squaredNorm()) * one + 2 * p * p.transpose() - 2 * skew(p)) / 4;
    }
    default:
      return one;
  }
}

Matrix rate_jacobian(Chart chart, const State& state, const Vector& omega, Frame frame) {
  const Matrix one = Matrix::Identity();
  const double sign = frame == Frame::kSpace ? 1 : -1;
  switch (chart) {
    case Chart::kEulerVector:
      return euler_rate_jacobian(state, omega, sign);
    case Chart::kModifiedGibbs:  // M0^2 = 1 - |M|^2
      return (sign * skew(omega) - omega * state.gibbs().transpose()) / 2;
    case Chart::kGibbs: {
      const Vector g = state.gibbs();
      return (omega.dot(g) * one + g * omega.transpose() + sign * skew(omega)) / 2;
    }
    case Chart::kMrp: {
      // p' = {omega (1 - |p|^2) + 2 p (omega . p) + 2 s omega x p}/4.
      const Vector p = state.mrp();
      return (p.dot(omega) * one + p * omega.transpose() - omega * p.transpose() +
              sign * skew(omega)) /
             2;
    }
    default:
      return frame == Frame::kSpace ? skew(omega) : Matrix(Matrix::Zero());
  }
}

double distance_from_singularity(Chart chart, const State& state) {
  const double cosine = state.quaternion.w();
  const double sine = norm(state.quaternion.vec());
  switch (chart) {
    case Chart::kEulerVector:
      return std::abs(state.angle) < 1 ? 1 : sine;
    case Chart::kModifiedGibbs:
    case Chart::kGibbs:
      return std::abs(cosine);
    case Chart::kMrp:
      return cosine > 0 ? 1 : sine;
    default:
      return 1;
  }
}

double part_of_chart(Chart chart, const State& state) {
  switch (chart) {
    case Chart::kEulerVector:  // about 0 it is one part, |theta| < 2 pi
      return std::trunc(state.angle / (2 * std::numbers::pi));
    case Chart::kModifiedGibbs:
    case Chart::kGibbs:
      return state.quaternion.w() < 0 ? 1 : 0;
    default:
      return 0;
  }
}

}  // namespace rotor
