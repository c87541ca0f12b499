// Where a function of the motion is zero: Poincare sections.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "motion/run.hpp"

namespace rotor {

enum class Direction { kBoth, kUp, kDown };

/// The times at which f(t) comes through zero, in the order of the motion, upward or downward in
/// that order: each to the rounding of t and of f. f is looked at `n` times from t0 to t1, evenly,
/// or else so often that the body turns by less than 0.8 rad in between, and where it comes near to
/// zero and goes back. A zero that f touches only, or starts or ends on, is not seen, nor are two
/// that three looks give no sign of. Where f
/// jumps over zero there is none, and where it is NaN. Throws std::invalid_argument for n < 2, and
/// where f is NaN wherever it is looked at; std::length_error where the motion is too long to be
/// looked through. With `below` it is of f/below, which may have poles where f is regular: what is
/// within rounding of a zero of both is none.
std::vector<double> section(const Run& run, const std::function<double(double)>& f,
                            Direction direction, std::optional<std::size_t> n = std::nullopt,
                            const Observer& observer = {},
                            const std::function<double(double)>& below = nullptr);

}  // namespace rotor
