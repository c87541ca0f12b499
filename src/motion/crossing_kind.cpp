// What a zero of M is: through or back, of which order, with which axis.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "motion/crossings.hpp"
#include "rotation/text.hpp"

namespace rotor {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
// The cosine of an angle at which one direction goes along another: 45 degrees.
constexpr double kAlong = std::numbers::sqrt2 / 2;
// Directions that differ by less, in rad, can be those of one axis that moves a little.
constexpr double kSame = 0.1;

bool is_zero(const Derivatives& omega) {
  for (std::size_t k = 0; k < Derivatives::kCount; ++k) {
    if (!omega.c[k].isZero(0) || !std::isfinite(omega.error[k])) return false;
  }
  return true;
}

double factorial(std::size_t n) { return std::tgamma(static_cast<double>(n) + 1); }

// The order of the first derivative at the start: a lower one is zero where it is no more than what
// the next one makes of the rounding of t0.
std::optional<std::size_t> first_not_zero(const Derivatives& omega, double t0) {
  for (std::size_t i = 0; i < Derivatives::kCount; ++i) {
    const double next = i + 1 < Derivatives::kCount && omega.differs_from_zero(i + 1)
                            ? static_cast<double>(i + 1) * norm(omega.c[i + 1])
                            : 0;
    if (omega.differs_from_zero(i) && norm(omega.c[i]) > 4 * kEpsilon * next * std::abs(t0)) {
      return i;
    }
  }
  return std::nullopt;
}

std::string in_short(const Vector& v) {
  return "(" + text(v.x(), 4) + ", " + text(v.y(), 4) + ", " + text(v.z(), 4) + ")";
}

std::string why_no_limit(const Derivatives& omega, bool steady, bool has_axis) {
  if (is_zero(omega)) {
    return "the body is at rest there, omega and its derivatives are zero: the axis has no limit";
  }
  if (!steady) {
    return "the axis turns ever faster towards it, or faster than the run can tell: it has no "
           "limit "
           "that is known";
  }
  return "no derivative of omega is known to differ from zero there" +
         (omega.no_jets.empty() ? "" : " (" + omega.no_jets + ")") +
         (has_axis ? ": how it goes on, and the axis, are by the motion alone"
                   : ": the axis has no limit that is known");
}

}  // namespace

// M is as small as its error at t, or nearly.
void Crossings::settle(double t, double size) {
  Scale scale = scale_of(t, error_of_m());
  // There the direction of M is known.
  const auto away = [&] { return std::min(std::max(32 * scale.lost, 4 * size), kSmall); };
  Zero zero{t};
  zero.begin = reach(t, search_.settled, away());
  zero.end = reach(t, propagator_.t1, away());
  if (zero.begin == propagator_.t0) {
    scale = scale_of(t, error_of_m(zero.end));
    zero.end = reach(t, propagator_.t1, away());
  }
  if (size > scale.nonzero) return;
  search_.settled = zero.end;
  std::tie(zero.low, zero.high) = around(t);
  scale.away = away();
  Crossing crossing;
  crossing.t = t;
  crossing.distance = 2 * std::asin(std::min(size, 1.0));
  crossing.turn_before = crossing.turn_after = crossing.multiple = turn_at(t);
  const bool upper = sign_of_turn(crossing.turn_before) * propagator_(t, start_).w() < 0;
  if (upper) crossing.multiple += 1;
  if (size > scale.zero) {
    leave_undecided(scale, crossing);
  } else {
    decide(scale, crossing, zero);
  }
  // What a tolerance above the error calls a zero has an M whose direction is known.
  if (size <= scale.lost) {
    zero.limit = crossing.axis;
    search_.zeros.push_back(zero);
  }
  // A run that ends there has passed nothing.
  if (zero.end == propagator_.t1 && norm(m(zero.end)) <= scale.nonzero) {
    search_.note_of_end = crossing.note;
  } else {
    search_.crossings.push_back(crossing);
  }
}

void Crossings::leave_undecided(const Scale& scale, Crossing& crossing) const {
  const Vector m_least = m(crossing.t);
  crossing.axis = unit(m_least) * sign_of_turn(crossing.turn_before);
  crossing.axis_rate = kNoAxis;
  crossing.t_error = 2 * norm(m_least) / norm(propagator_.flow->generator(crossing.t));
  crossing.note = "theta comes to " + text(crossing.distance, 3) + " rad of 2 pi k: up to " +
                  text(2 * scale.zero, 3) + " (crossing_tolerance) is a crossing, from " +
                  text(2 * scale.nonzero, 3) + " on a near miss; followed as turning back";
}

// M itself tells the case [theory 3]: by the cosines of the angles that it makes before and after
// with the directions expected. Nothing where it does not go along these.
std::optional<Passage> Crossings::passage(const Zero& zero, const Vector& expected_before,
                                          const Vector& expected_after, double away) const {
  const Vector before = m(zero.begin);
  const Vector after = m(zero.end);
  const double a = before.dot(expected_before) / norm(before);
  const double b = after.dot(expected_after) / norm(after);
  // Beside the start M is known, but may be no farther from zero than the motion passes it.
  const bool is_along = std::abs(a) > kAlong || norm(before) < away;
  if (!is_along || !(std::abs(b) > kAlong)) return std::nullopt;
  return a * b < 0 ? Passage::kThrough : Passage::kBack;
}

// Whether |M| is where the zero ends as a series about t foretells.
bool Crossings::has_sizes(const Zero& zero, const AxisSeries& series, double t) const {
  const double ratio = norm(m(zero.end)) / series.size(zero.end - t);
  return ratio > 0.25 && ratio < 4;
}

// Whether M goes along that axis, known to `slack`, but for its error and what it misses zero by,
// from where it comes out of that error to `outer`: not where it spins without limit [P6].
bool Crossings::keeps_to(const std::function<Vector(double)>& axis,
                         const std::function<double(double)>& slack, const Crossing& crossing,
                         double outer, const Scale& scale) const {
  constexpr int kPlaces = 16;
  const double aside = scale.lost + 2 * std::sin(crossing.distance / 2);
  const double inner = reach(crossing.t, outer, 8 * scale.lost);
  for (int part = 0; part < kPlaces; ++part) {
    const double place = inner + (outer - inner) * part / kPlaces;
    const Vector there = m(place);
    if (norm(axis(place).cross(there)) > slack(place) * norm(there) + aside) return false;
  }
  return true;
}

void Crossings::decide(const Scale& scale, Crossing& crossing, Zero& zero) const {
  const double w = propagator_(crossing.t, start_).w();
  // A tolerance may be more than the error: then M may miss zero, and t is as uncertain.
  const double error =
      tolerance_ ? std::max(scale.error, std::sin(crossing.distance / 2)) : scale.error;
  const auto order = order_of_zero(omega_, crossing.t, error, zero.low, zero.high);
  if (order) decide_by_order(*order, w, scale, crossing, zero);
  if (!zero.series) decide_by_motion(scale, order.has_value(), crossing, zero);
  if (crossing.kind == Passage::kThrough) {
    crossing.turn_after += crossing.multiple > crossing.turn_before ? 1 : -1;
  }
  if (!zero.series) return;
  // Before the zero of a run that goes backward, s is positive.
  const bool turned = forward() < 0 && *crossing.order % 2 == 0;
  zero.sign = sign_of_turn(crossing.turn_after) * (turned ? -1 : 1);
  const AxisSeries::Value at_zero = zero.axis(zero.t);
  crossing.axis = at_zero.axis;
  crossing.axis_rate = at_zero.rate;
}

// The order confirms what M does, and knows the axis.
void Crossings::decide_by_order(const ZeroOrder& order, double w, const Scale& scale,
                                Crossing& crossing, Zero& zero) const {
  const bool odd = order.order % 2 == 1;
  AxisSeries series(order.omega, order.order, w, omega_.frame(),
                    order.order == 0 ? order.t_error : kEpsilon * std::abs(order.t));
  const Passage expected = odd ? Passage::kBack : Passage::kThrough;
  const Vector before = series(zero.begin - order.t).axis;
  const Vector after = series(zero.end - order.t).axis;
  const auto along = [&](double place) { return series(place - order.t).axis; };
  // Never so much that any axis would do.
  const auto slack = [&](double place) {
    return kSame + std::min(4 * series.error(place - order.t).axis, 2 * kSame);
  };
  // On the way from there the axis does not turn so far that it could be its opposite.
  const auto borne_out = [&](double place, const Vector& foretold) {
    const Vector there = m(place);
    const double angle = norm(there.cross(foretold)) / norm(there);
    const double missed = std::sin(crossing.distance / 2) / norm(there);
    return norm(there) < scale.away || angle <= slack(place) + 1.5 * missed;
  };
  const bool agrees = series.error(0).axis <= kSame && borne_out(zero.begin, before) &&
                      borne_out(zero.end, after) &&
                      keeps_to(along, slack, crossing, zero.begin, scale) &&
                      keeps_to(along, slack, crossing, zero.end, scale);
  const bool ends = norm(m(zero.end)) < scale.away;
  if (agrees && (ends || (before.dot(after) > 0 && has_sizes(zero, series, order.t) &&
                          passage(zero, before, after, scale.away) == expected))) {
    crossing.kind = expected;
    crossing.t = zero.t = order.t;
    zero.series = std::move(series);
  } else {
    crossing.note = "the motion does not bear out the derivatives of omega, which say order " +
                    std::to_string(order.order) + ": " + (odd ? "back" : "through") + ", along " +
                    in_short(series(0).axis);
  }
  crossing.t_error = order.t_error;
  crossing.order = order.order;
  const double factor = factorial(order.order);
  crossing.derivative = factor * order.omega.c[order.order];
  crossing.derivative_error = factor * order.omega.error[order.order];
  crossing.by_jets = order.omega.no_jets.empty();
}

// M alone, from where it leaves its error to where it is away.
void Crossings::decide_by_motion(const Scale& scale, bool contradicted, Crossing& crossing,
                                 Zero& zero) const {
  crossing.axis = crossing.axis_rate = kNoAxis;
  const double begin = reach(crossing.t, zero.begin, scale.zero);
  const double end = reach(crossing.t, zero.end, scale.zero);
  crossing.t = zero.t = begin + (end - begin) / 2;
  crossing.t_error = std::abs(end - begin) / 2;
  const auto is_steady = [&](double outer) {
    const Vector last = m(outer);
    return last.isZero(0) || keeps_to([n = unit(last)](double) { return n; },
                                      [](double) { return kSame; }, crossing, outer, scale);
  };
  const bool steady = is_steady(zero.begin) && is_steady(zero.end);
  const Vector after = m(zero.end);
  if (steady && norm(after) >= scale.away) {
    const Vector n = unit(after);
    const auto seen = passage(zero, n, n, scale.away);
    crossing.kind = seen.value_or(Passage::kUndecided);
    const double sign = crossing.kind == Passage::kThrough ? -1 : 1;
    const double turned = norm(n.cross(m(zero.begin))) / norm(m(zero.begin));
    if (seen && turned <= kSame) crossing.axis = sign * sign_of_turn(crossing.turn_before) * n;
  }
  const auto [low, high] = around(crossing.t);
  const Derivatives omega = derivatives_at(omega_, crossing.t, low, high);
  const bool rests = is_zero(omega);
  if (rests) crossing.axis = kNoAxis;
  if (contradicted && steady && !rests) {
    if (crossing.axis.hasNaN()) crossing.note += "; the axis has no limit that is known";
    return;
  }
  crossing.order = std::nullopt;
  crossing.note = why_no_limit(omega, steady, !crossing.axis.hasNaN());
}

// The angle is a multiple of 2 pi and M = 0, exactly: the axis comes from omega alone.
void Crossings::start_on_zero() {
  const double t = propagator_.t0;
  const Scale scale = scale_of(t, error_of_m());
  Zero zero{t};
  zero.begin = t;
  zero.end = reach(t, propagator_.t1, std::min(32 * scale.lost, kSmall));
  std::tie(zero.low, zero.high) = around(t);
  const Derivatives omega = derivatives_at(omega_, t, zero.low, zero.high);
  if (const auto order = first_not_zero(omega, t)) {
    zero.series.emplace(omega, *order, start_.w(), omega_.frame(), 0);
    const double sign =
        sign_of_turn(search_.first_turn) * (forward() < 0 && *order % 2 == 0 ? -1 : 1);
    const bool away = (sign * (*zero.series)(0).axis).dot(start_axis_) < 0;
    if (away) search_.first_turn -= 1;
    zero.sign = away ? -sign : sign;
    zero.limit = zero.axis(t).axis;
    if (norm(start_axis_.cross(zero.limit)) > 1e-8) {
      search_.note_of_start = "at the start: the axis goes on from " + text(zero.limit) +
                              ", not from that of the start, which is at a multiple of 2 pi";
    }
  } else if (is_zero(omega) && !start_axis_.isZero(0)) {
    zero.limit = start_axis_;
    zero.rate = Vector::Zero();
    search_.note_of_start =
        "at the start: the body is at rest there, at a multiple of 2 pi: its "
        "axis is that of the start until it leaves";
  } else {
    search_.note_of_start = "at the start: " + why_no_limit(omega, true, false);
  }
  // Where no derivative tells, M does: the axis does not jump to the opposite where the body
  // leaves.
  if (!zero.series && sign_of_turn(search_.first_turn) * m(zero.end).dot(start_axis_) < 0) {
    search_.first_turn -= 1;
  }
  search_.zeros.push_back(zero);
  search_.settled = zero.end;
}

}  // namespace rotor
