#include "rotation/spaces.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "rotation/extended.hpp"
#include "rotation/text.hpp"

namespace rotor {
namespace {

__extension__ using Integer = __int128;

constexpr Eigen::Index kLeast = 2;
constexpr Eigen::Index kMost = 8;

// The error of a minor of k <= 8 rows in Extended, over the product of the rows' lengths: each
// level of k terms rounds k times, 2 + ... + 8 = 35 roundings of 2^-64 in all, of the permanent of
// the moduli, which is at most k!/k^(k/2) times that product (Carlen, Lieb and Loss 2006), 9.85 for
// k = 8.
constexpr Extended kMinorError = 2e-17L;

// The vectors as rows, `missing` fewer of them than they have components.
Eigen::MatrixXd rows_of(const std::vector<Eigen::VectorXd>& vectors, Eigen::Index missing) {
  const auto count = static_cast<Eigen::Index>(vectors.size());
  const Eigen::Index n = count + missing;
  const bool fits = kLeast <= n && n <= kMost &&
                    std::all_of(vectors.begin(), vectors.end(),
                                [&](const Eigen::VectorXd& v) { return v.size() == n; });
  if (!fits) {
    std::string sizes;
    for (const Eigen::VectorXd& v : vectors) {
      sizes += (sizes.empty() ? " of " : ", ") + std::to_string(v.size());
    }
    throw std::invalid_argument(std::string("expected ") + (missing == 0 ? "n" : "n - 1") +
                                " vectors of n numbers each, n from 2 to 8, got " +
                                std::to_string(count) + (count == 1 ? " vector" : " vectors") +
                                sizes + (count == 0 ? "" : " numbers"));
  }
  Eigen::MatrixXd rows(count, n);
  for (Eigen::Index i = 0; i < count; ++i) {
    rows.row(i) = vectors[static_cast<std::size_t>(i)].transpose();
  }
  return rows;
}

// Hadamard's bound of the minors of all the rows.
Extended product_of_lengths(const Eigen::MatrixXd& rows) {
  return rows.cast<Extended>().rowwise().norm().prod();
}

// Whether all the minors, of the first few rows too, can be computed in Integer without overflow:
// they are at most 2^123, and the terms of each, in any partial sum, sqrt(8) times as much.
bool fit_integers(const Eigen::MatrixXd& rows) {
  return rows == rows.array().round().matrix() &&
         rows.cast<Extended>().rowwise().norm().cwiseMax(Extended{1}).prod() <= 0x1p123L;
}

// The minors of the first k rows on every set of k columns, by the set's bits: expanded along row
// k, from the minors of one row less. No division, hence no pivot.
template <class Scalar>
std::vector<Scalar> minors(const Eigen::MatrixXd& rows) {
  std::vector<Scalar> minor(std::size_t{1} << rows.cols());
  minor[0] = 1;
  for (std::size_t columns = 1; columns < minor.size(); ++columns) {
    const int k = std::popcount(columns);
    if (k > rows.rows()) continue;
    bool negative = k % 2 == 0;  // the sign of the first column in the last of k rows
    for (Eigen::Index j = 0; j < rows.cols(); ++j) {
      const std::size_t column = std::size_t{1} << j;
      if ((columns & column) == 0) continue;
      const Scalar term = static_cast<Scalar>(rows(k - 1, j)) * minor[columns ^ column];
      minor[columns] += negative ? -term : term;
      negative = !negative;
    }
  }
  return minor;
}

// use(minors of the rows): in Integer where they fit, else in Extended.
template <class Use>
auto with_minors(const Eigen::MatrixXd& rows, const Use& use) {
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    for (const double x : rows.row(i)) {
      if (!std::isfinite(x)) {
        throw std::invalid_argument("expected finite numbers, got " + text(x) + " in vector " +
                                    std::to_string(i + 1));
      }
    }
  }
  return fit_integers(rows) ? use(minors<Integer>(rows)) : use(minors<Extended>(rows));
}

double volume(const Eigen::MatrixXd& rows) {
  return with_minors(rows, [](const auto& minor) { return static_cast<double>(minor.back()); });
}

}  // namespace

double determinant(const Eigen::MatrixXd& m) {
  if (m.rows() != m.cols() || m.rows() < kLeast || m.rows() > kMost) {
    throw std::invalid_argument("expected an n x n matrix, n from 2 to 8, got " +
                                std::to_string(m.rows()) + " x " + std::to_string(m.cols()));
  }
  return volume(m);
}

Eigen::VectorXd cross(const std::vector<Eigen::VectorXd>& vectors) {
  const Eigen::MatrixXd rows = rows_of(vectors, 1);
  return with_minors(rows, [&](const auto& minor) {
    Eigen::VectorXd product(rows.cols());
    for (Eigen::Index j = 0; j < rows.cols(); ++j) {
      const auto cofactor = minor[(minor.size() - 1) ^ (std::size_t{1} << j)];
      product(j) = static_cast<double>(j % 2 == 0 ? cofactor : 0 - cofactor);  // no -0
    }
    return product;
  });
}

double box(const std::vector<Eigen::VectorXd>& vectors) { return volume(rows_of(vectors, 0)); }

int orientation(const std::vector<Eigen::VectorXd>& basis) {
  const Eigen::MatrixXd rows = rows_of(basis, 0);
  return with_minors(rows, [&](const auto& minor) {
    using Scalar = typename std::remove_cvref_t<decltype(minor)>::value_type;
    const auto volume = static_cast<Extended>(minor.back());
    const bool exact = std::is_same_v<Scalar, Integer>;
    const Extended error = exact ? 0 : kMinorError * product_of_lengths(rows);
    if (std::abs(volume) <= error) {
      throw std::invalid_argument(
          exact ? "the vectors are dependent: they have no orientation"
                : "the vectors are dependent, or too nearly so to tell their orientation: their "
                  "volume is within 2e-17 of the product of their lengths");
    }
    return volume > 0 ? 1 : -1;
  });
}

int permutation_sign(const std::vector<std::size_t>& list) {
  const std::size_t n = list.size();
  std::vector<bool> seen(n);
  for (const std::size_t i : list) {
    if (i < 1 || i > n || seen[i - 1]) {
      throw std::invalid_argument("expected a permutation of 1 to " + std::to_string(n) +
                                  ", got a list with " + std::to_string(i) +
                                  (i < 1 || i > n ? " in it" : " twice"));
    }
    seen[i - 1] = true;
  }
  // A cycle of length k is k - 1 interchanges.
  int sign = 1;
  for (std::size_t start = 0; start < n; ++start) {
    if (!seen[start]) continue;
    seen[start] = false;
    for (std::size_t i = list[start] - 1; i != start; i = list[i] - 1) {
      seen[i] = false;
      sign = -sign;
    }
  }
  return sign;
}

}  // namespace rotor
