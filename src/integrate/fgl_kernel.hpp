// The arithmetic of the fast integrator, in the best instructions that the machine has.
#pragma once

#include <array>
#include <cstddef>

#include "rotation/rotation.hpp"

namespace rotor {

inline constexpr std::size_t kFglNodes = 16;

/// A vector at the 16 nodes of Gauss and Legendre on [-1, 1], [component][lane]: lane l < 8 at
/// +x_l, lane 8 + l at -x_l, x_l = kGauss16Nodes[l].
struct alignas(32) NodeVectors {
  std::array<std::array<double, kFglNodes>, 3> v;
};

/// Numbers for three functions: the 64 terms of their Legendre series, or their values at the 64
/// nodes, lane j < 32 at +x_j, lane 32 + j at -x_j, x_j = kGauss64Nodes[j].
using PanelTerms = std::array<std::array<double, 64>, 3>;

/// One step of V' = w x V over z from -1 to 1.
struct FglStep {
  /// (w, x, y, z) of V(1) V(-1)*.
  std::array<double, 4> turn;
  /// Estimates of its error, rad, and of that of the dense output within it; infinite where w is
  /// too long for the method.
  double error;
  double between;
  /// The part of the error that is what was left out as negligible.
  double rest;
  /// The size (root mean square) of the first terms of w that 16 nodes do not tell.
  double left_out;
  /// By how much the squares of the sizes of its last terms fell over five degrees, at most 1.
  double fall;
};

/// d w / dz at the nodes, of the interpolant, and its values at z = 1 and z = -1, [component][end].
struct alignas(32) NodeSlopes {
  NodeVectors slopes;
  std::array<std::array<double, 2>, 3> ends;
};

/// P_0 ... P_63, [n][lane].
struct alignas(32) LegendreLanes {
  std::array<std::array<double, kFglNodes>, 64> p;
};

/// The motion within a step, (w, x, y, z): V(z) V(-1)* at the nodes and at z = 1.
struct alignas(32) FglInterior {
  std::array<std::array<double, kFglNodes>, 4> nodes;
  std::array<double, 4> end;
};

/// The Chebyshev series of U = (x, y, z, w) over a part of a step, z from -1 to 1: [n][component].
struct alignas(32) FglPiece {
  std::array<std::array<double, 4>, kFglNodes + 2> terms;
};

/// The same arithmetic, compiled for one kind of machine. Results do not depend on the kind, to the
/// last bit: no operation is contracted or reordered.
struct FglKernel {
  /// `w` is the generator times half the step. Contributions below `negligible` (rad) may be left
  /// out; terms of w of a size up to `noise` count as noise.
  FglStep (*step)(const NodeVectors& w, double negligible, double noise);
  /// False where w is too long for the method.
  bool (*interior)(const NodeVectors& w, FglInterior& out);
  /// The polynomial of degree 17 through (1 + s turn) V from at the nodes and at both ends, where
  /// s goes from 0 to 1.
  void (*fit)(const FglInterior& v, const std::array<double, 4>& from,
              const std::array<double, 4>& turn, FglPiece& out);
  /// Its value, made unit: (x, y, z, w).
  void (*value)(const FglPiece& piece, double z, double* out);
  /// Legendre's polynomials at the nodes of the interval middle +- half.
  void (*legendre)(double middle, double half, LegendreLanes& out);
  /// The Legendre series c, times `scale`, at the nodes of that interval and of its mirror image
  /// -middle +- half.
  void (*restrict_to)(const LegendreLanes& legendre, const PanelTerms& c, Extended scale,
                      NodeVectors& out, NodeVectors& mirrored);
  /// The products of two 32 x 32 matrices, columns first, with f(x_j) + f(-x_j) and with
  /// f(x_j) - f(-x_j): the former in out[.][0 ... 31], the latter in out[.][32 ... 63].
  void (*parity_product)(const double* even, const double* odd, const PanelTerms& f,
                         PanelTerms& out);
  void (*slope)(const NodeVectors& w, NodeSlopes& out);
};

/// The best for this machine, chosen once: that for AVX2 where there is AVX2, unless the
/// environment says ROTOR_PORTABLE=1.
const FglKernel& fgl_kernel();
const FglKernel& portable_fgl_kernel();

}  // namespace rotor
