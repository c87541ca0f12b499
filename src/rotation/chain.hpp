// Sequences of rotations [notes 7]: about axes fixed in the body or in space, any number of them.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "rotation/frame.hpp"
#include "rotation/rotation.hpp"

namespace rotor {

/// The unit vectors of the letters x, y, z: "zyx" gives e3, e2, e1. Throws std::invalid_argument on
/// any other letter, with a hint where `letters` are such as "ZYX" or "321".
std::vector<Vector> axes_of_letters(const std::string& letters);

/// "; write "zyx", ..." for letters as other programs have them, "ZYX" or "321"; else nothing.
std::string letters_hint(std::string letters);

/// A body at the end of a chain of n rotations Q(u_k, theta_k), as on a mechanism of n hinges.
class Chain {
 public:
  /// Axes u_k of any length but zero, one angle (rad) each and, if its motion is asked for, one
  /// rate (rad/s) each. Throws std::invalid_argument for no axis at all, a zero axis, numbers that
  /// are not finite, and lists of different sizes.
  Chain(const std::vector<Vector>& axes, const std::vector<double>& angles,
        const std::optional<std::vector<double>>& rates = std::nullopt, Frame frame = Frame::kBody);

  /// The product Q [N20], with its angle in [0, 2 pi].
  const Rotation& rotation() const { return rotation_; }

  /// The axes where they are now, in the space frame: v_k = Q1 ... Q(k-1) u_k [N23]; of axes fixed
  /// in space Qn ... Q(k+1) u_k. In the order of the u_k; unit.
  std::vector<Vector> axes() const;

  /// The angular velocity sum of rate_k v_k [N23], space frame, rad/s. Throws std::invalid_argument
  /// if the chain was made without rates.
  Vector omega() const;

  /// 3 x n, its columns the v_k: omega = J rates, space frame.
  Eigen::Matrix3Xd jacobian() const { return axes_.cast<double>(); }

  /// The rank of J, 1 to 3: how many singular values cannot be those of a chain of lower rank whose
  /// axes and angles (within a turn) round to the ones given.
  Eigen::Index rank() const;

  /// dQ/dtheta_k [N21], one matrix for each axis.
  std::vector<Matrix> derivatives() const;

  /// The rates (rad/s) that give the angular velocity `omega` (space frame): of several the ones
  /// with the least sum of squares. Throws std::invalid_argument, with the rank and the part out of
  /// reach, if there are none.
  std::vector<double> rates(const Vector& omega) const;

  std::size_t size() const { return static_cast<std::size_t>(axes_.cols()); }

 private:
  using Jacobian = Eigen::Matrix<Extended, 3, Eigen::Dynamic>;

  Rotation rotation_;
  Jacobian axes_;
  std::optional<Vector> omega_;
  Extended uncertainty_ = 0;  // Frobenius norm of what rounding of axes and angles may do to J
};

/// Whether two operators commute, and why.
struct Commutation {
  bool commute;
  double distance;  // of R S and S R, rad, in [0, pi]
  /// "identity" (R or S is), "parallel axes" or "perpendicular half turns"; "" if not.
  std::string why;
};

/// Operators commute iff one is the identity, the axes are parallel, or both are half turns about
/// perpendicular axes; here to within `tolerance` (rad) of the distance between R S and S R. Throws
/// std::invalid_argument for a negative tolerance or NaN.
Commutation commute(const Rotation& r, const Rotation& s, double tolerance = 1e-12);

}  // namespace rotor
