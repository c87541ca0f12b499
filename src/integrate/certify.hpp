// The error of a motion, measured on the motion itself.
#pragma once

#include <cstddef>

#include "integrate/flow.hpp"
#include "integrate/loop.hpp"
#include "rotation/rotation.hpp"
#include "spin/angular_velocity.hpp"

namespace rotor {

/// How an error is measured.
struct CertifyOptions {
  /// Gauss points in every interval of the mesh, 3 to 64; where they do not resolve the defect, the
  /// interval is halved, up to twelve times.
  std::size_t n = 20;
  /// Bounds, in rad per unit of t, on what |omega| itself may be wrong by.
  double noise = 0;
  double bias = 0;
};

/// What a motion really does, held against the omega that was to drive it.
///
/// Let U be the true flow, of generator g, and U~ the computed one, of generator g~. Their
/// difference D = U* U~ obeys D' = (R^T (g~ - g)) D / 2, R the matrix of U. Its angle is therefore
/// at most the integral of |g~ - g|, with no constant and no growth, and to first order its
/// rotation vector is the integral of R~^T (g~ - g). Where U~ jumps by a small turn, g~ has that
/// turn as an impulse. No reference solution is needed, and the method does not matter.
struct Certificate {
  /// The greatest rotation error on the way, rad, to first order; not below `rounding`.
  double estimate = 0;
  /// What the rotation error cannot exceed, rad: integral, jumps, rounding and, where they were
  /// given, noise and bias. The integral is that of the points.
  double bound = 0;
  /// The error at the end, to first order, as a rotation vector in the frame in which omega is
  /// given: computed = exp(error) true in the space frame, true exp(error) in the body frame.
  Vector error = Vector::Zero();
  /// What the rounding of omega and of the motion may be responsible for, rad.
  double rounding = 0;
  /// No error was found above it: `estimate` is `rounding`.
  bool at_rounding = true;
  std::size_t omega_calls = 0;
};

/// Measures a flow against omega at Gauss points of its own, between the breaks of omega. Throws
/// std::invalid_argument for options out of range, Interrupted where the observer says no, and
/// whatever omega throws.
Certificate certify(const Flow& flow, const AngularVelocity& omega,
                    const CertifyOptions& options = {}, const Observer& observer = {});

}  // namespace rotor
