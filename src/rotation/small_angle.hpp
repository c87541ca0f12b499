// Quotients of the kinematic equations that are 0/0 at theta = 0, each good to the last digits
// there.
//
// Error bounds are relative, in units of u = 2^-53 (half an ulp of 1).
#pragma once

namespace rotor {

/// g(theta) = (theta/2) cot(theta/2), the factor of [P7]; even, 1 at 0, infinite at 2 pi k (k !=
/// 0). h/tan(h) with h = theta/2 exact: u for the division and 2u for std::tan (1 ulp): 3u.
double half_cot(double theta);

/// (1 - g(theta))/theta^2, the second factor of [P7]; even, 1/12 at 0.
/// With h = theta/2 it is S(h) / (4 sin(h)/h), S(h) = (sin h - h cos h)/h^3 = sum of
/// (-1)^k (2k+2)/(2k+3)! h^2k. For |h| <= 3/2 the eleven terms used leave 3e-18 out; Horner's
/// scheme on this alternating series, whose terms fall from the first (h^2/10 < 1/4 is the largest
/// ratio), errs by less than 3u, sin(h)/h by 3u, the product and quotient by 2u: 8u in all. Beyond,
/// 1 - g >= 0.89 is free of cancellation: 3u |g|/(1 - g) + 3u, which is at most 7u up to the pole
/// and past it grows only where 1 - g passes through zero (|theta| = 8.99, ...), absolute error
/// 6u/theta^2 there.
double one_minus_half_cot(double theta);

}  // namespace rotor
