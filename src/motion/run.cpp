#include "motion/run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "rotation/small_angle.hpp"
#include "rotation/text.hpp"

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

Run::Run(AngularVelocity omega, Propagator propagator, const Rotation& from)
    : omega_(std::move(omega)),
      propagator_(std::move(propagator)),
      from_(from),
      start_(from.quaternion()),
      axis_(from.axis()) {
  const double along_axis = start_.vec().dot(axis_);  // sin(theta/2)
  first_turn_ = along_axis < 0 ? -1 : 0;
  const Extended psi = angle_in_turn(first_turn_, start_.w(), std::abs(along_axis));
  double_turns_ = std::nearbyint((from.angle() - psi) / (2 * kTwoPi));

  if (const FixedTurn* turn = propagator_.fixed_turn()) {
    if (start_.vec().isZero(0) && turn->rate != 0 && from_.angle() == 0) {
      // From the identity the body turns about omega, whatever axis the start was given, unless
      // that axis is its opposite.
      if (axis_.dot(turn->direction) > -1 + kEpsilon) axis_ = turn->direction;
    }
    if (turn->rate == 0) {
      fixed_axis_ = 1;
    } else if (axis_.cross(turn->direction).norm() <= 2 * kEpsilon) {
      fixed_axis_ = axis_.dot(turn->direction) > 0 ? 1 : -1;
    }
  } else {
    find_crossings();
  }
}

Extended Run::fixed_axis_angle(double t) const {
  return from_.angle() + fixed_axis_ * propagator_.fixed_turn()->angle(t);
}

State Run::operator()(double t) const {
  const auto [low, high] = std::minmax({t0(), t1()});
  if (!(t >= low && t <= high)) {
    throw std::out_of_range("run: t = " + text(t) + " is outside the run, " + text(t0()) + " .. " +
                            text(t1()));
  }
  State state;
  state.t = t;
  state.quaternion = quaternion(t);
  if (fixed_axis_ != 0) {
    state.axis = axis_;
    state.angle = static_cast<double>(fixed_axis_angle(t));
    return state;
  }
  double turn = first_turn_;
  const double forward = t1() >= t0() ? 1 : -1;
  for (const Crossing& crossing : crossings_) {
    if ((t - crossing.t) * forward <= 0) break;
    turn = crossing.turn_after;
  }
  const Vector m = state.quaternion.vec();
  const double size = norm(m);
  if (size != 0) {
    state.axis = (unit(m) * sign_of_turn(turn)).array() + 0.0;  // no -0
  } else {
    // n is the limit of M/|M| on the way from here [Lemma 5.3, i = 0].
    const Vector rate = omega_(t) * (forward * state.quaternion.w() * sign_of_turn(turn));
    state.axis = rate.isZero(0) ? axis_ : unit(rate);
  }
  if (t == t0()) {
    state.angle = from_.angle();
    if (size != 0) state.axis = from_.axis();
  } else {
    state.angle = static_cast<double>(double_turns_ * 2 * kTwoPi +
                                      angle_in_turn(turn, state.quaternion.w(), size));
  }
  return state;
}

Rates Run::rates(const State& state, const Vector& omega) const {
  const Vector& n = state.axis;
  const double along = omega.dot(n);
  const double sine = state.quaternion.vec().dot(n);
  Rates rates{along, Vector::Zero(), Vector::Zero()};
  if (fixed_axis_ == 0) {
    rates.axis_rate =
        sine == 0
            ? Vector::Constant(std::numeric_limits<double>::quiet_NaN())
            : Vector((omega - n * along) * (state.quaternion.w() / sine / 2) + omega.cross(n) / 2);
  }
  const Vector e = state.euler_vector();
  if (std::abs(state.angle) < 3) {
    // [P7] with its first two terms gathered: omega g + E (omega . E)(1 - g)/theta^2 + omega x E/2.
    rates.euler_rate = omega * half_cot(state.angle) +
                       e * (omega.dot(e) * one_minus_half_cot(state.angle)) + omega.cross(e) / 2;
  } else {
    rates.euler_rate = n * along + rates.axis_rate * state.angle;
  }
  return rates;
}

std::vector<Crossing> Run::crossings() const {
  std::vector<Crossing> result = crossings_;
  const auto turns = static_cast<double>(2 * double_turns_);
  for (Crossing& crossing : result) {
    crossing.turn_before += turns;
    crossing.turn_after += turns;
  }
  const FixedTurn* fixed = propagator_.fixed_turn();
  if (fixed_axis_ == 0 || fixed == nullptr || fixed->rate == 0) return result;

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
        static_cast<double>(t0() + (kTwoPi * k - from_.angle()) / (fixed_axis_ * fixed->rate));
    result.push_back({t, true, up > 0 ? turn - 1 : turn, up > 0 ? turn : turn - 1});
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

void Run::find_crossings() {
  const std::vector<double> mesh = propagator_.mesh();
  const auto m = [this](double t) -> Vector { return quaternion(t).vec(); };
  // Sample times: the mesh, eight times finer where |M| could vanish. Within a step the quaternion
  // goes about as far as the chord of its ends; twice that allows for the curve.
  std::vector<std::pair<double, double>> samples;  // t, |M|
  Quaternion before = quaternion(mesh.front());
  samples.emplace_back(mesh.front(), before.vec().norm());
  for (std::size_t i = 1; i < mesh.size(); ++i) {
    const Quaternion after = quaternion(mesh[i]);
    const double least = std::min(before.vec().norm(), after.vec().norm());
    if (least <= 2 * (after.coeffs() - before.coeffs()).norm()) {
      for (int part = 1; part < 8; ++part) {
        const double t = mesh[i - 1] + (mesh[i] - mesh[i - 1]) * part / 8;
        samples.emplace_back(t, m(t).norm());
      }
    }
    samples.emplace_back(mesh[i], after.vec().norm());
    before = after;
  }

  double turn = first_turn_;
  for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
    const auto [ta, ma] = samples[i - 1];
    const auto [tb, mb] = samples[i + 1];
    if (samples[i].second > ma || samples[i].second >= mb) continue;
    const double t = minimise([&](double s) { return m(s).norm(); }, ta, tb);
    if (!is_zero_of_m({ta, t, tb}, {ma, m(t).norm(), mb})) continue;
    // M itself tells the case [theory 3]: it went through the origin, or turned back.
    const bool through = m(ta).dot(m(tb)) < 0;
    const double step = !through ? 0 : sign_of_turn(turn) * quaternion(t).w() < 0 ? 1 : -1;
    crossings_.push_back({t, through, turn, turn + step});
    turn += step;
  }
}

Run evolve(const Scene& scene, const Rotation& from, const Observer& observer) {
  return {scene.omega, propagate(scene, observer), from};
}

}  // namespace rotor
