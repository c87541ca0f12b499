// Step control as pure functions.
#pragma once

#include <algorithm>

namespace rotor {

/// What may be spent on the error of a run, handed out over its interval.
///
/// The attitude flow is an isometry: local errors add and never grow, so the sum of the local
/// errors bounds the global one and the accuracy asked for can be shared out. What is granted up to
/// a point grows in proportion to the way done, after a first tenth; a step may take what its own
/// length grants, or an eighth of what is left over so far: that carries a run across a jump of
/// omega, where the error of a step falls only in proportion to its length and no error per unit
/// length can be kept.
class ErrorBudget {
 public:
  /// `accuracy` for the whole way, of length `length` > 0.
  ErrorBudget(double accuracy, double length) : accuracy_(accuracy), length_(length) {}

  /// The largest error that a step of size h ending at `done` (the way done, h included) may have.
  double allowed(double h, double done) const;
  void spend(double error) { spent_ += error; }
  double left() const { return std::max(0.0, accuracy_ - spent_); }

 private:
  double accuracy_;
  double length_;
  double spent_ = 0;
};

/// Factor from this step's size to the next's: the error of a step goes with the power `exponent`
/// of its size; between 1/5 and 5, aiming at 0.9 of the size that would just be allowed; 1/5 for an
/// error that is not a number, or where nothing is allowed.
double step_factor(double error, double allowed, double exponent);

}  // namespace rotor
