// n-dimensional products: against exact rationals, on integers and on awkward doubles.
#include "rotation/spaces.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <numeric>

#include "elements.hpp"
#include "refusal.hpp"

using namespace rotor;
using namespace rotor::reference;
using Rational = boost::multiprecision::cpp_rational;

namespace {

using Rows = std::vector<Eigen::VectorXd>;

// Gauss's elimination in exact fractions: another way than rotor's expansion into minors.
Rational exact_determinant(const Rows& rows) {
  const std::size_t n = rows.size();
  std::vector<std::vector<Rational>> a(n, std::vector<Rational>(n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) a[i][j] = Rational(rows[i][Eigen::Index(j)]);
  Rational product = 1;
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    while (pivot < n && a[pivot][k] == 0) ++pivot;
    if (pivot == n) return 0;
    if (pivot != k) {
      std::swap(a[pivot], a[k]);
      product = -product;
    }
    product *= a[k][k];
    for (std::size_t i = k + 1; i < n; ++i) {
      const Rational factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j < n; ++j) a[i][j] -= factor * a[k][j];
    }
  }
  return product;
}

// The product of the lengths but for 1e-17 of it, in the range of Extended.
Extended hadamard(const Rows& rows) {
  Extended product = 1;
  for (const auto& row : rows) product *= row.cast<Extended>().norm();
  return product;
}

Extended wide(const Rational& x) {
  return x.convert_to<boost::multiprecision::cpp_bin_float_double_extended>()
      .convert_to<Extended>();
}

// `count` vectors of n components, each number a new one.
template <class Number>
Rows rows_of(int count, int n, const Number& number) {
  Rows rows(static_cast<std::size_t>(count), Eigen::VectorXd::Zero(n));
  for (auto& row : rows)
    for (double& x : row) x = number();
  return rows;
}

Rational dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  Rational sum = 0;
  for (Eigen::Index i = 0; i < a.size(); ++i) sum += Rational(a[i]) * Rational(b[i]);
  return sum;
}

}  // namespace

TEST_CASE("determinant, box and cross products of integers are exact") {
  const std::uint64_t seed = 801;
  CAPTURE(seed);
  Draw draw(seed);
  for (int n = 2; n <= 8; ++n) {
    // Of entries up to `size` the product of n lengths is at most (size sqrt n)^n < 2^123, and most
    // results have more than 53 digits: rounded once.
    for (int size : {1, 9, 14000}) {
      for (int i = 0; i < 12; ++i) {
        Rows rows = rows_of(n, n, [&] { return double(draw.below(2 * size + 1) - size); });
        if (i % 4 == 0) rows[0] = rows[1] + (n > 2 ? rows[std::size_t(n) - 1] : rows[1]);
        const double expected = exact_determinant(rows).convert_to<double>();
        CAPTURE(n, size, i);
        CHECK(box(rows) == expected);
        Eigen::MatrixXd m(n, n);
        for (int k = 0; k < n; ++k) m.col(k) = rows[std::size_t(k)];  // det of the transpose
        CHECK(determinant(m) == expected);
        const Rows others(rows.begin() + 1, rows.end());
        const Eigen::VectorXd product = cross(others);
        for (int j = 0; j < n; ++j) {
          Rows with_unit = rows;
          with_unit[0] = Eigen::VectorXd::Unit(n, j);
          CHECK(product[j] == exact_determinant(with_unit).convert_to<double>());
        }
        if (expected == 0) {
          CHECK(refusal([&] { orientation(rows); }).find("dependent") != std::string::npos);
        } else {
          CHECK(orientation(rows) == (expected > 0 ? 1 : -1));
        }
      }
    }
  }
}

TEST_CASE("determinant and cross product of any doubles: within 2e-17 of Hadamard's bound") {
  // Ordinary, scaled rows, all sizes in one row, nearly dependent.
  const std::uint64_t seed = 802;
  CAPTURE(seed);
  Draw draw(seed);
  for (int kind = 0; kind < 4; ++kind) {
    Worst worst, perpendicular;
    for (int n = 2; n <= 8; ++n) {
      for (int i = 0; i < 10; ++i) {
        Rows rows = rows_of(n, n, [&] {
          return draw.uniform(-1, 1) * (kind == 2 ? std::pow(10, draw.uniform(-30, 30)) : 1);
        });
        for (auto& row : rows) {
          if (kind == 1) row *= std::pow(10, draw.uniform(-200, 200) / n);
          if (kind == 3) row = rows[0] + row * std::pow(10, draw.uniform(-12, 0));
        }
        const auto where = [&] {
          return std::to_string(n) + " dimensions, case " + std::to_string(i);
        };
        const Rational exact = exact_determinant(rows);
        const double measured = box(rows);
        // The result is a double: half an ulp of it more, of a subnormal one 2.5e-324.
        const Extended rounding = std::max(std::abs(wide(exact)) * 0x1p-53L, 2.5e-324L);
        const Extended error = std::abs(wide(exact - Rational(measured)));
        worst.add((error - rounding) / hadamard(rows), where);

        const Rows others(rows.begin() + 1, rows.end());
        const Eigen::VectorXd product = cross(others);
        // Its n components are off by 2e-17 of the lengths' product and half an ulp, 1.2e-16 of it.
        for (const auto& other : others) {
          const Extended size = hadamard(others) * other.cast<Extended>().norm();
          perpendicular.add(std::abs(wide(dot(product, other))) / size, where);
        }
      }
    }
    CAPTURE(kind);
    worst.within("error over Hadamard's bound", 2e-17);
    perpendicular.within("a . cross over lengths", std::sqrt(8.0) * 1.4e-16);
  }
}

TEST_CASE("determinants of Hilbert matrices, and beyond the doubles") {
  // det H_n = c_n^4 / c_2n with c_n = 1! 2! ... (n - 1)!, of entries 1/(i + j - 1) that are
  // rounded: the exact determinant is that of the rounded entries.
  for (int n = 2; n <= 8; ++n) {
    Rows rows(static_cast<std::size_t>(n), Eigen::VectorXd::Zero(n));
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) rows[std::size_t(i)][j] = 1.0 / (i + j + 1);
    CAPTURE(n);
    const Rational exact = exact_determinant(rows);
    const Extended size = hadamard(rows);
    CHECK(std::abs(wide(exact - Rational(box(rows)))) <=
          2e-17L * size + std::abs(wide(exact)) * 0x1p-53L);
    // 2.5e-16 of the bound for n = 6, 7e-23 for n = 7: that 64 bits cannot tell from 0.
    if (n <= 6) {
      CHECK(orientation(rows) == 1);
    } else {
      CHECK(refusal([&] { orientation(rows); }).find("too nearly so") != std::string::npos);
    }
  }
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(8, 8);
  CHECK(determinant(1e300 * one) == std::numeric_limits<double>::infinity());
  CHECK(determinant(1e-300 * one) == 0);
  CHECK(determinant(Eigen::Vector2d(1e300, 1e-300).asDiagonal().toDenseMatrix()) ==
        Approx(1).epsilon(3e-16));
  // The sign does not suffer.
  Rows tiny(8, Eigen::VectorXd::Zero(8));
  for (int i = 0; i < 8; ++i) tiny[std::size_t(i)][7 - i] = i % 2 == 0 ? 5e-324 : -1e308;
  CHECK(orientation(tiny) == 1);  // the reversal of 8 is even, four signs
}

TEST_CASE("orientation never guesses") {
  const auto of = [](double x, double y, double u, double v) {
    return orientation({Eigen::Vector2d(x, y), Eigen::Vector2d(u, v)});
  };
  CHECK(of(1, 0, 0, 1) == 1);
  CHECK(of(0, 1, 1, 0) == -1);
  // 2^27 (2^27 + 2) - (2^27 + 1)^2 = -1, times 2^-60: products of 55 bits.
  const double a = 0x1p27, s = 0x1p-30;
  CHECK(of(s * a, s * (a + 1), s * (a + 1), s * (a + 2)) == -1);
  // As close, and not to be told in 64 bits: 2^52 (2^52 + 2) - (2^52 + 1)^2 = -1. Exact if whole.
  const double b = 0x1p52;
  CHECK(of(b, b + 1, b + 1, b + 2) == -1);
  CHECK(refusal([&] {
          of(b / 0x1p60, (b + 1) / 0x1p60, (b + 1) / 0x1p60, (b + 2) / 0x1p60);
        }).find("too nearly so to tell") != std::string::npos);
  CHECK(refusal([&] { of(1, 2, 2, 4); }) == "the vectors are dependent: they have no orientation");
  CHECK(refusal([&] { of(0.1, 0.2, 0.2, 0.4); }).find("dependent") == 16);
  CHECK(refusal([&] { of(0, 0, 0.5, 1); }).find("dependent") == 16);
}

TEST_CASE(
    "N1 to N3: the cross product of the standard basis, even permutations, det of an operator") {
  for (int n = 2; n <= 8; ++n) {
    CAPTURE(n);
    Rows others;
    for (int i = 1; i < n; ++i) others.push_back(Eigen::VectorXd::Unit(n, i));
    CHECK(cross(others) == Eigen::VectorXd::Unit(n, 0));

    const std::uint64_t seed = 803;
    Draw draw(seed);
    const Rows rows = rows_of(n, n, [&] { return double(draw.below(19) - 9); });
    const Eigen::MatrixXd t =
        Eigen::MatrixXd::NullaryExpr(n, n, [&] { return draw.below(7) - 3.0; });
    Rows images;
    for (const auto& row : rows) images.push_back(t * row);
    CHECK(determinant(t) * box(rows) == box(images));

    std::vector<std::size_t> order(std::size_t(n), 0);
    std::iota(order.begin(), order.end(), 1);
    for (int i = 0; i < 200; ++i) {
      Rows permuted;
      std::size_t inversions = 0;
      for (std::size_t k = 0; k < order.size(); ++k) {
        permuted.push_back(rows[order[k] - 1]);
        for (std::size_t l = 0; l < k; ++l) inversions += order[l] > order[k] ? 1 : 0;
      }
      CHECK(permutation_sign(order) == (inversions % 2 == 0 ? 1 : -1));
      CHECK(box(permuted) == permutation_sign(order) * box(rows));
      std::next_permutation(order.begin(), order.end());
    }
  }
  CHECK(cross({Eigen::Vector2d(3, 4)}) == Eigen::VectorXd(Eigen::Vector2d(4, -3)));
  CHECK(permutation_sign({}) == 1);
}

TEST_CASE("refused: wrong sizes, numbers that are not finite, lists that are no permutation") {
  const Eigen::VectorXd two = Eigen::Vector2d(1, 2), three = Vector(1, 2, 3);
  CHECK(refusal([&] {
          cross({three, two});
        }) ==
        "expected n - 1 vectors of n numbers each, n from 2 to 8, got 2 vectors of 3, 2 numbers");
  CHECK(refusal([&] { cross({}); }) ==
        "expected n - 1 vectors of n numbers each, n from 2 to 8, got 0 vectors");
  CHECK(refusal([&] { box({two}); }) ==
        "expected n vectors of n numbers each, n from 2 to 8, got 1 vector of 2 numbers");
  CHECK(refusal([&] { orientation({three, three}); }).find("expected n vectors") == 0);
  CHECK(refusal([&] { box(Rows(9, Eigen::VectorXd::Ones(9))); }).find("n from 2 to 8") !=
        std::string::npos);
  CHECK(refusal([] { determinant(Eigen::MatrixXd::Ones(2, 3)); }) ==
        "expected an n x n matrix, n from 2 to 8, got 2 x 3");
  CHECK(refusal([] { determinant(Eigen::MatrixXd(0, 0)); }).find("got 0 x 0") != std::string::npos);
  for (double bad :
       {std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity()}) {
    CHECK(refusal([&] {
            box({two, Eigen::Vector2d(0, bad)});
          }) == "expected finite numbers, got " + text(bad) + " in vector 2");
  }
  CHECK(refusal([] {
          permutation_sign({1, 3, 3});
        }) == "expected a permutation of 1 to 3, got a list with 3 twice");
  CHECK(refusal([] {
          permutation_sign({2, 0});
        }) == "expected a permutation of 1 to 2, got a list with 0 in it");
  CHECK(refusal([] {
          permutation_sign({2, 3});
        }) == "expected a permutation of 1 to 2, got a list with 3 in it");
}
