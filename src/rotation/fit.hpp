// Rotations from points [N16-N19], and the mean of rotations.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "rotation/rotation.hpp"

namespace rotor {

/// x = Q X + c [N19], as well as points allow.
struct RigidFit {
  Rotation rotation;   // Q, canonical
  Vector translation;  // c
  double rms = 0;      // root of the (weighted) mean square of |x - (Q X + c)|
  bool unique = true;
  bool mirrored = false;  // a reflection fits at less than half the rms, whatever rounding did
};

struct RigidFitOptions {
  std::vector<double> weights;  // one a point, 0 or more; empty: all equal
  bool translation = true;      // false: c = 0, the attitude from pairs of vectors (Wahba)
};

/// The proper Q and the c of least squares, for points X of the reference configuration and x of
/// the current one; any number of points from 1, any size from 1e-170 to 1e150, any place.
///
/// `unique` says whether the points determine Q: not if they lie on a line or coincide, and not if
/// they are mirrored and equally thick about their longest direction. Decided by what the rounding
/// of the coordinates could do. Otherwise Q is the least turn that takes the longest direction of X
/// to that of x, one of the best; the identity where even that is undetermined.
///
/// Throws std::invalid_argument for lists of different length or none, for coordinates that are not
/// finite, and for weights that are negative, all zero or of another number.
RigidFit fit_rigid(const std::vector<Vector>& reference, const std::vector<Vector>& current,
                   const RigidFitOptions& options = {});

struct Rigidity {
  bool rigid;
  std::string message;  // the pair whose distance differs most and by how much; if it is mirrored
};

/// Whether a rigid motion takes one configuration to the other [N16]: the distances of all pairs
/// agree within the tolerance, relative to the size of the body (the greatest distance of a pair),
/// and the body is not mirrored, which distances do not tell but the continuity of motion excludes.
/// It counts as mirrored if fit_rigid says so and its rms is more than the tolerance allows: a flat
/// body never is. The time is quadratic in the number of points; `look` is called now and then, and
/// what it throws stops the search. Throws as fit_rigid, and unless the tolerance is finite and
/// positive.
Rigidity is_rigid(const std::vector<Vector>& reference, const std::vector<Vector>& current,
                  double tolerance = 1e-9, const std::function<void()>& look = {});

/// The mean of operators: the rotation of the least (weighted) sum of squared Frobenius distances
/// of matrices (chordal L2), canonical. Its quaternion is the dominant eigenvector of sum w q q^T,
/// so the signs of the q do not count. Throws std::invalid_argument for no rotations, for weights
/// as in fit_rigid, and where the mean is not unique: the two greatest eigenvalues are equal.
Rotation mean(const std::vector<Rotation>& rotations, const std::vector<double>& weights = {});

}  // namespace rotor
