// [P4] The generalized Euler vector F = n f(theta), f given by the user.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "integrate/equation.hpp"
#include "spin/jet.hpp"

namespace rotor {

/// An odd f with f'(0) > 0, where it can be inverted: from theta = 0 up to the first place where it
/// does not rise, is not finite or is not smooth.
class GeneralizedAngle {
 public:
  using Function = std::function<Jet(const Jet&)>;

  /// Explores f up to theta = 1000 pi, with steps of pi/8 at most: what f does in a narrower place
  /// and leaves no trace of in its first eight derivatives around it is not seen. `name` is what
  /// messages call f. Throws std::invalid_argument unless f(0) = 0, f'(0) > 0 and f is odd, with
  /// what it gave; whatever f throws but NotDifferentiable, which is an end of the domain, passes
  /// through.
  explicit GeneralizedAngle(Function f, std::string name = "f");

  struct Value {
    double f;
    double slope;  // f'
  };
  /// f and f' at an angle; NaN where f has no derivatives there.
  Value operator()(double theta) const;
  /// f'(0).
  double slope_at_zero() const { return slope_at_zero_; }
  /// Where the domain of invertibility ends, to an ulp or two or what f' tells; infinity if nothing
  /// ends it below 1000 pi.
  double end() const { return end_; }
  /// The theta >= 0 with f(theta) = value >= 0, to the last digit that f tells; NaN where the value
  /// is not one of f on its domain.
  double inverse(double value) const;
  const std::string& name() const { return name_; }

 private:
  struct Bracket {
    double low, guess, high;
  };
  Jet jet(double theta) const;
  void check_at_zero();
  void check_odd() const;
  void explore();
  double least_slope_at(double low, double high) const;
  Bracket bracket(double value) const;

  Function f_;
  std::string name_;
  std::vector<double> angles_;  // where the domain was explored, rising
  std::vector<double> values_;  // f there
  double slope_at_zero_ = 0;
  double end_ = 0;
};

/// [P4] F' = omega f' - {omega f^2 - F (omega . F)} (f' - f cot(theta/2)/2)/f^2 + omega x F / 2.
/// Singular at theta = 2 pi k, k >= 1, and where the domain of f ends.
class GeneralizedEquation : public RegularEquation<Vector> {
 public:
  /// With `restart`, where theta exceeds 3 pi/2 the run goes on from the F of theta - 2 pi.
  GeneralizedEquation(std::shared_ptr<const GeneralizedAngle> f, bool restart)
      : f_(std::move(f)), restart_(restart) {}

  Value start(const Rotation& r) const;
  Value rate(const Vector& omega, const Value& y) const;
  Vector body_error(const Value& y, const Value& dy) const;
  Value turning(const Value& y, const Vector& v) const { return rate(v, -y); }
  Quaternion quaternion(const Value& y) const;

  double distance(const Value& y) const;
  double reach(const Value& y0, const Vector& turn, const Value& y1) const;
  std::string singularity(const Value& y) const;
  double stretch(const Value& y) const;
  bool is_due(const Value& y) const;
  Value restarted(const Value& y) const;

 private:
  double angle(const Value& y) const { return f_->inverse(norm(y)); }

  std::shared_ptr<const GeneralizedAngle> f_;
  bool restart_;
};

}  // namespace rotor
