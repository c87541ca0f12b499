// matrix: what an operator is in the basis (e1, e2, e3).
#include <algorithm>
#include <optional>
#include <string>

#include "rotation/extended.hpp"
#include "rotation/operators.hpp"
#include "script/binding.hpp"
#include "script/show.hpp"

namespace rotor::script {
namespace {

Matrix make_matrix(const Matrix& rows) { return rows; }

Matrix add_matrices(const Matrix& m, const Matrix& n) { return m + n; }
Matrix subtract_matrices(const Matrix& m, const Matrix& n) { return m - n; }
Matrix negative_matrix(const Matrix& m, const Matrix&) { return -m; }
Matrix transpose(const Matrix& m) { return m.transpose(); }
double trace(const Matrix& m) { return static_cast<double>(m.cast<Extended>().trace()); }

Results multiply_matrix(lua_State* L) {
  if (lua_type(L, 1) == LUA_TNUMBER) {
    Convert<Matrix>::push(L, lua_tonumber(L, 1) * argument<Matrix>(L, 2));
    return {1};
  }
  const Matrix m = argument<Matrix>(L, 1);
  if (lua_type(L, 2) == LUA_TNUMBER) {
    Convert<Matrix>::push(L, m * lua_tonumber(L, 2));
  } else if (is_vector(L, 2)) {
    const ExtendedVector v = argument<Vector>(L, 2).cast<Extended>();
    Convert<Vector>::push(L, (m.cast<Extended>() * v).cast<double>());
  } else if (lua_istable(L, 2)) {
    const ExtendedMatrix n = argument<Matrix>(L, 2).cast<Extended>();
    Convert<Matrix>::push(L, (m.cast<Extended>() * n).cast<double>());
  } else {
    throw std::invalid_argument("expected a matrix, a vector or a number on the right, got " +
                                describe(L, 2) + "; a rotation R has R.matrix");
  }
  return {1};
}

// A table that is no matrix is not equal to one.
Results equal_matrices(lua_State* L) {
  bool equal = false;
  try {
    equal = Convert<Matrix>::get(L, 1) == Convert<Matrix>::get(L, 2);
  } catch (const Mismatch&) {
  }
  lua_pushboolean(L, static_cast<int>(equal));
  return {1};
}

std::string text_of_matrix(const Matrix& m) {
  std::string text = "matrix";
  std::size_t width = 0;
  for (const double x : m.reshaped()) width = std::max(width, shown(x).size());
  for (int i = 0; i < 3; ++i) {
    text += "\n ";
    for (int j = 0; j < 3; ++j) {
      const std::string number = shown(m(i, j));
      text += std::string(width + 1 - number.size(), ' ') + number;
    }
  }
  return text;
}

Results basis_from(lua_State* L) {
  refuse_more_arguments(L, 1);
  for (const Vector& v : orthonormal_basis(argument<Vector>(L, 1))) Convert<Vector>::push(L, v);
  return {3};
}

Results properness(lua_State* L) {
  refuse_more_arguments(L, 2);
  const Matrix m = argument<Matrix>(L, 1);
  const auto tolerance = argument<std::optional<double>>(L, 2);
  const Properness found = proper_orthogonal(m, tolerance.value_or(kProperTolerance));
  lua_pushboolean(L, static_cast<int>(found.proper));
  Convert<std::string>::push(L, found.measured);
  return {2};
}

constexpr Entry kFunctions[] = {
    {"matrix", bound<make_matrix>, "matrix(rows) -> matrix",
     "The matrix of an operator, from three rows of three numbers; m[i][j]. Wherever one is taken, "
     "the table of rows will do.",
     "matrix {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}} [2][3] --> 6.0"},
    {"outer", bound<outer>, "outer(a, b) -> matrix",
     "The tensor product of two vectors: the operator that takes x to a times dot(b, x).",
     "outer({1, 2, 3}, {0, 1, 0}) * {5, 6, 7} --> vec(6.0, 12.0, 18.0)"},
    {"skew", bound<skew<double>>, "skew(u) -> matrix",
     "S_u, the operator that takes x to cross(u, x) [N4]. axial(m) is its inverse.",
     "skew {0, 0, 1} * {1, 0, 0} --> vec(0.0, 1.0, 0.0)"},
    {"axial", bound<axial>, "axial(m) -> vec",
     "The axial vector of the skew part of m: skew(axial(m)) is (m - m:transpose())/2. Of a "
     "rotation's matrix, n sin(theta).",
     "axial(skew {1, 2, 3}) --> vec(1.0, 2.0, 3.0)"},
    {"orthonormal_basis", bound<basis_from>, "orthonormal_basis(u) -> vec, vec, vec",
     "A right-handed orthonormal basis (u, v, w), u the direction of the vector given [N6].",
     "orthonormal_basis {0, 0, 2} --> vec(0.0, 0.0, 1.0)"},
    {"proper_orthogonal", bound<properness>, "proper_orthogonal(m, tolerance) -> boolean, string",
     "Whether m is the matrix of a rotation: no entry of m^T m - 1 is larger than the tolerance "
     "(default 1e-6) and the determinant is positive. Then what was measured.",
     "proper_orthogonal {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}} --> false"},
};

constexpr Entry kStatics[] = {
    {"from_eigenvectors", bound<from_eigenvectors>, "rotation.from_eigenvectors(m) -> rotation",
     "As from_matrix, by eigenvalues and eigenvectors [N14]: angle and axis of the eigenvalue with "
     "positive imaginary part. Near the identity the axis is off by 1e-16/angle; from_matrix is "
     "exact there.",
     "rotation.from_eigenvectors({{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}).axis --> vec(0.0, 0.0, 1.0)"},
};

constexpr Entry kMethods[] = {
    {"transpose", bound<transpose>, "m:transpose() -> matrix",
     "Rows and columns exchanged; of a rotation's matrix, the inverse.",
     "skew {1, 2, 3}:transpose() == -skew {1, 2, 3} --> true"},
    {"trace", bound<trace>, "m:trace() -> number",
     "The sum of the diagonal; of a rotation's matrix, 1 + 2 cos(theta).",
     "matrix {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}:trace() --> 15.0"},
};

constexpr Entry kOperators[] = {
    {"__mul", bound<multiply_matrix>, "x * m -> matrix", "Matrix times number, from either side.",
     "(2 * rotation.identity.matrix)[1][1] --> 2.0"},
    {"__mul", bound<multiply_matrix>, "m * v -> vec", "The operator applied to a vector.",
     "rotation({0, 0, 1}, 0).matrix * {1, 2, 3} --> vec(1.0, 2.0, 3.0)"},
    {"__mul", bound<multiply_matrix>, "m * n -> matrix", "Product: n first, then m.",
     "skew {1, 0, 0} * skew {0, 1, 0} == outer({0, 1, 0}, {1, 0, 0}) --> true"},
    {"__add", bound<add_matrices>, "m + n -> matrix", "Sum.",
     "(rotation.identity.matrix + outer({1, 1, 1}, {1, 1, 1}))[1][1] --> 2.0"},
    {"__sub", bound<subtract_matrices>, "m - n -> matrix", "Difference.",
     "skew {1, 2, 3} - skew {1, 2, 2} == skew {0, 0, 1} --> true"},
    {"__unm", bound<negative_matrix>, "-m -> matrix", "The opposite matrix.",
     "-skew {1, 2, 3} == skew {-1, -2, -3} --> true"},
    {"__eq", bound<equal_matrices>, "m == n -> boolean", "Whether all entries are equal.",
     "skew {1, 2, 3} == skew {1, 2, 3} --> true"},
    {"__tostring", bound<text_of_matrix>, "tostring(m) -> string",
     "The text under which the terminal shows it.",
     "#tostring(rotation.identity.matrix) > 0 --> true"},
};

constexpr Group kGroups[] = {
    {"", Kind::kFunction, kFunctions},
    {"rotation", Kind::kFunction, kStatics},
    {"matrix", Kind::kMethod, kMethods},
    {"matrix", Kind::kOperator, kOperators},
};

}  // namespace

std::span<const Group> matrix_groups() { return kGroups; }

}  // namespace rotor::script
