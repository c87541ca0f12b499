#include "rotation/fit.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "rotation/extended.hpp"
#include "rotation/text.hpp"

namespace rotor {
namespace {

// Half an ulp of 1: what rounding does to a number, relatively.
constexpr Extended kDoubleUnit = std::numeric_limits<double>::epsilon() / 2;
constexpr Extended kExtendedUnit = std::numeric_limits<Extended>::epsilon() / 2;

// The weights as parts of their sum.
std::vector<Extended> parts(const std::vector<double>& weights, std::size_t count,
                            const std::string& what) {
  if (weights.empty()) return std::vector<Extended>(count, Extended{1} / Extended(count));
  if (weights.size() != count) {
    throw std::invalid_argument(what + ": expected " + std::to_string(count) + " weights, got " +
                                std::to_string(weights.size()));
  }
  Extended sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (!(weights[i] >= 0 && std::isfinite(weights[i]))) {
      throw std::invalid_argument(what + ": weight " + std::to_string(i + 1) +
                                  ": expected a finite number, 0 or more, got " + text(weights[i]));
    }
    sum += weights[i];
  }
  if (sum == 0) throw std::invalid_argument(what + ": all weights are zero");
  std::vector<Extended> all;
  all.reserve(count);
  for (const double weight : weights) all.push_back(weight / sum);
  return all;
}

void require_points(const std::vector<Vector>& reference, const std::vector<Vector>& current,
                    const std::string& what) {
  if (reference.size() != current.size()) {
    throw std::invalid_argument(what + ": expected as many points in both lists, got " +
                                std::to_string(reference.size()) + " and " +
                                std::to_string(current.size()));
  }
  if (reference.empty()) throw std::invalid_argument(what + ": expected one point or more");
  for (const auto* list : {&reference, &current}) {
    for (std::size_t i = 0; i < list->size(); ++i) {
      require_finite((*list)[i],
                     (what + ": point " + std::to_string(i + 1) +
                      (list == &reference ? " of the first list" : " of the second list"))
                         .c_str());
    }
  }
}

// One configuration: its points from its centroid.
struct Cloud {
  Cloud(const std::vector<Vector>& points, const std::vector<Extended>& weights, bool centred) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const ExtendedVector p = points[i].cast<Extended>();
      if (centred) centre += weights[i] * p;
      rounding += weights[i] * p.squaredNorm();
    }
    rounding = kDoubleUnit * std::sqrt(rounding);
    for (const Vector& p : points) from_centre.emplace_back(p.cast<Extended>() - centre);
  }

  // Root mean square of the distances from the line through the centre along `direction`, a unit
  // vector; from the centre if it is zero.
  Extended thickness(const std::vector<Extended>& weights, const ExtendedVector& direction) const {
    Extended sum = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const ExtendedVector& p = from_centre[i];
      sum += weights[i] * (p - direction * direction.dot(p)).squaredNorm();
    }
    return std::sqrt(sum);
  }

  std::vector<ExtendedVector> from_centre;
  ExtendedVector centre = ExtendedVector::Zero();
  Extended rounding = 0;  // root mean square of what rounding did to the points
};

// Two configurations and the singular values and vectors of H = sum w x X^T. With H = U S V^T the
// orthogonal matrix nearest to it is U V^T, and the proper one U diag(1, 1, d) V^T, d = det(U V^T).
class Alignment {
 public:
  Alignment(const std::vector<Vector>& reference, const std::vector<Vector>& current,
            std::vector<Extended> weights, bool centred)
      : weights_(std::move(weights)),
        from_(reference, weights_, centred),
        to_(current, weights_, centred) {
    ExtendedMatrix h = ExtendedMatrix::Zero();
    for (std::size_t i = 0; i < weights_.size(); ++i) {
      const auto& x = to_.from_centre[i];
      h += (weights_[i] * x) * from_.from_centre[i].transpose();
    }
    const Eigen::JacobiSVD<ExtendedMatrix> svd(h, Eigen::ComputeFullU | Eigen::ComputeFullV);
    u_ = svd.matrixU();
    v_ = svd.matrixV();
    s_ = svd.singularValues();
    d_ = u_.determinant() * v_.determinant() < 0 ? -1 : 1;
  }

  // What rounding can do to a singular value of H. A turn about the direction `u` = Q `v` moves
  // points by their thickness t about it; noise of size r in the points pulls at that turn with r
  // t at most, once for either configuration. Eight times that, for coordinates which were
  // themselves computed, and what the sums and the decomposition do here.
  Extended noise(const ExtendedVector& u, const ExtendedVector& v) const {
    const ExtendedVector none = ExtendedVector::Zero();
    const Extended spread = from_.thickness(weights_, none) * to_.thickness(weights_, none);
    return 8 * (to_.rounding * from_.thickness(weights_, v) +
                from_.rounding * to_.thickness(weights_, u)) +
           (Extended(weights_.size()) + 32) * kExtendedUnit * spread;
  }

  RigidFit fit() const {
    RigidFit result;
    const ExtendedVector u = u_.col(0), v = v_.col(0);
    result.unique = s_(1) + d_ * s_(2) > noise(u, v);
    ExtendedQuaternion q = proper();
    if (!result.unique) {
      const bool one_direction = s_(0) > noise(ExtendedVector::Zero(), ExtendedVector::Zero());
      q = one_direction ? least_turn(q, u) : ExtendedQuaternion::Identity();
    }
    const ExtendedVector c = to_.centre - q * from_.centre;
    const Extended least = rms(q.toRotationMatrix());
    result.rotation = canonical_of(q);
    result.translation = c.cast<double>();
    result.rms = static_cast<double>(least);
    result.mirrored =
        d_ < 0 && least > 2 * rms(u_ * v_.transpose()) + 8 * (from_.rounding + to_.rounding);
    return result;
  }

 private:
  // Root mean square of what is left of the points by an orthogonal matrix.
  Extended rms(const ExtendedMatrix& q) const {
    Extended squares = 0;
    for (std::size_t i = 0; i < weights_.size(); ++i) {
      squares += weights_[i] * (to_.from_centre[i] - q * from_.from_centre[i]).squaredNorm();
    }
    return std::sqrt(squares);
  }

  ExtendedQuaternion proper() const {
    const ExtendedMatrix m = u_ * ExtendedVector(1, 1, d_).asDiagonal() * v_.transpose();
    return ExtendedQuaternion(m).normalized();
  }

  // Of all turns about u after q the one of least angle: (cos, u sin) of half the turn times q has
  // the greatest scalar part.
  static ExtendedQuaternion least_turn(const ExtendedQuaternion& q, const ExtendedVector& u) {
    const Extended w = q.w();
    const Extended twist = u.dot(q.vec());
    if (w == 0 && twist == 0) return q;  // u is reversed: every half turn that does it is as good
    const ExtendedVector back = -twist * u;
    return (ExtendedQuaternion(w, back.x(), back.y(), back.z()) * q).normalized();
  }

  std::vector<Extended> weights_;
  Cloud from_, to_;
  ExtendedMatrix u_, v_;
  ExtendedVector s_;
  Extended d_ = 1;
};

struct Pair {
  std::size_t i = 0, j = 0;
  Extended difference = 0;  // of the distances, second configuration less first
  Extended size = 0;        // the greatest distance of any pair, in either
};

Pair worst_pair(const std::vector<Vector>& reference, const std::vector<Vector>& current,
                const std::function<void()>& look) {
  Pair worst;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    if (look) look();
    for (std::size_t j = i + 1; j < reference.size(); ++j) {
      const Extended from = (reference[j].cast<Extended>() - reference[i].cast<Extended>()).norm();
      const Extended to = (current[j].cast<Extended>() - current[i].cast<Extended>()).norm();
      worst.size = std::max({worst.size, from, to});
      if (std::abs(to - from) <= std::abs(worst.difference)) continue;
      worst = {i, j, to - from, worst.size};
    }
  }
  return worst;
}

}  // namespace

RigidFit fit_rigid(const std::vector<Vector>& reference, const std::vector<Vector>& current,
                   const RigidFitOptions& options) {
  require_points(reference, current, "fit_rigid");
  return Alignment(reference, current, parts(options.weights, reference.size(), "fit_rigid"),
                   options.translation)
      .fit();
}

Rigidity is_rigid(const std::vector<Vector>& reference, const std::vector<Vector>& current,
                  double tolerance, const std::function<void()>& look) {
  require_points(reference, current, "is_rigid");
  if (!(tolerance > 0 && std::isfinite(tolerance))) {
    throw std::invalid_argument("is_rigid: expected a finite positive tolerance, got " +
                                text(tolerance));
  }
  const Pair worst = worst_pair(reference, current, look);
  if (worst.difference == 0 && worst.size == 0) return {true, "the points coincide"};
  const Extended relative = worst.difference / worst.size;
  const std::string by = text(static_cast<double>(std::abs(relative)), 3) + " of the body's size";
  const RigidFit fit = fit_rigid(reference, current);
  if (std::abs(relative) > tolerance) {
    return {false, "points " + std::to_string(worst.i + 1) + " and " + std::to_string(worst.j + 1) +
                       " are " + (relative > 0 ? "farther apart" : "nearer to each other") +
                       " by " + by + (fit.mirrored ? ", and it is mirrored" : "")};
  }
  if (fit.mirrored && fit.rms > tolerance * static_cast<double>(worst.size)) {
    return {false, "mirrored: all distances agree, but only a reflection leads there"};
  }
  return {true, "all distances agree to " + by};
}

Rotation mean(const std::vector<Rotation>& rotations, const std::vector<double>& weights) {
  if (rotations.empty()) throw std::invalid_argument("mean: expected one rotation or more");
  const std::vector<Extended> parts_of_sum = parts(weights, rotations.size(), "mean");
  using Matrix4 = Eigen::Matrix<Extended, 4, 4>;
  Matrix4 sum = Matrix4::Zero();
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    const auto q = half_angle_quaternion(rotations[i]).coeffs();
    sum += (parts_of_sum[i] * q) * q.transpose();
  }
  // Symmetric without negative eigenvalues: these are the singular values, falling, of sum 1.
  const Eigen::JacobiSVD<Matrix4> svd(sum, Eigen::ComputeFullU);
  const auto& values = svd.singularValues();
  // A rounded axis moves q by 4 units at most, q q^T by twice that, and each eigenvalue by as much.
  if (values(0) - values(1) <= 16 * kDoubleUnit) {
    throw std::invalid_argument(
        "mean: many rotations are as near to all: the two greatest eigenvalues of sum w q q^T are "
        "equal, " +
        text(static_cast<double>(values(0)), 6));
  }
  return canonical_of(ExtendedQuaternion(svd.matrixU().col(0).eval()));
}

}  // namespace rotor
