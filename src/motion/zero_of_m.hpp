// About a zero of M: its order, and the axis as a series in t.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "rotation/rotation.hpp"
#include "spin/derivatives.hpp"

namespace rotor {

/// Where M = 0 at t, and omega^(i) is the first derivative of omega that is not zero there, M is
/// s^(i+1) P(s) with a P that is not zero, s the time from t on: n = +-P/|P| is continuous, and
/// n(0) and n'(0) are those of Lemma 5.3 (with i + 2 in n'). P comes from the derivatives of omega
/// by q' = omega q / 2.
class AxisSeries {
 public:
  /// The part of M0 in n is its sign: `w`. Derivatives below the order count as zero. t itself is
  /// right to `time_error`. `frame`: that of omega.
  AxisSeries(const Derivatives& omega, std::size_t order, double w, Frame frame, double time_error);

  /// The axis s after t, but for its sign, and its rate.
  struct Value {
    Vector axis;
    Vector rate;
  };
  Value operator()(double s) const;
  /// |M| there.
  double size(double s) const;
  /// What the two may be wrong by, as far as the last terms of the series tell.
  struct Error {
    double axis;
    double rate;
  };
  Error error(double s) const;

 private:
  std::vector<Vector> p_;  // the coefficients of P, and
  std::vector<double> e_;  // what each may be wrong by
  std::size_t order_;
  double time_error_;
};

/// The order of a zero of M, as far as it can be told.
struct ZeroOrder {
  std::size_t order;
  /// Of order 1 and higher, where omega^(order - 1) is least: the derivatives of omega know that
  /// better than M does.
  double t;
  /// By which M alone would know t: (2 (i+1)! error / |omega^(i)|)^(1/(i+1)) [theory 3].
  double t_error;
  Derivatives omega;  // at t
};

/// Near `t`, where |M| is least, M is known to `error`. Its term of order i, |omega^(i)| s^(i+1) /
/// (2 (i+1)!), comes out of that error at some s_i, and until then t is uncertain by as much. So
/// "omega^(j) = 0" means that omega^(j) could be zero within s_i: the order is the highest for
/// which the lower terms, at the t that suits it best, come out of the error later. Nothing where
/// no derivative differs from zero. Derivatives by differences stay between low and high.
std::optional<ZeroOrder> order_of_zero(const AngularVelocity& omega, double t, double error,
                                       double low, double high);

}  // namespace rotor
