// omega and its derivatives at a time, however they are to be had.
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "rotation/rotation.hpp"
#include "spin/angular_velocity.hpp"

namespace rotor {

/// omega(t + s) = sum_k c[k] s^k, in the frame of omega: its k-th derivative at t is k! c[k].
struct Derivatives {
  static constexpr std::size_t kCount = Jet::kOrder + 1;
  std::array<Vector, kCount> c;
  /// What each of them may be wrong by; infinite where nothing is known of it.
  std::array<double, kCount> error;
  /// Why there are no jets, and differences were taken; "" where there are.
  std::string no_jets;

  /// Whether c[k] is known not to be zero.
  bool differs_from_zero(std::size_t k) const;
};

/// By jets where omega has them. Else by differences of its values between `low` and `high`, which
/// t lies between or upon: the polynomial through twelve of them, at ever shorter distances. It is
/// taken where two of these differ least; the error is what they differ by, or what those at
/// shorter distances do beyond the rounding of their values, which counts too. Some 400 calls.
/// omega must be smooth between low and high; where it is not about t, all errors but the first
/// remain as large as what they are errors of. Errors of omega pass through, but for those of
/// NonFiniteOmega: then nothing is known.
Derivatives derivatives_at(const AngularVelocity& omega, double t, double low, double high);

}  // namespace rotor
