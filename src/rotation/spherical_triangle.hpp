// Rodrigues' construction: the product of two rotations from a triangle on the unit sphere [N 9].
//
// Let l be the great circle through p and q, the axes of the first and the second rotation. Turn l
// about p by -theta/2, and turn l about q by +phi/2: the two circles meet at the axis r of the
// product, and half the product's angle is between them. (Each rotation is a pair of reflections in
// great circles through its axis, half its angle apart; the reflection in l is common to both and
// cancels.) The notes print the construction with the whole angles, which is another point.
#pragma once

#include "rotation/rotation.hpp"

namespace rotor {

/// The rotation `first` = (p, theta) followed by `second` = (q, phi), and their product.
struct SphericalTriangle {
  enum class Kind {
    kTriangle,
    kParallel,  // q = p, to rounding: the product is about p by theta + phi
    kOpposite,  // q = -p, to rounding: the product is about p by theta - phi
    kIdentity,  // both angles are 0: both circles are l, and nothing tells r
  };

  Rotation first;
  Rotation second;
  Rotation product;  // about r, by gamma in [0, 2 pi]; the axis of an exact identity is e1
  Kind kind;
  // The sides, each the shorter way, in [0, pi]; of a triangle only.
  double pq;
  double qr;
  double rp;
};

/// The triangle of `second` after `first`, solved from its side pq and the angles theta/2 and phi/2
/// there. The product is that of second * first, counted modulo 4 pi.
SphericalTriangle spherical_triangle(const Rotation& first, const Rotation& second);

}  // namespace rotor
