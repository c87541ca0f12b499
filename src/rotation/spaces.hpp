// Oriented Euclidean spaces of n = 2 to 8 dimensions [N section 1]: vectors are lists of n numbers
// in the standard basis, which is right-handed.
//
// Exact (and then rounded once) where all numbers are integers and the product of the vectors'
// lengths, Hadamard's bound, is below 2^123; otherwise within 2e-17 of that bound before the last
// rounding. A result beyond the largest double is infinite. Errors, all std::invalid_argument: a
// wrong number of vectors or components, numbers that are not finite.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace rotor {

/// Determinant of the operator with the n x n matrix m [N3].
double determinant(const Eigen::MatrixXd& m);

/// The cross product of n - 1 vectors of n components [N1]: the cofactors of the first row, above
/// the vectors as the other rows. Perpendicular to all of them; of one vector in the plane (a2,
/// -a1).
Eigen::VectorXd cross(const std::vector<Eigen::VectorXd>& vectors);

/// The box product a1 . cross(a2, ..., an) of n vectors [N2]: the signed volume of the
/// parallelepiped.
double box(const std::vector<Eigen::VectorXd>& vectors);

/// 1 if the basis is right-handed, -1 if it is left-handed. Never wrong: vectors that are dependent
/// or so nearly that rounding could hide the sign are an error.
int orientation(const std::vector<Eigen::VectorXd>& basis);

/// 1 for an even permutation of 1, 2, ..., n, -1 for an odd one, any n. Throws
/// std::invalid_argument for a list that is no permutation.
int permutation_sign(const std::vector<std::size_t>& list);

}  // namespace rotor
