#include "integrate/panel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "integrate/fgl_kernel.hpp"
#include "integrate/fgl_samples.hpp"
#include "integrate/fgl_tables.hpp"
#include "integrate/gauss_tables.hpp"
#include "integrate/loop.hpp"

namespace rotor {
namespace {

constexpr std::size_t kHalf = Panel::kNodes / 2;
constexpr double kUnit = std::numeric_limits<double>::epsilon() / 2;

constexpr std::array<Node, Panel::kNodes> kPlaces = both_sides(kGauss64Nodes);

// Matrices for FglKernel::parity_product: from values to the terms of the series, and to slopes.
struct PanelTables {
  std::array<std::array<double, kHalf * kHalf>, 2> terms;
  std::array<std::array<double, kHalf * kHalf>, 2> slopes;
};

PanelTables make_tables() {
  PanelTables tables{};
  std::array<double, kHalf> weight{};  // barycentric, up to sign and a factor
  for (std::size_t j = 0; j < kHalf; ++j) {
    const auto x = static_cast<double>(kGauss64Nodes[j]);
    weight[j] = (j % 2 == 0 ? 1 : -1) * std::sqrt((1 - x * x) * kGauss64Weights[j]);
    const auto p = legendre<Panel::kNodes>(kGauss64Nodes[j]);
    for (std::size_t n = 0; n < Panel::kNodes; ++n) {
      tables.terms[n % 2][kHalf * j + n / 2] =
          static_cast<double>(static_cast<Extended>(2 * n + 1) / 2 * kGauss64Weights[j] * p[n]);
    }
  }
  // l_j'(x_i) = (b_j/b_i)/(x_i - x_j), and x/(1 - x^2) for j = i; b changes sign between
  // neighbours, so between x_j and -x_j as well.
  for (std::size_t i = 0; i < kHalf; ++i) {
    const auto x = static_cast<double>(kGauss64Nodes[i]);
    for (std::size_t j = 0; j < kHalf; ++j) {
      const auto y = static_cast<double>(kGauss64Nodes[j]);
      const double ratio = weight[j] / weight[i];
      const double same = i == j ? x / (1 - x * x) : ratio / (x - y);
      const double other = -ratio / (x + y);
      tables.slopes[0][kHalf * j + i] = (same + other) / 2;
      tables.slopes[1][kHalf * j + i] = (same - other) / 2;
    }
  }
  return tables;
}

const PanelTables& panel_tables() {
  static const PanelTables tables = make_tables();
  return tables;
}

// The derivatives by z of the interpolants.
PanelTerms rates_at_nodes(const PanelTerms& values) {
  const PanelTables& tables = panel_tables();
  PanelTerms parts;
  fgl_kernel().parity_product(tables.slopes[0].data(), tables.slopes[1].data(), values, parts);
  PanelTerms rates;
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t i = 0; i < kHalf; ++i) {
      rates[c][i] = parts[c][i] + parts[c][kHalf + i];
      rates[c][kHalf + i] = parts[c][kHalf + i] - parts[c][i];
    }
  }
  return rates;
}

// The root mean square of the sizes of the terms from `begin` to `end`, where they are of the order
// of `unit`.
double mean_size(const Panel::Coefficients& c, std::size_t begin, std::size_t end, double unit) {
  if (unit == 0) return 0;
  double squares = 0;
  for (std::size_t n = begin; n < end; ++n) {
    for (const auto& component : c) {
      const double term = component[n] / unit;
      squares += term * term / static_cast<double>(2 * n + 1);
    }
  }
  return unit * std::sqrt(squares / static_cast<double>(end - begin));
}

// The last eight terms, and the eight before them.
constexpr std::size_t kLast = Panel::kNodes - 8;
constexpr std::size_t kBefore = Panel::kNodes - 16;

// Over a jump or a bend the terms rise and fall, and may have fallen by chance.
constexpr double kRough = 32;

}  // namespace

double Panel::time(std::size_t i) const {
  if (i >= kNodes) return i == kNodes ? begin_ : end_;
  return Stretch(begin_, end_).time(kPlaces[i]);
}

void Panel::set(const Samples& samples) {
  PanelTerms values;  // less the first: a constant leaves no rounding behind
  for (std::size_t i = 0; i < kNodes; ++i) {
    const Vector value = samples[i] - samples[0];
    for (std::size_t c = 0; c < 3; ++c) values[c][i] = value(static_cast<Eigen::Index>(c));
    greatest_ = std::max(greatest_, std::sqrt(3.0) * samples[i].cwiseAbs().maxCoeff());
  }
  // The nodes were rounded to doubles: a sample is off by its slope times that, to first order. Far
  // from t = 0 the slopes themselves are the better for it.
  const Stretch stretch(begin_, end_);
  std::array<double, kNodes> late;
  double latest = 0;
  for (std::size_t i = 0; i < kNodes; ++i) {
    late[i] = stretch.late(kPlaces[i]);
    latest = std::max(latest, std::abs(late[i]));
  }
  const PanelTerms given = values;
  PanelTerms rates;
  for (int pass = 0; pass < (latest > 1e-9 ? 3 : 1); ++pass) {
    rates = rates_at_nodes(values);
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t i = 0; i < kNodes; ++i) values[c][i] = given[c][i] - late[i] * rates[c][i];
    }
  }
  double steepest = 0;
  double along = 0;
  double squares = 0;
  for (std::size_t i = 0; i < kNodes; ++i) {
    const Vector rate(rates[0][i], rates[1][i], rates[2][i]);
    steepest = std::max(steepest, rate.cwiseAbs().maxCoeff());
    if (greatest_ == 0) continue;
    const Vector value = samples[i] / greatest_;
    const Vector relative = rate / greatest_;
    squares += relative.squaredNorm();
    if (value.squaredNorm() > 0) along += std::pow(relative.dot(value), 2) / value.squaredNorm();
  }
  if (squares > 0) along_ = along / squares;
  PanelTerms terms;
  const PanelTables& tables = panel_tables();
  fgl_kernel().parity_product(tables.terms[0].data(), tables.terms[1].data(), values, terms);
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t n = 0; n < kNodes; ++n) {
      coefficients_[c][n] = terms[c][kHalf * (n % 2) + n / 2];
    }
    coefficients_[c][0] += samples[0](static_cast<Eigen::Index>(c));
  }
  judge(samples[kNodes], samples[kNodes + 1], steepest);
}

// The terms of the series are taken to go on falling as they last did, by the same factor.
void Panel::judge(const Vector& at_begin, const Vector& at_end, double steepest) {
  const double before = mean_size(coefficients_, kBefore, kLast, greatest_);
  const double last = mean_size(coefficients_, kLast, kNodes, greatest_);
  // Noise of standard deviation s in each sample gives each term the size s/8 or a little more; the
  // sums that make the terms round too.
  const double late =
      kUnit * std::max(std::abs(begin_), std::abs(end_)) / std::abs(end_ / 2 - begin_ / 2);
  if (greatest_ > 0) aside_ = std::pow(late * steepest, 2) / (3 * greatest_);
  const double expected = kUnit * greatest_ + (steepest == 0 ? 0 : late * steepest / 4);
  noise_ = mean_size(coefficients_, kNodes - 4, kNodes, greatest_);
  if (noise_ > 4 * expected ||
      noise_ < mean_size(coefficients_, kLast, kNodes - 4, greatest_) / 4) {
    // They still fall: no noise as large as that, and an error.
    noise_ = std::min(mean_size(coefficients_, kNodes - 2, kNodes, greatest_), expected);
    const double fall = std::clamp(std::pow(last / before, 1.0 / 8), 0.1, 0.98);
    error_ =
        (1 + kRough * std::pow(fall, 8)) * last * std::pow(fall, 4.5) / std::sqrt(1 - fall * fall);
  }
  // At the ends all terms that are left out add up; by more than that a value there is off only
  // where f jumps or bends near the end: in 1/2000 of the panel, between the end and a node, or the
  // error would show otherwise.
  const double off = std::max(norm(at(-1) - at_begin), norm(at(1) - at_end));
  if (off > 128 * (std::max(error_, noise_) + expected)) error_ = std::max(error_, off / 1024);
}

Vector Panel::at(double z) const {
  // Clenshaw's recurrence for P_(n+1) = (2 n + 1)/(n + 1) z P_n - n/(n + 1) P_(n-1).
  Vector sum;
  for (std::size_t c = 0; c < 3; ++c) {
    double b1 = 0;
    double b2 = 0;
    for (std::size_t n = kNodes; n-- > 0;) {
      const auto k = static_cast<double>(n);
      const double b =
          coefficients_[c][n] + (2 * k + 1) / (k + 1) * z * b1 - (k + 1) / (k + 2) * b2;
      b2 = b1;
      b1 = b;
    }
    sum(static_cast<Eigen::Index>(c)) = b1;
  }
  return sum;
}

bool Panel::is_constant() const {
  return std::all_of(coefficients_.begin(), coefficients_.end(), [](const auto& c) {
    return std::all_of(c.begin() + 1, c.end(), [](double term) { return term == 0; });
  });
}

ExtendedVector Panel::integral(Extended z) const {
  if (is_constant()) {
    const ExtendedVector f(coefficients_[0][0], coefficients_[1][0], coefficients_[2][0]);
    return f * ((z + 1) * ((Extended{end_} - Extended{begin_}) / 2));
  }
  // The integral of P_n is (P_(n+1) - P_(n-1))/(2 n + 1), 0 at -1; that of P_0 is z + 1.
  const auto p = legendre<kNodes + 1>(z);
  ExtendedVector sum = ExtendedVector::Zero();
  for (std::size_t c = 0; c < 3; ++c) {
    Extended& s = sum(static_cast<Eigen::Index>(c));
    for (std::size_t n = kNodes; n-- > 1;) {
      s += coefficients_[c][n] * (p[n + 1] - p[n - 1]) / static_cast<Extended>(2 * n + 1);
    }
    s += coefficients_[c][0] * (z + 1);
  }
  return sum * ((Extended{end_} - Extended{begin_}) / 2);
}

double Panel::length_factor(double allowed) const {
  const double target = std::max(allowed / 4, 4 * noise_);
  std::size_t n = kNodes;
  while (n > 0 && mean_size(coefficients_, n - 1, n, greatest_) <= target) --n;
  auto degree = static_cast<double>(n);
  if (error_ > allowed) {
    const double last = mean_size(coefficients_, kLast, kNodes, greatest_);
    if (last == 0) return 0.1;
    const double fall = std::log(mean_size(coefficients_, kBefore, kLast, greatest_) / last);
    degree = kNodes + 8 * std::log(std::max(error_, last) / target) / std::max(fall, 0.1);
  }
  return std::clamp(60 / (degree + 2), 0.1, 16.0);
}

bool PanelLengths::accept(const Panel& panel, double allowed) {
  const double length = std::abs(panel.end() - panel.begin());
  const bool accepted = length * panel.error() <= allowed;
  const double factor = panel.length_factor(allowed / length);
  const double most = accepted ? (after_rejection_ ? 1.0 : 16.0) : 0.7;
  length_ = std::min(length * std::min(factor, most), longest_);
  // The shortest is tried before the run is given up, and after one that a break made shorter.
  const double shortest = shortest_step(panel.begin());
  if (accepted || length > 2 * shortest) length_ = std::max(length_, 1.5 * shortest);
  after_rejection_ = !accepted;
  return accepted;
}

}  // namespace rotor
