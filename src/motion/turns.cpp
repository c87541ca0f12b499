#include "motion/turns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace rotor {
namespace {

constexpr Extended kTwoPi = 2 * std::numbers::pi_v<Extended>;

// The sine of half an angle other than zero. What is left of it at a multiple of 2 pi is the
// rounding of the angle; of a million turns and more it could be anything.
bool is_on_zero(double angle, double sine) {
  const double size = std::abs(angle);
  return size > 1 &&
         std::abs(sine) <= std::numeric_limits<double>::epsilon() / 2 * std::min(size, 1e6);
}

}  // namespace

double sign_of_turn(double turn) { return std::fmod(turn, 2) == 0 ? 1 : -1; }

// Counted from the nearer end of the interval, where it keeps its digits.
Extended angle_in_turn(double turn, Extended m0, Extended m) {
  const Extended c = sign_of_turn(turn) * m0;
  return c >= 0 ? kTwoPi * turn + 2 * std::atan2(m, c)
                : kTwoPi * (turn + 1) - 2 * std::atan2(m, -c);
}

Quaternion StartTurn::quaternion(const Rotation& start) const {
  return on_zero ? Quaternion(sign_of_turn(turn), 0, 0, 0) : start.quaternion();
}

StartTurn turn_of_start(const Rotation& start) {
  const Quaternion q = start.quaternion();
  const double sine = q.vec().dot(start.axis());
  if (start.angle() == 0 || is_on_zero(start.angle(), sine)) {
    const Extended k = std::nearbyint(start.angle() / kTwoPi);
    const Extended double_turns = std::floor(k / 2);
    return {double_turns, static_cast<double>(k - 2 * double_turns), true};
  }
  const double turn = sine < 0 ? -1 : 0;
  const Extended psi = angle_in_turn(turn, q.w(), std::abs(sine));
  return {std::nearbyint((start.angle() - psi) / (2 * kTwoPi)), turn, false};
}

}  // namespace rotor
