// The fast integrator of attitude: Fer's factors on Gauss and Legendre's nodes.
#pragma once

#include <vector>

#include "integrate/propagator.hpp"

namespace rotor {

/// Follows the scene, whose breaks (with those of omega) rise, to its accuracy: fills result.flow,
/// .t1, .stop, .error_estimate, .accuracy and .cost. Where rounding forbids that accuracy, the
/// estimate says what was reached.
///
/// V' = w x V (z from -1 to 1, w half the step times the generator) is solved by V = exp(F_1)
/// exp(F_2) ... with F_k the integral of w_k from 0, w_1 = w and, x = |F_k|^2 = th^2,
///   w_(k+1) = f1(x) F_k x w_k + f2(x) F_k x (F_k x w_k),
///   f1 = (1 - cos th)/th^2 - sin th/th, f2 = (1 - cos th)/th^2 - (th - sin th)/th^3,
/// sizes falling quadratically. U = V(1) V(-1)* is unit by construction. With 16 nodes its order is
/// 32: at the end of a step the terms of degree 16 ... 31 of w drop out.
///
/// Where omega is cheap it is called 16 times a step; where it is dear it is sampled on panels of
/// 64 nodes, as long as it is smooth, and the steps live on their series.
void follow_by_fgl(const Scene& scene, const std::vector<double>& breaks, const Observer& observer,
                   Propagator& result);

}  // namespace rotor
