// The order conditions of the tableaus, one for each rooted tree t (Butcher). Order p means that
//   sum_i b_i Phi_i(t) = 1 / gamma(t)   for every t of at most p vertices,
// and for a dense output, with weights b_i(x), that the sum is x^|t| / gamma(t).
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "catch.hpp"
#include "integrate/dop853_tableau.hpp"
#include "integrate/tableau.hpp"

namespace {

using rotor::kDop853Tableau, rotor::kRk4Tableau;
using Real = long double;

/// A rooted tree: `branch` grafted to the root of `stem`, both indices of earlier trees. The
/// branches of a root are grafted in the order of their indices, so that every tree occurs once.
struct Tree {
  int order;  ///< |t|, the vertices
  int stem;   ///< -1 for the single vertex
  int branch;
  Real gamma;  ///< |t| times the product of the gammas of the branches
};

constexpr int kOrders = 9;

std::vector<Tree> make_trees() {
  std::vector<Tree> trees = {{1, -1, -1, 1}};
  for (int order = 2; order <= kOrders; ++order) {
    const std::vector<Tree> known = trees;
    for (int s = 0; const Tree& stem : known) {
      for (int b = 0; const Tree& branch : known) {
        if (stem.order + branch.order == order && b >= stem.branch)
          trees.push_back({order, s, b, order * (stem.gamma / stem.order) * branch.gamma});
        ++b;
      }
      ++s;
    }
  }
  return trees;
}

const std::vector<Tree> kTrees = make_trees();

/// A number known to `error` at most, through sums and products.
struct Bounded {
  Real value = 0;
  Real error = 0;
  Bounded() = default;
  Bounded(Real exact) : value(exact) {}
  Bounded(Real v, Real e) : value(v), error(e) {}
};

/// An operation's own rounding is half an epsilon; the other half is for 1/gamma and the errors.
Real rounding(Real value) { return std::numeric_limits<Real>::epsilon() * std::abs(value); }

Bounded operator+(Bounded x, Bounded y) {
  const Real sum = x.value + y.value;
  return {sum, x.error + y.error + rounding(sum)};
}
Bounded operator-(Bounded x, Bounded y) { return x + Bounded(-y.value, y.error); }
Bounded operator*(Bounded x, Bounded y) {
  const Real product = x.value * y.value;
  return {product, std::abs(x.value) * y.error + std::abs(y.value) * x.error + x.error * y.error +
                       rounding(product)};
}

/// A coefficient: its published value, a fraction or 25 digits and more, rounded to double.
Bounded coefficient(double x) {
  return {x, std::numeric_limits<double>::epsilon() / 2 * std::abs(static_cast<Real>(x))};
}

using Row = std::vector<Bounded>;
using Rows = std::vector<Row>;

Bounded sum_of_products(const Row& x, const Row& y) {
  Bounded sum;
  for (std::size_t i = 0; i < x.size(); ++i) sum = sum + x[i] * y[i];
  return sum;
}

/// Phi_i(t), by tree and stage: the product of sum_j a_ij Phi_j(t') over the branches t' of t.
Rows elementary_weights(const Rows& a) {
  Rows phi;
  for (const Tree& tree : kTrees) {
    Row row(a.size(), Bounded(1));
    if (tree.stem >= 0) {
      const Row& stem = phi[static_cast<std::size_t>(tree.stem)];
      const Row& branch = phi[static_cast<std::size_t>(tree.branch)];
      for (std::size_t i = 0; i < a.size(); ++i) row[i] = stem[i] * sum_of_products(a[i], branch);
    }
    phi.push_back(row);
  }
  return phi;
}

/// By order (index), the largest |sum_i b_i Phi_i(t) - x^|t| / gamma(t)| of its trees in units of
/// the error that the rounding of the coefficients allows. At most 1: the conditions hold.
std::array<Real, kOrders + 1> defects(const Rows& a, const Row& b, Real x = 1) {
  std::array<Real, kOrders + 1> worst{};
  const Rows phi = elementary_weights(a);
  for (std::size_t t = 0; t < kTrees.size(); ++t) {
    const int order = kTrees[t].order;
    const Bounded defect =
        sum_of_products(b, phi[t]) - Bounded(std::pow(x, order) / kTrees[t].gamma);
    Real& largest = worst[static_cast<std::size_t>(order)];
    largest = std::max(largest, std::abs(defect.value) / defect.error);
  }
  return worst;
}

/// Order p: all the conditions to p, and one of p + 1 fails by far more than rounding.
void check_order(int p, const std::array<Real, kOrders + 1>& worst) {
  for (int order = 1; order <= p + 1; ++order) {
    const Real defect = worst[static_cast<std::size_t>(order)];
    CAPTURE(order, defect);
    if (order <= p)
      CHECK(defect <= 1);
    else
      CHECK(defect > 1e6L);
  }
}

template <std::size_t N>
Row row(const std::array<double, N>& numbers, std::size_t size) {
  Row result(size);
  std::transform(numbers.begin(), numbers.end(), result.begin(), coefficient);
  return result;
}

template <std::size_t N>
Rows rows(const std::array<std::array<double, N>, N>& matrix) {
  Rows result;
  for (const auto& numbers : matrix) result.push_back(row(numbers, N));
  return result;
}

constexpr std::size_t kStages = 16;  // of DOP853 with its dense output

Rows dop853_rows() {
  Rows a;
  for (const auto& numbers : kDop853Tableau.a) a.push_back(row(numbers, kStages));
  a.push_back(row(kDop853Tableau.b, kStages));
  for (const auto& numbers : rotor::kDop853DenseA) a.push_back(row(numbers, kStages));
  return a;
}

/// The weights b_i(x) of the dense output y(t0 + x h) = y0 + h sum_i b_i(x) k_i.
Row dense_weights(Real x) {
  const Row b = row(kDop853Tableau.b, kStages);
  Row weights(kStages);
  for (std::size_t i = 0; i < kStages; ++i) {
    const Bounded first(i == 0), last(i == 12);
    std::vector<Bounded> f = {b[i], first - b[i], Bounded(2) * b[i] - (first + last)};
    for (const auto& numbers : rotor::kDop853DenseD) f.push_back(coefficient(numbers[i]));
    for (std::size_t m = f.size(); m-- > 0;)
      weights[i] = (weights[i] + f[m]) * Bounded(m % 2 == 0 ? x : 1 - x);
  }
  return weights;
}

/// c_i = sum_j a_ij, and a_ij = 0 for j >= i.
void check_rows(const Rows& a, const std::vector<double>& c) {
  REQUIRE(a.size() == c.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    CAPTURE(i);
    const Bounded defect = sum_of_products(a[i], Row(a.size(), Bounded(1))) - coefficient(c[i]);
    CHECK(std::abs(defect.value) <= defect.error);
    for (std::size_t j = i; j < a.size(); ++j) CHECK(a[i][j].value == 0);
  }
}

}  // namespace

TEST_CASE("the rooted trees of each order are all there") {
  std::array<int, kOrders + 1> count{};
  for (const Tree& tree : kTrees) ++count[static_cast<std::size_t>(tree.order)];
  CHECK(count == std::array{0, 1, 1, 2, 4, 9, 20, 48, 115, 286});
}

TEST_CASE("the rows of the tableaus sum to the nodes") {
  check_rows(rows(kRk4Tableau.a), {kRk4Tableau.c.begin(), kRk4Tableau.c.end()});
  std::vector<double> c(kDop853Tableau.c.begin(), kDop853Tableau.c.end());
  c.push_back(1);
  c.insert(c.end(), rotor::kDop853DenseC.begin(), rotor::kDop853DenseC.end());
  check_rows(dop853_rows(), c);
}

TEST_CASE("the classical method is of order 4") {
  check_order(kRk4Tableau.order, defects(rows(kRk4Tableau.a), row(kRk4Tableau.b, 4)));
  CHECK(kRk4Tableau.order == 4);
}

TEST_CASE("DOP853 is of order 8") {
  check_order(kDop853Tableau.order, defects(dop853_rows(), row(kDop853Tableau.b, kStages)));
  CHECK(kDop853Tableau.order == 8);
}

TEST_CASE("the comparison methods of DOP853 are of orders 5 and 3") {
  const Row b = row(kDop853Tableau.b, kStages);
  const auto comparison = [&b](const std::array<double, 12>& error) {
    Row weights = row(error, kStages);
    for (std::size_t i = 0; i < kStages; ++i) {
      weights[i].error *= 2;  // may be a difference of two rounded numbers
      weights[i] = b[i] - weights[i];
    }
    return weights;
  };
  check_order(5, defects(dop853_rows(), comparison(rotor::kDop853Error5)));
  check_order(3, defects(dop853_rows(), comparison(rotor::kDop853Error3)));
}

// Both sides of a condition are polynomials in x of degree 7 at most, zero at x = 0: if they agree
// at seven more points they agree everywhere. The eighths and their powers are exact.
TEST_CASE("the dense output of DOP853 is of order 7") {
  for (int eighths = 1; eighths < 8; ++eighths) {
    CAPTURE(eighths);
    const Real x = eighths / 8.0L;
    check_order(7, defects(dop853_rows(), dense_weights(x), x));
  }
}

TEST_CASE("the dense output of DOP853 ends at the step's own weights") {
  const Row end = dense_weights(1);
  const Row b = row(kDop853Tableau.b, kStages);
  for (std::size_t i = 0; i < kStages; ++i) CHECK(end[i].value == b[i].value);
}
