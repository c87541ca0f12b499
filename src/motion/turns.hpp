// Counting turns: theta in the intervals 2 pi l <= theta <= 2 pi (l + 1).
#pragma once

#include "rotation/rotation.hpp"

namespace rotor {

/// (-1)^l: the sign of sin(theta/2) in the interval l.
double sign_of_turn(double turn);

/// The angle in the interval of `turn`, from cos(theta/2) = m0 and |sin(theta/2)| = m [theory 3].
Extended angle_in_turn(double turn, Extended m0, Extended m);

/// Where counting begins: theta = 4 pi double_turns + psi, and psi is in the interval `turn`.
struct StartTurn {
  Extended double_turns;
  double turn;
  /// theta is a multiple of 2 pi to the rounding of it (then psi = 2 pi turn): M is zero.
  bool on_zero;

  /// Of `start`: exactly 1 or -1 where M is zero, else the residue would turn up as a motion.
  Quaternion quaternion(const Rotation& start) const;
};
StartTurn turn_of_start(const Rotation& start);

}  // namespace rotor
