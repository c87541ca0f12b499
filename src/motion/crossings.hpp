// Where the axis and angle of a motion pass through theta = 2 pi k, and how.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "integrate/propagator.hpp"
#include "motion/turns.hpp"
#include "motion/zero_of_m.hpp"
#include "rotation/rotation.hpp"
#include "spin/angular_velocity.hpp"

namespace rotor {

enum class Passage {
  kThrough,   // into the neighbouring interval of theta
  kBack,      // theta turned back
  kUndecided  // which of the two, or whether it was a crossing at all; followed as "back"
};

/// A passage of axis and angle through theta = 2 pi k, where M = n sin(theta/2) is zero.
struct Crossing {
  double t = 0;
  double t_error = 0;
  Passage kind = Passage::kUndecided;
  double turn_before = 0;  // the integer l with 2 pi l <= theta <= 2 pi (l + 1)
  double turn_after = 0;
  double multiple = 0;  // theta is 2 pi times that
  double distance = 0;  // how near theta came to 2 pi k as computed, rad
  /// Of the first derivative of omega that is not zero there; nothing where none is known.
  std::optional<std::size_t> order = std::nullopt;
  Vector derivative = Vector::Zero();  // that one, in the frame of omega
  double derivative_error = 0;
  bool by_jets = false;  // else by differences
  Vector axis;           // the limits of n and of n' there; NaN where there are none
  Vector axis_rate;
  std::string note;  // what else is to be said: why it is undecided, why there is no axis
};

/// In the place of an axis that has no limit, or of its rate.
inline const Vector kNoAxis = Vector::Constant(std::numeric_limits<double>::quiet_NaN());

/// A time at which M is zero, as far as its error tells.
struct Zero {
  double t;
  double begin = t;  // |M| is lost in its error from about here, in the order of the motion,
  double end = t;    // to here
  double low = t;    // omega is smooth from here
  double high = t;   // to here
  std::optional<AxisSeries> series = std::nullopt;  // there n = sign * series
  double sign = 0;
  Vector limit = kNoAxis;  // of n,
  Vector rate = kNoAxis;   // and of n' where there is no series

  /// n and n' at t near it; needs a series.
  AxisSeries::Value axis(double at) const {
    const AxisSeries::Value value = (*series)(at - t);
    return {(sign * value.axis).array() + 0.0, (sign * value.rate).array() + 0.0};  // no -0
  }
};

/// The search for the crossings of one motion, as far as it was asked for.
///
/// M = 0 has co-dimension three: |M| has a minimum there, and does not change sign. What is less
/// than the tolerance is a crossing, what is more than four times that (or four times the error of
/// M, if this is more) a near miss, and what lies between undecided. M itself tells the case: it
/// has gone through the origin, or turned back, by the time it is 64 times its error away. The
/// derivatives of omega confirm it, and give the axis there.
class Crossings {
 public:
  /// `tolerance`: how near, in rad, theta comes to 2 pi k where it is a crossing; twice the error
  /// of the run unless it is given. `turn`: that of the start. A start at theta = 2 pi k, on M = 0,
  /// goes on upward, but downward where its axis would otherwise jump to the opposite.
  Crossings(AngularVelocity omega, Propagator propagator, const Rotation& start,
            const StartTurn& turn, std::optional<double> tolerance);

  /// Looks up to t; throws std::length_error where the motion is too long for that, Interrupted
  /// where the observer says no, and what omega throws: then it begins anew when it is asked again.
  void look_until(double t, const Observer& observer);

  double tolerance() const;
  const std::optional<double>& given_tolerance() const { return tolerance_; }

  // What was found up to there:
  const std::vector<Crossing>& list() const { return search_.crossings; }
  /// The interval of theta at t.
  double turn_at(double t) const;
  /// The zero of M nearest to t, null if there is none.
  const Zero* zero_near(double t) const;
  /// The one that t itself is, as far as the error of M tells; else null.
  const Zero* zero_at(double t) const;
  /// What is to be said about the axis at the start, and at an end that is a zero.
  const std::string& note_of_start() const { return search_.note_of_start; }
  const std::string& note_of_end() const { return search_.note_of_end; }

 private:
  // Where |M| is as small as that, samples lie eight times nearer: M turns by less than 0.1 between
  // two.
  static constexpr double kSmall = 0.25;

  struct Sample {
    double t = 0;
    double size = std::numeric_limits<double>::infinity();  // |M|
  };
  // What M may be wrong by at a place, and what |M| is compared with there.
  struct Scale {
    double error;
    double lost;     // its direction is
    double zero;     // below it is zero, or called so
    double nonzero;  // above it is not
    double away;     // before a zero, and after it: its direction is known
  };

  // As far as it has come.
  struct Search {
    bool begun = false;
    std::vector<TimeSpan> spans;  // to be looked through
    std::size_t next = 0;         // of them
    Sample before;
    Sample last;
    double spacing = 0;  // of the samples
    double settled = 0;  // what comes before it is not looked at again
    double first_turn = 0;
    std::vector<Zero> zeros;
    std::vector<Crossing> crossings;
    std::string note_of_start;
    std::string note_of_end;
  };

  Vector m(double t) const { return propagator_(t, start_).vec(); }
  double forward() const { return propagator_.t1 >= propagator_.t0 ? 1 : -1; }
  // Whether the motion comes to b after a.
  bool ahead(double a, double b) const { return (b - a) * forward() > 0; }
  double rate_of_size(double t) const;
  double error_of_m() const;
  double error_of_m(double t) const;
  Scale scale_of(double t, double error) const;
  double reach(double t, double towards, double size) const;
  std::pair<double, double> around(double t) const;

  void begin();
  void start_on_zero();
  void push(double t);
  void finish();
  void look_between(double ta, double tb);
  double least_between(double ta, double tb) const;
  std::vector<double> minima_about(double t, double width) const;
  void settle(double t, double size);
  void leave_undecided(const Scale& scale, Crossing& crossing) const;
  void decide(const Scale& scale, Crossing& crossing, Zero& zero) const;
  std::optional<Passage> passage(const Zero& zero, const Vector& expected_before,
                                 const Vector& expected_after, double away) const;
  bool keeps_to(const std::function<Vector(double)>& axis,
                const std::function<double(double)>& slack, const Crossing& crossing, double outer,
                const Scale& scale) const;
  bool has_sizes(const Zero& zero, const AxisSeries& series, double t) const;
  void decide_by_order(const ZeroOrder& order, double w, const Scale& scale, Crossing& crossing,
                       Zero& zero) const;
  void decide_by_motion(const Scale& scale, bool contradicted, Crossing& crossing,
                        Zero& zero) const;

  AngularVelocity omega_;
  Propagator propagator_;
  Quaternion start_;
  Vector start_axis_;  // zero at theta = 0
  StartTurn turn_;
  std::optional<double> tolerance_;
  Search search_;
};

}  // namespace rotor
