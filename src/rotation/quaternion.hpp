// General quaternions [N24-N26]: scalar first, of any norm. A quaternion a (cos theta/2, u sin
// theta/2) is a rotation with scaling; theta counts modulo 4 pi, for theta + 2 pi gives -q.
//
// Errors are lengths of difference quaternions, relative to the length of the true one; where a
// result is not finite, every function says so by std::invalid_argument.
#pragma once

#include <vector>

#include "rotation/rotation.hpp"

namespace rotor {

/// |q| of any finite quaternion, as of a vector.
double norm(const Quaternion& q);
/// q/|q|. Throws std::invalid_argument for the zero quaternion and for one that is not finite.
Quaternion unit(const Quaternion& q);

/// p q [N24], to half an ulp of |p||q|. Infinite where the true product overflows.
Quaternion product(const Quaternion& p, const Quaternion& q);

/// The quaternion whose product with q, from either side, is 1. Throws for zero.
Quaternion inverse(const Quaternion& q);

/// Polar form of a general quaternion: norm (cos theta/2, u sin theta/2), theta in [0, 2 pi].
struct Polar {
  double norm;
  Rotation rotation;
};
/// Throws std::invalid_argument for the zero quaternion, which has no polar form.
Polar polar(const Quaternion& q);
/// norm (cos theta/2, u sin theta/2) for any angle theta of the rotation. Throws unless the norm is
/// finite and not negative.
Quaternion from_polar(double norm, const Rotation& rotation);

/// e^q = e^w (cos|v|, v/|v| sin|v|), to 2e-16 + 1e-19 |v|.
Quaternion exp(const Quaternion& q);
/// The logarithm (ln|q|, u theta/2) with theta/2 in [0, pi], to 2e-16, near q = 1 too. Of a
/// negative number any axis would do: u = e1. Throws for zero.
Quaternion log(const Quaternion& q);
/// q^x: for a whole x the repeated product (of the inverse if x < 0; q^0 = 1, 0^0 too), else e^(x
/// log q), to 2e-16 + 2e-19 |x| (1 + |ln|q||). 0^x is 0 for x > 0. Throws for 0^x with x < 0.
Quaternion power(const Quaternion& q, double x);

/// The same quaternions with signs such that neighbours have a dot product of at least 0: as
/// rotations the same operators, without jumps by a full turn. The first one stays as it is. Throws
/// std::invalid_argument for one that is not finite.
std::vector<Quaternion> continuous_quaternions(std::vector<Quaternion> quaternions);

}  // namespace rotor
