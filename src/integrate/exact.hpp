// The models of omega that have a closed form, or a cheaper way to be followed than by steps.
#pragma once

#include <vector>

#include "integrate/propagator.hpp"
#include "spin/models.hpp"

namespace rotor {

/// Each follows scene.omega, whose model is `omega`, over the scene's interval, forward or backward
/// in t, in the frame of scene.omega, and fills in result.flow, .t1, .stop, .error_estimate, .cost
/// and, where one was used, .accuracy. Errors of the request are std::invalid_argument.

/// omega(t) = R(t) v with R(t) = exp(k rate t): U(t) = R(t) exp((v - rate k)(t - t0)) R(t0)*
/// [theory 4.4]. Throws where an angle overflows.
void follow_turning(const Scene& scene, const TurningSpin& omega, Propagator& result);

/// A fixed direction: U(t) = exp(direction S(t)), S the integral of the rate [Lemma 4.2]. `breaks`
/// rise, strictly between t0 and t1.
void follow_along(const Scene& scene, const AlongSpin& omega, const std::vector<double>& breaks,
                  const Observer& observer, Propagator& result);

/// A period by its own cheapest method, then U(t + kT) = U(t) U(T)^k (Floquet, theory 4.3); less
/// than a period where no more is asked. `breaks`, of the scene only, in any order, count in every
/// period. Says in result.method and .why how the period was followed.
void follow_periodic(const Scene& scene, const PeriodicSpin& omega,
                     const std::vector<double>& breaks, const Observer& observer,
                     Propagator& result);

/// Every piece by its own cheapest method, one after the other: U = Un ... U1. `breaks` in any
/// order; those of omega need not be among them. Says in result.method and .why how.
void follow_piecewise(const Scene& scene, const PiecewiseSpin& omega,
                      const std::vector<double>& breaks, const Observer& observer,
                      Propagator& result);

}  // namespace rotor
