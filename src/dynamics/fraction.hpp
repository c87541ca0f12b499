// Which fraction a measured number is: what makes a motion periodic, or two frequencies
// commensurate.
#pragma once

#include <cstddef>
#include <optional>

namespace rotor {

struct Fraction {
  long numerator;  // of the sign of the number
  long denominator;
};

/// Up to which denominator fractions are looked for, where the number may be off by `error`: 1000,
/// or fewer, 0 too, so that a number taken at random is within the error of one of them with a
/// probability of 1e-6 at most.
std::size_t largest_denominator(double error);

/// The fraction of the least denominator within `error` of the number; none up to that.
std::optional<Fraction> fraction_within(double number, double error);

}  // namespace rotor
