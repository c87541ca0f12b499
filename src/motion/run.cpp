#include "motion/run.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "rotation/kinematics.hpp"
#include "rotation/small_angle.hpp"
#include "rotation/text.hpp"
#include "spin/models.hpp"

namespace rotor {
namespace {

constexpr Extended kTwoPi = 2 * std::numbers::pi_v<Extended>;
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

double sign_of_turn(double turn) { return std::fmod(turn, 2) == 0 ? 1 : -1; }

// The angle in the interval of `turn`, from cos(theta/2) = m0 and |sin(theta/2)| = m [theory 3],
// counted from the nearer end of the interval, where it keeps its digits.
Extended angle_in_turn(double turn, Extended m0, Extended m) {
  const Extended c = sign_of_turn(turn) * m0;
  return c >= 0 ? kTwoPi * turn + 2 * std::atan2(m, c)
                : kTwoPi * (turn + 1) - 2 * std::atan2(m, -c);
}

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

Run::Run(AngularVelocity omega, Propagator propagator, const Rotation& from,
         std::vector<Vector> points)
    : omega_(std::move(omega)),
      propagator_(std::move(propagator)),
      from_(from),
      points_(std::move(points)),
      start_(from.quaternion()),
      axis_(from.axis()) {
  const double along_axis = start_.vec().dot(axis_);  // sin(theta/2)
  first_turn_ = along_axis < 0 ? -1 : 0;
  const Extended psi = angle_in_turn(first_turn_, start_.w(), std::abs(along_axis));
  double_turns_ = std::nearbyint((from.angle() - psi) / (2 * kTwoPi));

  const FixedAxisFlow* flow = propagator_.fixed_axis();
  if (flow == nullptr) return;
  const Vector direction = sense() * flow->direction();
  if (const auto* constant = omega_.as<ConstantSpin>(); constant && constant->value(0).isZero(0)) {
    fixed_axis_ = 1;
  } else if (from_.angle() == 0) {
    // From the identity the body turns about omega, whatever axis it was given.
    fixed_axis_ = forward() * flow->rate(t0()) < 0 ? -1 : 1;
    axis_ = (fixed_axis_ * direction).array() + 0.0;  // no -0
  } else if (axis_.cross(direction).norm() <= 2 * kEpsilon) {
    fixed_axis_ = axis_.dot(direction) > 0 ? 1 : -1;
  }
}

Extended Run::fixed_axis_angle(double t) const {
  return from_.angle() + fixed_axis_ * propagator_.fixed_axis()->angle(t);
}

Quaternion Run::quaternion(double t) const {
  const auto [low, high] = std::minmax({t0(), t1()});
  if (!(t >= low && t <= high)) {
    throw std::out_of_range("t = " + text(t) + " is outside the run, " + text(t0()) + " .. " +
                            text(t1()));
  }
  return propagator_(t, start_);
}

State Run::attitude(double t) const {
  State state;
  state.t = t;
  state.quaternion = quaternion(t);
  return state;
}

Vector Run::omega(double t) const {
  const Vector omega = omega_(t);
  return omega_.frame() == Frame::kSpace ? omega : quaternion(t) * omega;
}

Vector Run::body_omega(double t) const {
  const Vector omega = omega_(t);
  return omega_.frame() == Frame::kBody ? omega : quaternion(t).conjugate() * omega;
}

std::vector<Vector> Run::points(double t) const {
  const Quaternion turn = quaternion(t) * start_.conjugate();
  std::vector<Vector> places;
  places.reserve(points_.size());
  for (const Vector& point : points_) places.push_back(turn * point);
  return places;
}

State Run::operator()(double t, const Observer& observer) const {
  State state = attitude(t);
  if (fixed_axis_ != 0) {
    state.axis = axis_;
    state.angle = static_cast<double>(fixed_axis_angle(t));
    return state;
  }
  if (t == t0() && from_.angle() != 0) {
    state.axis = from_.axis();
    state.angle = from_.angle();
    return state;
  }
  const std::vector<Crossing>& crossings = found(observer);
  const auto next = std::partition_point(
      crossings.begin(), crossings.end(),
      [&](const Crossing& crossing) { return (t - crossing.t) * forward() > 0; });
  const double turn = next == crossings.begin() ? first_turn_ : std::prev(next)->turn_after;
  state.axis = axis_at(t, state.quaternion, turn, crossings);
  state.angle = static_cast<double>(
      double_turns_ * 2 * kTwoPi +
      angle_in_turn(turn, state.quaternion.w(), Extended{norm(state.quaternion.vec())}));
  return state;
}

Vector Run::axis_at(double t, const Quaternion& q, double turn,
                    const std::vector<Crossing>& crossings) const {
  const Vector m = q.vec();
  const double size = norm(m);
  if (size <= propagator_.error_estimate && !crossings.empty()) {
    // Beside a zero of M its direction is lost in the error; the limit there is known.
    const auto nearest =
        std::min_element(crossings.begin(), crossings.end(),
                         [t](auto& a, auto& b) { return std::abs(a.t - t) < std::abs(b.t - t); });
    // The start may be such a zero too: its M is as good as its distance in time.
    if (std::abs(nearest->t - t) <= std::abs(t0() - t)) return nearest->axis;
  }
  if (size != 0) return (unit(m) * sign_of_turn(turn)).array() + 0.0;  // no -0
  // At the identity n goes on along omega; where that says nothing, the axis given stays.
  const Vector direction = forward() * direction_of_omega(t);
  return direction.isZero(0) ? axis_ : direction;
}

// Zero where omega is zero or cannot be had: asking for a state must not fail on it.
Vector Run::direction_of_omega(double t) const {
  try {
    const Vector at_t = omega(t);
    return at_t.isZero(0) ? at_t : unit(at_t);
  } catch (const std::exception&) {
    return Vector::Zero();
  }
}

// The limit of n at a zero of M, from n beside it and omega there: where omega is not zero (i = 0),
// it is along omega [Lemma 5.3].
Vector Run::limit_of_axis(double t, const Vector& before, const Vector& after,
                          double turn_after) const {
  const Vector between = before + after;
  const Vector along = (forward() * sign_of_turn(turn_after) * (quaternion(t).w() > 0 ? 1 : -1)) *
                       direction_of_omega(t);
  if (along.dot(between) > 0.9 * between.norm() || between.isZero(0)) return along;
  return unit(between);
}

Vector State::mrp() const {
  const double w = quaternion.w();
  const Vector m = quaternion.vec();
  return w > -0.5 ? Vector(m / (1 + w)) : Vector(m * ((1 - w) / m.squaredNorm()));
}

Rates Run::rates(const State& state, const Vector& omega) const {
  const Vector& n = state.axis;
  const double along = omega.dot(n);
  const double sine = state.quaternion.vec().dot(n);
  Rates rates{along, Vector::Zero(), Vector::Zero()};
  if (fixed_axis_ == 0) {
    rates.axis_rate = sine == 0 ? Vector::Constant(std::numeric_limits<double>::quiet_NaN())
                                : axis_rate(n, Extended{state.quaternion.w()} / sine, omega);
  }
  const Vector e = state.euler_vector();
  if (std::abs(state.angle) < 3) {
    // [P7] with its first two terms gathered: omega g + E (omega . E)(1 - g)/theta^2 + omega x E/2.
    const auto g = static_cast<double>(half_cot(state.angle));
    const auto second = static_cast<double>(one_minus_half_cot(state.angle));
    rates.euler_rate = omega * g + e * (omega.dot(e) * second) + omega.cross(e) / 2;
  } else {
    rates.euler_rate = n * along + rates.axis_rate * state.angle;
  }
  return rates;
}

std::vector<Crossing> Run::crossings(const Observer& observer) const {
  const auto* fixed = dynamic_cast<const UniformTurn*>(propagator_.fixed_axis());
  if (fixed_axis_ == 0 || fixed == nullptr) {
    std::vector<Crossing> result = found(observer);
    const auto turns = static_cast<double>(2 * double_turns_);
    for (Crossing& crossing : result) {
      crossing.turn_before += turns;
      crossing.turn_after += turns;
    }
    return result;
  }
  std::vector<Crossing> result;
  if (fixed->rate() == 0) return result;

  // theta passes through every multiple of 2 pi between its ends.
  const Extended begin = fixed_axis_angle(t0()) / kTwoPi;
  const Extended end = fixed_axis_angle(t1()) / kTwoPi;
  if (std::abs(end - begin) > 1e6L) {
    throw std::length_error("crossings: about " +
                            text(static_cast<double>(std::abs(end - begin)), 3) +
                            " of them, more than a million: too many to list");
  }
  const double up = end > begin ? 1 : -1;
  for (Extended k = up > 0 ? std::floor(begin) + 1 : std::ceil(begin) - 1; (end - k) * up > 0;
       k += up) {
    const auto turn = static_cast<double>(k);
    const double t =
        static_cast<double>(t0() + (kTwoPi * k - from_.angle()) / (fixed_axis_ * fixed->rate()));
    result.push_back({t, true, up > 0 ? turn - 1 : turn, up > 0 ? turn : turn - 1, axis_});
  }
  return result;
}

// Between its ends t[0] and t[2], |M| is least at t[1]: is it zero there, to the accuracy of the
// run?
bool Run::is_zero_of_m(const double (&t)[3], const double (&m)[3]) const {
  // The error of M is half that of the rotation, twice over for an estimate that is a little too
  // small; and t is only known to an ulp, in which |M| changes at its rate.
  const double rate = (m[0] + m[2]) / std::abs(t[2] - t[0]);
  return m[1] <= propagator_.error_estimate + 2 * kEpsilon * std::abs(t[1]) * rate;
}

const std::vector<Crossing>& Run::found(const Observer& observer) const {
  if (!found_) found_ = may_cross() ? find_crossings(observer) : std::vector<Crossing>();
  return *found_;
}

// M = 0 is where U q0, or q0 U*, is plus or minus 1. What is_zero_of_m takes for zero lies within
// the distance, which allows for the error of the run and of the motion's own bound.
bool Run::may_cross() const {
  const Quaternion target = propagator_.frame == Frame::kSpace ? start_.conjugate() : start_;
  return propagator_.flow->can_reach(target, 1e-6 + 2 * propagator_.error_estimate);
}

std::vector<Crossing> Run::find_crossings(const Observer& observer) const {
  std::vector<Crossing> found;
  std::vector<double> mesh;
  try {
    mesh = propagator_.flow->mesh();
  } catch (const std::length_error& error) {
    throw std::length_error(std::string(error.what()) +
                            " for crossings, without which axis and angle are not known; the "
                            "quaternion and the matrix are");
  }
  const auto m = [this](double t) -> Vector { return quaternion(t).vec(); };
  // Sample times: the mesh, eight times finer, so that less than a radian lies between two.
  std::vector<std::pair<double, double>> samples;  // t, |M|
  samples.reserve(8 * mesh.size());
  samples.emplace_back(mesh.front(), m(mesh.front()).norm());
  // A run that was stopped keeps what was done: the observer has had its say.
  const bool watched = observer && !propagator_.stop;
  for (std::size_t i = 1; i < mesh.size(); ++i) {
    if (watched && !observer(mesh[i])) throw Interrupted();
    for (int part = 1; part <= 8; ++part) {
      const double t = part == 8 ? mesh[i] : mesh[i - 1] + (mesh[i] - mesh[i - 1]) * (part / 8.0);
      if (t != samples.back().first) samples.emplace_back(t, m(t).norm());
    }
  }

  double turn = first_turn_;
  const auto look_between = [&](double ta, double tb) {
    const Vector a = m(ta);
    const Vector b = m(tb);
    const double t = minimise([&](double s) { return m(s).norm(); }, ta, tb);
    if (!is_zero_of_m({ta, t, tb}, {a.norm(), m(t).norm(), b.norm()})) return;
    // A body at rest there passes through nothing; the ends of a run may well lie that near.
    const bool inside = ta != samples.front().first && tb != samples.back().first;
    if (inside && std::min(a.norm(), b.norm()) <= propagator_.error_estimate) return;
    // M itself tells the case [theory 3]: it went through the origin, or turned back.
    const bool through = a.dot(b) < 0;
    const double step = !through ? 0 : sign_of_turn(turn) * quaternion(t).w() < 0 ? 1 : -1;
    const Vector axis = limit_of_axis(t, sign_of_turn(turn) * a.normalized(),
                                      sign_of_turn(turn + step) * b.normalized(), turn + step);
    found.push_back({t, through, turn, turn + step, axis});
    turn += step;
  };
  const std::size_t last = samples.size() - 1;
  for (std::size_t i = 0; i <= last && last > 0; ++i) {
    if (watched && !observer(samples[i].first)) throw Interrupted();
    const auto [t, size] = samples[i];
    if (i > 0 && i < last) {
      if (size <= samples[i - 1].second && size < samples[i + 1].second) {
        look_between(samples[i - 1].first, samples[i + 1].first);
      }
    } else {
      // A zero beside an end of the run: |M| is least at the end sample itself, and M has turned
      // round.
      const auto& [t_beside, size_beside] = samples[i == 0 ? 1 : last - 1];
      if (size <= size_beside && m(t).dot(m(t_beside)) < 0) {
        i == 0 ? look_between(t, t_beside) : look_between(t_beside, t);
      }
    }
  }
  return found;
}

void visit_times(std::span<const double> times, const Observer& observer,
                 const std::function<void(double)>& visit) {
  for (const double t : times) {
    if (observer && !observer(t)) throw Interrupted();
    visit(t);
  }
}

Run evolve(const Scene& scene, const Rotation& from, const Observer& observer,
           std::vector<Vector> points) {
  return {scene.omega, propagate(scene, observer, from), from, std::move(points)};
}

}  // namespace rotor
