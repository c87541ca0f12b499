// A periodic omega: one period, and powers of its end (Floquet).
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "integrate/exact.hpp"
#include "integrate/legs.hpp"
#include "integrate/recurrence.hpp"
#include "rotation/text.hpp"
#include "rotation/turn.hpp"

namespace rotor {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

// A time as so many periods after zero, a phase in [0, T], and what rounding has taken from it.
struct Phase {
  Extended period;  // a whole number
  double rest;
  double late;
};

// Where a run is after t0: so many periods on, at the phase `rest` of a leg of the first.
struct Place {
  Extended periods;
  std::size_t leg;
  double rest;
  double late = 0;
};

// A period from t0 on has two legs: to the end of the period of omega that t0 is in (its beginning,
// if the run goes backward), and from there to the phase of t0.
class Calendar {
 public:
  Calendar(double period, double t0, bool forward)
      : period_(period), forward_(forward), start_(phase(t0)) {}

  // fmod is exact; before zero the phase is rounded.
  Phase phase(double t) const {
    const double signed_rest = std::fmod(t, period_);
    const double rest = signed_rest < 0 ? signed_rest + period_ : signed_rest;
    const Extended period = std::nearbyint((Extended{t} - rest) / period_);
    if (!(std::abs(period) < 0x1p63L)) {
      throw std::invalid_argument("t = " + text(t) + " is too many periods of " + text(period_) +
                                  " from zero: they cannot be counted");
    }
    // Exact, for |signed_rest| < T.
    return {period, rest, signed_rest < 0 ? signed_rest - (rest - period_) : 0};
  }
  Place place(double t) const {
    const Phase now = phase(t);
    const Extended turned = forward_ ? now.period - start_.period : start_.period - now.period;
    const bool first = forward_ ? now.rest >= start_.rest : now.rest <= start_.rest;
    return {first ? turned : turned - 1, first ? 0U : 1U, now.rest, now.late};
  }
  double time(const Place& place) const {
    const Extended periods = place.periods + static_cast<Extended>(place.leg);
    const Extended period = start_.period + (forward_ ? periods : -periods);
    return static_cast<double>(period * period_ + place.rest);
  }
  const Phase& start() const { return start_; }
  double end_of_first_leg() const { return forward_ ? period_ : 0; }
  double begin_of_second_leg() const { return forward_ ? 0 : period_; }
  // Whether the run comes from a to b.
  bool ahead(double a, double b) const { return forward_ ? a < b : a > b; }

 private:
  double period_;
  bool forward_;
  Phase start_;
};

// t0, ..., t1 from the mesh of a period.
std::vector<double> periodic_mesh(const Calendar& calendar, const std::vector<FollowedLeg>& legs,
                                  double t0, double t1) {
  std::vector<std::vector<double>> parts;
  std::size_t size = 0;
  for (const FollowedLeg& leg : legs) size += parts.emplace_back(leg.flow->mesh()).size();
  const Extended periods = calendar.place(t1).periods;
  if ((periods + 1) * static_cast<Extended>(size) > 1e7L) {
    throw std::length_error(std::to_string(static_cast<std::uint64_t>(periods)) +
                            " periods of omega are too many to be looked through");
  }
  std::vector<double> mesh{t0};
  for (std::size_t n = 0; n <= static_cast<std::size_t>(periods); ++n) {
    for (std::size_t i = 0; i < legs.size(); ++i) {
      for (const double rest : parts[i]) {
        const double t = calendar.time({static_cast<Extended>(n), i, rest});
        if (calendar.ahead(mesh.back(), t) && calendar.ahead(t, t1)) mesh.push_back(t);
      }
    }
  }
  if (t1 != t0) mesh.push_back(t1);
  return mesh;
}

class PeriodicFlow final : public Flow {
 public:
  PeriodicFlow(const Calendar& calendar, FollowedLegs done, double t0, double t1)
      : calendar_(calendar), legs_(std::move(done.legs)), t0_(t0), t1_(t1) {
    const Extended sine = done.at_end.vec().norm();
    if (sine != 0) axis_ = done.at_end.vec() / sine;
    angle_ = 2 * std::atan2(sine, done.at_end.w());
    start_ = small_turn(-calendar_.start().late, legs_.front(), calendar_.start().rest);
  }

  Quaternion at(double t) const override {
    const Place place = calendar_.place(t);
    const FollowedLeg& leg = legs_[place.leg];
    return (small_turn(place.late, leg, place.rest) * leg.flow->at(place.rest).cast<Extended>() *
            leg.before * turn(axis_, angle_ * place.periods) * start_)
        .cast<double>();
  }
  Vector generator(double t) const override {
    const Place place = calendar_.place(t);
    return legs_[place.leg].flow->generator(place.rest);
  }
  std::vector<double> mesh() const override { return periodic_mesh(calendar_, legs_, t0_, t1_); }

  // At one phase of whatever period, U lies on a great circle. It moves at |g|/2: a stretch of the
  // period is out of reach if its middle is farther off than its half can bridge. Of the stretches
  // that are not, the periods in which the circle's own turning meets the target.
  std::vector<TimeSpan> approaches(const Quaternion& target, double distance) const override {
    const auto near = stretches_near(target, distance);
    if (!near) return Flow::approaches(target, distance);
    std::vector<TimeSpan> spans;
    for (const Stretch& stretch : *near) add_meetings(stretch, target, distance, spans);
    std::sort(spans.begin(), spans.end(), [this](const TimeSpan& a, const TimeSpan& b) {
      return calendar_.ahead(a.begin, b.begin);
    });
    return spans;
  }

 private:
  struct Stretch {
    const FollowedLeg* leg;
    double begin;
    double end;

    double middle() const { return begin + (end - begin) / 2; }

    // How far U can get from its middle, if the rate is nowhere twice that of the ends.
    double bridge() const {
      const double rate =
          std::max(norm(leg->flow->generator(begin)), norm(leg->flow->generator(end)));
      return 2 * rate * std::abs(end - begin) / 4;
    }
  };

  // All the stretches in which a great circle comes near the target, none longer than that;
  // nothing where they are too many.
  std::optional<std::vector<Stretch>> stretches_near(const Quaternion& target,
                                                     double distance) const {
    constexpr std::size_t kMostLooks = 20'000;
    constexpr double kShort = 1e-8;
    std::vector<Stretch> open;
    std::vector<Stretch> near;
    for (const FollowedLeg& leg : legs_) {
      const std::vector<double> mesh = leg.flow->mesh();
      if (8 * mesh.size() > kMostLooks) return std::nullopt;
      for (std::size_t i = 1; i < mesh.size(); ++i) {
        const double width = (mesh[i] - mesh[i - 1]) / 8;
        for (int part = 0; part < 8; ++part) {
          open.push_back({&leg, mesh[i - 1] + part * width, mesh[i - 1] + (part + 1) * width});
        }
      }
    }
    for (std::size_t looks = 0; !open.empty(); ++looks) {
      if (looks == kMostLooks) return std::nullopt;
      const Stretch stretch = open.back();
      open.pop_back();
      const double middle = stretch.middle();
      const double bridge = stretch.bridge();
      if (circle_distance(*stretch.leg, middle, target) - distance - 8 * kEpsilon > bridge)
        continue;
      if (bridge <= std::max(distance, kShort) || middle == stretch.begin) {
        near.push_back(stretch);
      } else {
        open.push_back({stretch.leg, stretch.begin, middle});
        open.push_back({stretch.leg, middle, stretch.end});
      }
    }
    return near;
  }

  // U = one turn^k start is plus or minus the target where turn^k, at half the angle k angle_, is
  // plus or minus one* target start*.
  void add_meetings(const Stretch& stretch, const Quaternion& target, double distance,
                    std::vector<TimeSpan>& spans) const {
    const FollowedLeg& leg = *stretch.leg;
    const ExtendedQuaternion one = leg.flow->at(stretch.middle()).cast<Extended>() * leg.before;
    const ExtendedQuaternion wanted =
        one.conjugate() * target.cast<Extended>() * start_.conjugate();
    const Extended half_angle = std::atan2(axis_.dot(wanted.vec()), wanted.w());
    // An arc exceeds its chord by less than a tenth up to 1.5 rad.
    const Extended width = 1.1L * (distance + stretch.bridge() + 8 * kEpsilon);
    const auto last = static_cast<std::uint64_t>(calendar_.place(t1_).periods);
    const auto number = static_cast<std::size_t>(&leg - legs_.data());
    for (const std::uint64_t k : near_multiples_of_pi(angle_ / 2, -half_angle, width, last)) {
      const auto periods = static_cast<Extended>(k);
      const double begin = calendar_.time({periods, number, stretch.begin});
      const double end = calendar_.time({periods, number, stretch.end});
      const double until = calendar_.ahead(t1_, end) ? t1_ : end;
      if (calendar_.ahead(begin, until)) spans.push_back({begin, until});
    }
  }

  // What the motion does in the time `late`, too short for a double.
  static ExtendedQuaternion small_turn(double late, const FollowedLeg& leg, double rest) {
    if (late == 0) return ExtendedQuaternion::Identity();
    const ExtendedVector half = leg.flow->generator(rest).cast<Extended>() * (Extended{late} / 2);
    return ExtendedQuaternion(1, half.x(), half.y(), half.z()).normalized();
  }

  // From the target to the plane of the great circle: no more than to the circle.
  double circle_distance(const FollowedLeg& leg, double rest, const Quaternion& target) const {
    using Four = Eigen::Matrix<Extended, 4, 1>;
    const ExtendedQuaternion one = leg.flow->at(rest).cast<Extended>() * leg.before;
    const ExtendedQuaternion other = one * ExtendedQuaternion(0, axis_.x(), axis_.y(), axis_.z());
    Four across = (target.cast<Extended>() * start_.conjugate()).coeffs();
    for (const Four& side : {one.coeffs(), other.coeffs()}) across -= side * side.dot(across);
    return static_cast<double>(across.norm());
  }

  Calendar calendar_;
  std::vector<FollowedLeg> legs_;
  double t0_;
  double t1_;
  ExtendedVector axis_ = ExtendedVector::UnitX();  // of a period
  Extended angle_ = 0;
  ExtendedQuaternion start_;
};

// The same about a fixed direction: angles add.
class PeriodicTurn final : public FixedAxisFlow {
 public:
  PeriodicTurn(const Calendar& calendar, std::vector<FollowedLeg> legs, double t0, double t1)
      : FixedAxisFlow(fixed(legs.front()).direction()),
        calendar_(calendar),
        legs_(std::move(legs)),
        t0_(t0),
        t1_(t1),
        first_(fixed(legs_.front()).angle(legs_.front().end)),
        period_(first_ + (legs_.size() == 1 ? 0 : fixed(legs_[1]).angle(legs_[1].end))),
        start_(calendar.start().late * fixed(legs_.front()).rate(calendar.start().rest)) {}

  Extended angle(double t) const override {
    const Place place = calendar_.place(t);
    return place.periods * period_ + (place.leg == 0 ? 0 : first_) +
           fixed(legs_[place.leg]).angle(place.rest) + rate(place) * place.late - start_;
  }
  double rate(double t) const override { return static_cast<double>(rate(calendar_.place(t))); }
  std::vector<double> mesh() const override { return periodic_mesh(calendar_, legs_, t0_, t1_); }

  static bool fits(const std::vector<FollowedLeg>& legs) {
    const auto* first = dynamic_cast<const FixedAxisFlow*>(legs.front().flow.get());
    const auto* last = dynamic_cast<const FixedAxisFlow*>(legs.back().flow.get());
    return first != nullptr && last != nullptr && first->direction() == last->direction();
  }

 private:
  static const FixedAxisFlow& fixed(const FollowedLeg& leg) {
    return static_cast<const FixedAxisFlow&>(*leg.flow);
  }
  Extended rate(const Place& place) const { return fixed(legs_[place.leg]).rate(place.rest); }

  Calendar calendar_;
  std::vector<FollowedLeg> legs_;
  double t0_;
  double t1_;
  Extended first_;   // the angle of the first leg
  Extended period_;  // of a period
  Extended start_;   // from the phase of t0 as rounded to t0
};

// What of a period is on the way.
std::vector<Leg> legs_of(const Scene& scene, const PeriodicSpin& omega,
                         const std::vector<double>& breaks, const Calendar& calendar) {
  const AngularVelocity one =
      scene.omega.frame() == Frame::kBody ? omega.one().in_body_frame() : omega.one();
  std::vector<double> phases = breaks;
  for (double& t : phases) t = calendar.phase(t).rest;
  const Place last = calendar.place(scene.t1);
  const double start = calendar.start().rest;
  if (last.periods == 0 && last.leg == 0) return {{one, start, last.rest, scene.t0, phases}};

  std::vector<Leg> legs{{one, start, calendar.end_of_first_leg(), scene.t0, phases}};
  const double begin = calendar.begin_of_second_leg();
  if (begin != start) {
    const double end = last.periods == 0 ? last.rest : start;
    legs.push_back({one, begin, end, calendar.time({0, 1, begin}), phases});
  }
  return legs;
}

}  // namespace

void follow_periodic(const Scene& scene, const PeriodicSpin& omega,
                     const std::vector<double>& breaks, const Observer& observer,
                     Propagator& result) {
  const Calendar calendar(omega.period(), scene.t0, scene.t1 >= scene.t0);
  const std::vector<Leg> legs = legs_of(scene, omega, breaks, calendar);
  const Extended periods = calendar.place(scene.t1).periods;
  // U = (less than a period) (a period)^periods, and errors add.
  const auto times = static_cast<double>(periods + 1);
  FollowedLegs done = follow_legs(scene, legs, scene.accuracy / times, observer);
  result.t1 = scene.t1;
  if (done.stop) {
    // The time of the run may round to a phase that was not reached.
    const double end = done.legs.back().end;
    for (result.t1 = done.stop->t; result.t1 != scene.t0;) {
      const Place place = calendar.place(result.t1);
      const std::size_t final_leg = done.legs.size() - 1;
      if (place.leg < final_leg || (place.leg == final_leg && !calendar.ahead(end, place.rest))) {
        break;
      }
      result.t1 = std::nextafter(result.t1, scene.t0);
    }
    done.stop->t = result.t1;
  }
  result.error_estimate = done.stop ? done.error_estimate : times * done.error_estimate;
  result.cost = done.cost;
  result.accuracy = done.exact ? 0 : scene.accuracy;
  result.method = done.method;
  result.why =
      periods > 0 ? "periodic omega: one period, then Floquet" : "within a period of omega";
  result.stop = done.stop;
  if (PeriodicTurn::fits(done.legs)) {
    result.flow =
        std::make_shared<const PeriodicTurn>(calendar, std::move(done.legs), scene.t0, result.t1);
  } else {
    result.flow =
        std::make_shared<const PeriodicFlow>(calendar, std::move(done), scene.t0, result.t1);
  }
}

}  // namespace rotor
