#include "motion/crossings.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "rotation/text.hpp"

namespace rotor {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr int kParts = 8;  // samples in an interval of the mesh

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

}  // namespace

Crossings::Crossings(AngularVelocity omega, Propagator propagator, const Rotation& start,
                     const StartTurn& turn, std::optional<double> tolerance)
    : omega_(std::move(omega)),
      propagator_(std::move(propagator)),
      start_(turn.quaternion(start)),
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
                                                 search_.last.size <= search_.before.size)) {
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
  // Beside a near miss that is no farther than M goes between two samples there may be a zero.
  const double hidden = std::abs(tb - ta) * norm(propagator_.flow->generator(t));
  const double nonzero = scale_of(t, error_of_m()).nonzero;
  if (ahead(t, search_.settled) || norm(m(t)) > std::max(nonzero, hidden)) return;
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
