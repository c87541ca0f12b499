// Quotients of the kinematic equations that are 0/0 at theta = 0, each good to the last digits
// there.
//
// Error bounds are relative, in units of u = 2^-64 (half an ulp of 1 in extended precision), given
// sin, cos and tan within 2 ulp (4u). theta is any finite number.
#pragma once

#include "rotation/rotation.hpp"

namespace rotor {

/// sin(theta)/theta; even, 1 at 0. 5u.
Extended sinc(Extended theta);

/// (1 - cos theta)/theta^2; even, 1/2 at 0. As sinc(theta/2)^2/2: 11u.
Extended one_minus_cos(Extended theta);

/// (theta - sin theta)/theta^3; even, 1/6 at 0.
/// For |theta| <= 3/2 the sum of (-1)^k theta^2k/(2k+3)!: the twelve terms used leave 9e-24 out,
/// and Horner's scheme on this alternating series, whose terms fall from the first (theta^2/20 <
/// 1/8 is the largest ratio), errs by less than 3u. Beyond, theta - sin theta >= theta/3 cancels
/// little: 4u |sin theta|/(theta - sin theta) + 4u, at most 12u.
Extended angle_minus_sin(Extended theta);

/// g(theta) = (theta/2) cot(theta/2), the factor of [P7]; even, 1 at 0, infinite at 2 pi k (k !=
/// 0). h/tan(h) with h = theta/2 exact: 5u.
Extended half_cot(Extended theta);

/// (1 - g(theta))/theta^2, the second factor of [P7]; even, 1/12 at 0.
/// With h = theta/2 it is (V(h) - T(h))/(4 sinc(h)), V = one_minus_cos, T = angle_minus_sin. For
/// |h| <= 3/2, V - T >= 0.26 is the difference of V <= 1/2 (11u) and T <= 1/6 (3u): 19u, with the
/// quotient 26u. Beyond, 1 - g >= 0.89 is free of cancellation: 5u |g|/(1 - g) + 3u, which is at
/// most 8u up to the pole and past it grows only where 1 - g passes through zero (|theta| = 8.99,
/// ...), absolute error 8u/theta^2 there.
Extended one_minus_half_cot(Extended theta);

}  // namespace rotor
