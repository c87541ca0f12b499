// Whether derivatives that were found by following a function's arithmetic are those of the
// function.
#pragma once

#include <functional>
#include <span>

#include "rotation/rotation.hpp"
#include "spin/jet.hpp"

namespace rotor {

/// Holds jets (three, or one for a function whose values are along e1) about t against a function's
/// values: at t itself, where they must agree to 4 ulp of the vector's size; and near t on both
/// sides, which its Taylor series must foretell. That sees jumps of the function and of its first
/// two derivatives at t, and a function that is not the same to jets as to numbers. A side where
/// the value is not finite is left out, unless both are. Throws NotDifferentiable that says what
/// differs.
void check_jet(std::span<const Jet> jets, double t, const std::function<Vector(double)>& value);

}  // namespace rotor
