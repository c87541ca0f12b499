// A rotation as a sequence of two or three about given axes [notes 7.1], Euler angles among them.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "rotation/chain.hpp"

namespace rotor {

/// All the ways to make an operator as a sequence, angles in (-pi, pi].
struct Factoring {
  /// Each item is a solution: one angle for each axis, in their order.
  std::vector<std::vector<double>> solutions;
  /// Empty where the solutions are isolated. At a singularity there are infinitely many; one of
  /// them is given, and this says which: "only a + c is determined, c = 0 is taken".
  std::string singular;
};

/// All (a, b) with R = Q(u1, a) Q(u2, b), as operators; axes of any length but zero. There is one
/// if u1.R u2 = u1.u2 (to rounding: the angles between them within 1.5e-15), else
/// std::invalid_argument is thrown with both numbers. Parallel axes are singular: b = 0.
Factoring angles_about(const Rotation& r, const Vector& u1, const Vector& u2);

/// All (a, b, c) with R = Q(u1, a) Q(u2, b) Q(u3, c), as operators; axes of any length but zero.
/// With alpha = angle(u1, u2) and beta = angle(u2, u3) the angle from u1 to R u3 is between |alpha
/// - beta| and min(alpha + beta, 2 pi - alpha - beta); throws std::invalid_argument with both if it
/// is outside by more than 1.5e-15, the rounding of a Rotation. Two solutions, one on the borders;
/// the one with the smaller |b| first, of -b and b the positive. Singular where R u3 is parallel to
/// u1 (c = 0), and where u2 is parallel to u1 or u3 (b = 0). Near a singularity a and c are known
/// only together, and always make R to 4e-15 rad.
Factoring angles_about(const Rotation& r, const Vector& u1, const Vector& u2, const Vector& u3);

/// R = Q(first letter, a) Q(second, b) Q(third, c) for one of the twelve sequences of the letters
/// x, y, z without a repetition of neighbours ("zyx", "zxz", ...) about axes fixed in the body;
/// fixed in space the factors are in the opposite order. Angle in [0, 2 pi]. Throws
/// std::invalid_argument for any other sequence, and for angles that are not finite.
Rotation from_euler_angles(const std::string& sequence, const std::array<double, 3>& angles,
                           Frame frame = Frame::kBody);

/// The Euler angles of an operator, two solutions as from angles_about: in the first b is in [0,
/// pi] where the first and last letter agree, in [-pi/2, pi/2] where they differ. At the ends of
/// these intervals it is singular ("gimbal lock"): c = 0. Throws as from_euler_angles.
Factoring euler_angles(const Rotation& r, const std::string& sequence, Frame frame = Frame::kBody);

}  // namespace rotor
