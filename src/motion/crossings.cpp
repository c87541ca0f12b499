#include "motion/crossings.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "rotation/text.hpp"

namespace rotor {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
// Samples in an interval of the mesh, and again in one of these where |M| is as small as that: then
// M turns by less than 0.1 between two.
constexpr int kParts = 8;
constexpr double kSmall = 0.25;
// The cosine of an angle at which one direction goes along another: 45 degrees.
constexpr double kAlong = std::numbers::sqrt2 / 2;
// Directions that differ by less, in rad, can be those of one axis that moves a little.
constexpr double kSame = 0.1;

// The place of the least `f` between a and b, where it has one minimum (golden section).
template <class Function>
double minimise(const Function& f, double a, double b) {
  constexpr double kGolden = std::numbers::phi - 1;
  double x1 = b - kGolden * (b - a);
  double x2 = a + kGolden * (b - a);
  double f1 = f(x1);
  double f2 = f(x2);
  while (x1 != x2 && std::abs(b - a) > kEpsilon * std::abs(a)) {
    if (f1 < f2) {
      b = std::exchange(x2, x1);
      f2 = f1;
      if ((x1 = b - kGolden * (b - a)) == x2) break;
      f1 = f(x1);
    } else {
      a = std::exchange(x1, x2);
      f1 = f2;
      if ((x2 = a + kGolden * (b - a)) == x1) break;
      f2 = f(x2);
    }
  }
  return f1 < f2 ? x1 : x2;
}

bool is_zero(const Derivatives& omega) {
  for (std::size_t k = 0; k < Derivatives::kCount; ++k) {
    if (!omega.c[k].isZero(0) || !std::isfinite(omega.error[k])) return false;
  }
  return true;
}

double factorial(std::size_t n) { return std::tgamma(static_cast<double>(n) + 1); }

// The order of the first derivative at the start: a lower one is zero where it is no more than what
// terms of the size of t0 leave when they cancel.
std::optional<std::size_t> first_not_zero(const Derivatives& omega, double t0) {
  for (std::size_t i = 0; i < Derivatives::kCount; ++i) {
    double size = 0;
    for (std::size_t k = i + 1; k < Derivatives::kCount; ++k) {
      if (!omega.differs_from_zero(k)) continue;
      size += norm(omega.c[k]) * std::pow(std::abs(t0), static_cast<double>(k - i));
    }
    if (omega.differs_from_zero(i) && norm(omega.c[i]) > 64 * kEpsilon * size) return i;
  }
  return std::nullopt;
}

std::string why_no_limit(const Derivatives& omega) {
  if (is_zero(omega)) {
    return "the body is at rest there, omega and its derivatives are zero: the axis has no limit";
  }
  return "no derivative of omega is known to differ from zero there: the axis has no known limit" +
         (omega.no_jets.empty() ? "" : " (" + omega.no_jets + ")");
}

}  // namespace

Crossings::Crossings(AngularVelocity omega, Propagator propagator, const Rotation& start,
                     const StartTurn& turn, std::optional<double> tolerance)
    : omega_(std::move(omega)),
      propagator_(std::move(propagator)),
      start_(start.quaternion()),
      start_axis_(start.angle() == 0 ? Vector(Vector::Zero()) : start.axis()),
      turn_(turn),
      tolerance_(tolerance) {
  if (tolerance && !(*tolerance > 0 && *tolerance < 1)) {
    throw std::invalid_argument("crossing_tolerance must be positive and below 1 rad, got " +
                                text(*tolerance));
  }
}

// Its sign: that of d|M|/dt = M0 omega . M / (2 |M|), whichever way the motion goes.
double Crossings::rate_of_size(double t) const {
  const Quaternion q = propagator_(t, start_);
  const double sense = propagator_.frame == Frame::kSpace ? forward() : -forward();
  return sense * q.w() * propagator_.flow->generator(t).dot(q.vec());
}

// The error of M is half that of the rotation, and t is only known to an ulp.
Crossings::Scale Crossings::scale_of(double t, double error) const {
  const double of_t = kEpsilon * std::abs(t) * norm(propagator_.flow->generator(t));
  Scale scale{};
  scale.error = error + of_t;
  scale.lost = 2 * scale.error;
  scale.zero = tolerance_ ? *tolerance_ / 2 + of_t : scale.lost;
  scale.nonzero = 4 * std::max(scale.zero, scale.error);
  return scale;
}

double Crossings::tolerance() const { return tolerance_.value_or(4 * error_of_m()); }

double Crossings::error_of_m() const { return std::max(propagator_.error_estimate / 2, kEpsilon); }

// Shortly after the start the error is not yet that of the whole run. It is at most the integral of
// what the generator differs from omega by [theory 4.9].
double Crossings::error_of_m(double t) const {
  double defect = 0;
  const double sign = propagator_.frame == Frame::kSpace ? 1 : -1;
  for (const double part : {0.1, 0.4, 0.7, 0.95}) {
    const double place = propagator_.t0 + part * (t - propagator_.t0);
    defect =
        std::max(defect, norm(Vector(propagator_.flow->generator(place) - sign * omega_(place))));
  }
  return std::min(error_of_m(), defect * std::abs(t - propagator_.t0) + kEpsilon);
}

// The first place from t on towards another where |M| is at least `size`; that other one if there
// is none. Steps grow with the way, but M does not go far within one.
double Crossings::reach(double t, double towards, double size) const {
  const double sense = towards > t ? 1 : -1;
  const double finest =
      std::max(0x1p-60 * std::abs(propagator_.t1 - propagator_.t0), 4 * kEpsilon * std::abs(t));
  const double coarsest = std::abs(propagator_.t1 - propagator_.t0) / 1000;
  double fastest = 0;
  double far = finest;
  while (far < std::abs(towards - t)) {
    const double place = t + sense * far;
    if (norm(m(place)) >= size) return place;
    fastest = std::max(fastest, norm(propagator_.flow->generator(place)));
    const double longest = std::max(search_.spacing / kParts, std::min(coarsest, 0.1 / fastest));
    far += std::max(std::min(far / 8, longest), finest);
  }
  return towards;
}

// M = 0 is where U q0, or q0 U*, is plus or minus 1. What is looked for lies within the tolerance;
// the rest is for the error of the run and of the motion's own bound.
void Crossings::begin() {
  const Quaternion target = propagator_.frame == Frame::kSpace ? start_.conjugate() : start_;
  try {
    search_.spans =
        propagator_.flow->approaches(target, 1e-6 + 4 * std::max(tolerance(), 2 * error_of_m()));
  } catch (const std::length_error& error) {
    throw std::length_error(std::string(error.what()) +
                            "; without its crossings axis and angle are not known, the "
                            "quaternion and the matrix are");
  }
  search_.begun = true;
  search_.first_turn = turn_.turn;
  search_.settled = propagator_.t0;
  if (search_.spans.empty()) return;
  search_.spacing = std::abs(search_.spans[0].end - search_.spans[0].begin) / kParts;
  if (turn_.on_zero) start_on_zero();
}

void Crossings::look_until(double t, const Observer& observer) {
  struct Attempt {
    explicit Attempt(Crossings& of) : crossings(of) {}
    Attempt(const Attempt&) = delete;
    Attempt& operator=(const Attempt&) = delete;
    ~Attempt() {
      if (!done) crossings.search_ = {};
    }
    Crossings& crossings;
    bool done = false;
  } attempt(*this);
  if (!search_.begun) begin();
  // A run that was stopped keeps what was done: the observer has had its say.
  const bool watched = observer && !propagator_.stop;
  // A minimum is seen when |M| rises again.
  while (search_.next < search_.spans.size() && (!ahead(t, search_.spans[search_.next].begin) ||
                                                 search_.last.size < search_.before.size)) {
    const TimeSpan span = search_.spans[search_.next];
    if (watched && !observer(span.begin)) throw Interrupted();
    if (search_.next == 0 || ahead(search_.last.t, span.begin)) {
      search_.before = {};
      search_.last = {span.begin, norm(m(span.begin))};
    }
    search_.spacing = std::abs(span.end - span.begin) / kParts;
    for (int part = 1; part <= kParts; ++part) {
      push(part == kParts ? span.end : span.begin + (span.end - span.begin) * part / kParts);
    }
    if (++search_.next == search_.spans.size() ||
        ahead(search_.last.t, search_.spans[search_.next].begin))
      finish();
  }
  attempt.done = true;
}

// The next sample, with more before it where |M| is small.
void Crossings::push(double t) {
  const double size = norm(m(t));
  const auto add = [this](const Sample& sample) {
    if (sample.t == search_.last.t) return;
    const bool first = std::isinf(search_.before.size);
    if (search_.last.size < sample.size &&
        (first ? rate_of_size(search_.last.t) < 0 : search_.last.size <= search_.before.size)) {
      look_between(first ? search_.last.t : search_.before.t, sample.t);
    }
    search_.before = std::exchange(search_.last, sample);
  };
  if (std::min(size, search_.last.size) < kSmall) {
    const double a = search_.last.t;
    for (int part = 1; part < kParts; ++part) {
      const double place = a + (t - a) * part / kParts;
      add({place, norm(m(place))});
    }
  }
  add({t, size});
}

// A minimum in the last interval, where |M| does not rise again.
void Crossings::finish() {
  if (std::isinf(search_.before.size) || search_.last.size > search_.before.size) return;
  if (search_.last.size <= scale_of(search_.last.t, error_of_m()).nonzero ||
      rate_of_size(search_.last.t) > 0) {
    look_between(search_.before.t, search_.last.t);
  }
}

void Crossings::look_between(double ta, double tb) {
  const double t = least_between(ta, tb);
  if (ahead(t, search_.settled) || norm(m(t)) > scale_of(t, error_of_m()).nonzero) return;
  std::vector<double> minima = minima_about(t, 4 * std::abs(tb - ta));
  std::sort(minima.begin(), minima.end(), [this](double a, double b) { return ahead(a, b); });
  for (const double place : minima) {
    if (!ahead(place, search_.settled)) settle(place, norm(m(place)));
  }
}

double Crossings::least_between(double ta, double tb) const {
  const auto size = [this](double t) { return norm(m(t)); };
  double t = minimise(size, ta, tb);
  for (const double end : {ta, tb}) {
    if (size(end) < size(t)) t = end;
  }
  return t;
}

// Beside a zero there may be others that no sample tells, as near to it as its own error lets them
// be: looked for at distances that grow by a fifth.
std::vector<double> Crossings::minima_about(double t, double width) const {
  std::vector<double> minima{t};
  const auto [first, last_time] = std::minmax({propagator_.t0, propagator_.t1});
  const double finest = std::max(0x1p-50 * width, 4 * kEpsilon * std::abs(t));
  for (const double end : {std::max(first, t - width), std::min(last_time, t + width)}) {
    Sample before{t, norm(m(t))};
    Sample last = before;
    double far = finest;
    while (far < std::abs(end - t)) {
      const double place = t + (end > t ? far : -far);
      const Sample now{place, norm(m(place))};
      if (last.size < before.size && last.size <= now.size) {
        minima.push_back(least_between(before.t, now.t));
      }
      before = std::exchange(last, now);
      far *= 1.2;
    }
  }
  return minima;
}

// Where omega is smooth about t, as far as is known, and not farther than a part of the run: looked
// for ever farther, as there may be very many breaks.
std::pair<double, double> Crossings::around(double t) const {
  const auto [first, last] = std::minmax({propagator_.t0, propagator_.t1});
  const double farthest = (last - first) / 16;
  const double nearest = std::clamp(search_.spacing, 0x1p-40 * farthest, farthest);
  for (double far = nearest;; far = std::min(2 * far, farthest)) {
    double low = std::max(first, t - far);
    double high = std::min(last, t + far);
    std::vector<double> breaks = omega_.breaks(low, high);
    std::erase(breaks, t);
    if (breaks.empty() && far < farthest) continue;
    for (const double jump : breaks) {
      if (jump < t) low = jump;
      if (jump > t) high = std::min(high, jump);
    }
    return {low, high};
  }
}

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
  if (zero.end == propagator_.t1 && norm(m(zero.end)) <= scale.nonzero) return;
  search_.crossings.push_back(crossing);
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
  // On the way from there the axis does not turn so far that it could be its opposite.
  const auto borne_out = [&](double place, const Vector& foretold) {
    const Vector there = m(place);
    const double angle = norm(there.cross(foretold)) / norm(there);
    const double missed = std::sin(crossing.distance / 2) / norm(there);
    return norm(there) < scale.away ||
           angle <= kSame + 4 * series.error(place - order.t).axis + 1.5 * missed;
  };
  const bool holds = before.dot(after) > 0 && series.error(0).axis <= kSame &&
                     borne_out(zero.begin, before) && borne_out(zero.end, after) &&
                     passage(zero, before, after, scale.away) == expected &&
                     has_sizes(zero, series, order.t);
  if (holds || norm(m(zero.end)) < scale.away) {  // or the run ends there
    crossing.kind = expected;
    crossing.t = zero.t = order.t;
    zero.series = std::move(series);
  } else {
    crossing.note = "the motion does not bear out the derivatives of omega, which say order " +
                    std::to_string(order.order) + ": " + (odd ? "back" : "through");
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
  const Vector after = m(zero.end);
  if (norm(after) >= scale.away) {
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
  crossing.t_error = std::abs(end - begin) / 2;
  if (contradicted && !rests) return;
  crossing.order = std::nullopt;
  crossing.note =
      rests || crossing.axis.hasNaN()
          ? why_no_limit(omega)
          : "no derivative of omega is known to differ from zero there: how it goes on, "
            "and the axis, are by the motion alone";
  if (rests) crossing.axis = kNoAxis;
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
  } else if (zero.end == propagator_.t1) {
    search_.settled = zero.end;
    search_.note_of_start =
        "the body does not leave where it starts: its axis is that of the start";
    return;
  } else {
    search_.note_of_start = "at the start: " + why_no_limit(omega);
  }
  search_.zeros.push_back(zero);
  search_.settled = zero.end;
}

double Crossings::turn_at(double t) const {
  const auto next =
      std::partition_point(search_.crossings.begin(), search_.crossings.end(),
                           [&](const Crossing& crossing) { return ahead(crossing.t, t); });
  return next == search_.crossings.begin() ? search_.first_turn : std::prev(next)->turn_after;
}

const Zero* Crossings::zero_near(double t) const {
  if (search_.zeros.empty()) return nullptr;
  auto near = std::partition_point(search_.zeros.begin(), search_.zeros.end() - 1,
                                   [&](const Zero& zero) { return ahead(zero.t, t); });
  if (near != search_.zeros.begin() && std::abs(std::prev(near)->t - t) < std::abs(near->t - t))
    --near;
  return &*near;
}

const Zero* Crossings::zero_at(double t) const {
  const Zero* const zero = zero_near(t);
  if (zero == nullptr || ahead(t, zero->begin) || ahead(zero->end, t)) return nullptr;
  const double error = zero->begin == propagator_.t0 ? error_of_m(t) : error_of_m();
  return norm(m(t)) <= scale_of(t, error).lost ? zero : nullptr;
}

}  // namespace rotor
