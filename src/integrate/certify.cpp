#include "integrate/certify.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "integrate/sampler.hpp"
#include "rotation/quaternion.hpp"
#include "rotation/text.hpp"

namespace rotor {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr int kDeepest = 12;        // halvings of an interval: what omega may do within it
constexpr double kResolved = 1e-4;  // of the integral of the norm: what its points may miss
// What the generator of a dense output, the derivative of a polynomial of degree 17 whose terms are
// rounded, makes of that rounding: 17^2 of it, and up to twice that for its own. It is noise, of
// which the integral keeps none.
constexpr double kDifferentiated = 512 * kEpsilon;
constexpr double kShortReach =
    1e-9;  // of an interval: how far a jump is looked at from either side

// Gauss and Legendre on [-1, 1].
struct GaussRule {
  Eigen::VectorXd nodes;
  Eigen::VectorXd weights;
  Eigen::MatrixXd coefficients;  // times values at the nodes: of P_0 ... P_(n-1)
  Eigen::MatrixXd integrals;     // times values: from -1 to 2n even places, the last of them 1
};

// P_0 ... P_n at x.
Eigen::VectorX<Extended> legendre(Eigen::Index n, Extended x) {
  Eigen::VectorX<Extended> p(n + 1);
  p(0) = 1;
  p(1) = x;
  for (Eigen::Index k = 1; k < n; ++k) {
    const auto m = static_cast<Extended>(k);
    p(k + 1) = ((2 * m + 1) * x * p(k) - m * p(k - 1)) / (m + 1);
  }
  return p;
}

GaussRule gauss_rule(Eigen::Index n) {
  GaussRule rule{Eigen::VectorXd(n), Eigen::VectorXd(n), Eigen::MatrixXd(n, n), {}};
  const auto degree = static_cast<Extended>(n);
  const auto derivative = [&](Extended x) {  // (1 - x^2) P_n' = n (P_(n-1) - x P_n)
    const Eigen::VectorX<Extended> p = legendre(n, x);
    return degree * (p(n - 1) - x * p(n)) / (1 - x * x);
  };
  Eigen::MatrixXd values(n, n);  // of P_k at node j
  for (Eigen::Index j = 0; j < n; ++j) {
    // Newton's method from a guess good to O(n^-3).
    Extended x = -std::cos(std::numbers::pi_v<Extended> * (static_cast<Extended>(j) + 0.75L) /
                           (degree + 0.5L));
    for (int i = 0; i < 6; ++i) x -= legendre(n, x)(n) / derivative(x);
    rule.nodes(j) = static_cast<double>(x);
    rule.weights(j) = static_cast<double>(2 / ((1 - x * x) * derivative(x) * derivative(x)));
    values.col(j) = legendre(n, x).head(n).cast<double>();
  }
  for (Eigen::Index k = 0; k < n; ++k) {
    const double half = static_cast<double>(2 * k + 1) / 2;
    rule.coefficients.row(k) = half * values.row(k).cwiseProduct(rule.weights.transpose());
  }
  // The integral of P_k from -1 to x is (P_(k+1) - P_(k-1)) / (2k + 1), of P_0 it is x + 1.
  Eigen::MatrixXd of_legendre(2 * n, n);
  for (Eigen::Index i = 0; i < 2 * n; ++i) {
    const Extended x = static_cast<Extended>(i + 1) / degree - 1;
    const Eigen::VectorXd p = legendre(n, x).cast<double>();
    of_legendre(i, 0) = static_cast<double>(x + 1);
    for (Eigen::Index k = 1; k < n; ++k) {
      of_legendre(i, k) = (p(k + 1) - p(k - 1)) / static_cast<double>(2 * k + 1);
    }
  }
  rule.integrals = of_legendre * rule.coefficients;
  return rule;
}

class Measurement {
 public:
  Measurement(const Flow& flow, const AngularVelocity& omega, std::vector<double> breaks,
              std::size_t n)
      : flow_(flow),
        generator_(omega, cost_, std::move(breaks)),
        rule_(gauss_rule(static_cast<Eigen::Index>(n))),
        defect_(rule_.nodes.size(), 3) {}

  // The mesh interval from a to b.
  void interval(double a, double b, bool first) {
    if (a == b) return;  // of a run of no length
    const double reach = kShortReach * (b - a);
    if (!first) jump(a, reach);
    jump(a + (b - a) / 2, reach);
    for (double t = a; t != b;) {
      const double next = generator_.clip(t, b);
      settle(look(t, next), 0);
      t = next;
    }
  }

  // The error so far, as a rotation vector seen from the body that U~ moves.
  const Vector& integral() const { return integral_; }
  double greatest() const { return greatest_; }
  double bound() const { return bound_; }
  double rounding() const { return rounding_.estimate() + alike_; }
  std::size_t omega_calls() const { return cost_.omega_calls; }

 private:
  // What the computed motion turns by at t itself: from just before to just after, less what its
  // generator accounts for. `reach` has the sign of the motion.
  void jump(double t, double reach) {
    const double forward = std::copysign(std::numeric_limits<double>::infinity(), reach);
    const double after = t + reach == t ? std::nextafter(t, forward) : t + reach;
    const double before = t - reach == t ? std::nextafter(t, -forward) : t - reach;
    const Quaternion turned = flow_.at(after) * flow_.at(before).conjugate();
    const Vector known =
        (t - before) * flow_.generator(before) + (after - t) * flow_.generator(after);
    const Vector turn = 2 * log(turned).vec() - known;
    add(flow_.at(t).conjugate() * turn);
    bound_ += norm(turn);
  }

  // What the points between a and b see.
  struct Look {
    double a;
    double b;
    Eigen::MatrixX3d partial;  // the error from a to even places
    double size;               // the integral of |g~ - g|
    double missed;             // what the points may not see
    double rate;               // the greatest |g|
    double rounded;            // what rounding omega and its argument may do, as a half-width

    double middle() const { return a + (b - a) / 2; }
    bool can_be_halved() const { return middle() != a && middle() != b; }
  };

  Look look(double a, double b) {
    Look seen{a, b, {}, 0, 0, 0, 0};
    Vector first;
    Vector last;
    const double half = (b - a) / 2;
    for (Eigen::Index i = 0; i < rule_.nodes.size(); ++i) {
      const double t = seen.middle() + half * rule_.nodes(i);
      const Vector generator = generator_(t);
      const Vector defect = half * (flow_.generator(t) - generator);
      defect_.row(i) = (flow_.at(t).conjugate() * defect).transpose();
      seen.size += rule_.weights(i) * norm(defect);
      seen.rate = std::max(seen.rate, norm(generator));
      if (i == 0) first = generator;
      last = generator;
    }
    seen.rounded = RoundingError::of_step(b, b - a, first, last);
    const Eigen::MatrixX3d terms = rule_.coefficients * defect_;
    // A jump between an end and the node next to it shows at that end alone.
    const double at_ends = off_at(std::nextafter(a, b), half, -1, terms) +
                           off_at(std::nextafter(b, a), half, 1, terms);
    seen.missed = std::max(unresolved(terms), (1 + rule_.nodes(0)) * at_ends);
    seen.partial = rule_.integrals * defect_;
    return seen;
  }

  // By how much the defect at an end z = -1 or 1 is not what its Legendre series makes it there.
  double off_at(double t, double half, double z, const Eigen::MatrixX3d& terms) {
    Vector off = flow_.at(t).conjugate() * (half * (flow_.generator(t) - generator_(t)));
    for (Eigen::Index k = 0; k < terms.rows(); ++k) {
      off -= (k % 2 == 0 ? 1 : z) * terms.row(k).transpose();
    }
    return norm(off);
  }

  // Halves the interval until its points resolve it.
  void settle(const Look& seen, int depth) {
    const bool resolved = seen.missed <= std::max(kResolved * seen.size, kDifferentiated);
    if (resolved || depth == kDeepest || !seen.can_be_halved()) {
      take(seen, std::min(seen.rounded, noise_of(seen)));
      if (resolved) return;
      bound_ += seen.missed;
      rounding_.add(seen.missed, 1);
      return;
    }
    const Look first = look(seen.a, seen.middle());
    const Look second = look(seen.middle(), seen.b);
    // Noise, small beside omega, falls as the interval in both halves, a jump in one of them, what
    // is smooth faster.
    if (depth > 1 && seen.missed < 1e-4 * std::abs(seen.b - seen.a) * seen.rate &&
        std::min(first.missed, second.missed) > seen.missed / 4) {
      take(first, noise_of(first));
      take(second, noise_of(second));
      bound_ += first.missed + second.missed;
    } else {
      settle(first, depth + 1);
      settle(second, depth + 1);
    }
  }

  // If what the points do not resolve is noise, the half-width that makes the error of the
  // integral. Of standard deviation s in each component it makes terms of degree k of the size
  // s sqrt((2k + 1)/n), and `missed` of 2.6 s sqrt(n) of them; the square sum of the weights is
  // 4.1/n, so the integral is off by 3.5 s/sqrt(n), 1.4/n times that, and that of the motion, on
  // other samples, as well. (A half-width is sqrt(3) standard deviations.)
  double noise_of(const Look& seen) const {
    return std::numbers::sqrt3 * 1.4 / static_cast<double>(rule_.nodes.size()) * seen.missed;
  }

  void take(const Look& seen, double noise) {
    for (const auto& row : seen.partial.rowwise()) {
      greatest_ = std::max(greatest_, norm(integral_ + row.transpose()));
    }
    add(seen.partial.bottomRows(1).transpose());
    bound_ += seen.size;
    const double turn = std::abs(seen.b - seen.a) * seen.rate;
    turned_ += turn;
    rounding_.add(noise + 4 * kEpsilon * std::min(1.0, turned_), 1);  // at random, of 18 terms
    // A generator and an omega that do not change may be rounded alike all the way.
    alike_ += kEpsilon * turn;
  }

  void add(const Vector& turn) {
    integral_ += turn;
    greatest_ = std::max(greatest_, norm(integral_));
  }

  // What n points do not see has degree 2n or more. The size of the last third of the coefficients
  // is carried on to there, by the factor at which it has fallen from the third before. (Twice
  // both: they are not known so well.)
  static double unresolved(const Eigen::MatrixX3d& c) {
    const Eigen::Index third = c.rows() / 3;
    const double last = c.bottomRows(third).norm();
    const double before = c.middleRows(c.rows() - 2 * third, third).norm();
    const double factor = 2 * last < before ? 2 * last / before : 1;
    return 2 * last * std::pow(factor, 3.5);
  }

  const Flow& flow_;
  Cost cost_;
  Sampler generator_;
  GaussRule rule_;
  Eigen::MatrixX3d defect_;  // half the interval's length times R~^T (g~ - g), at the nodes
  Vector integral_ = Vector::Zero();
  double greatest_ = 0;
  double bound_ = 0;
  RoundingError rounding_;
  double alike_ = 0;
  double turned_ = 0;
};

void check(const CertifyOptions& options) {
  if (options.n < 3 || options.n > 64) {
    throw std::invalid_argument("n: expected 3 to 64 points an interval, got " +
                                std::to_string(options.n));
  }
  for (const auto& [name, value] : {std::pair{"noise", options.noise}, {"bias", options.bias}}) {
    if (!(value >= 0) || !std::isfinite(value)) {
      throw std::invalid_argument(std::string(name) +
                                  ": expected a bound in rad per unit of t, 0 or more, got " +
                                  text(value));
    }
  }
}

}  // namespace

Certificate certify(const Flow& flow, const AngularVelocity& omega, const CertifyOptions& options,
                    const Observer& observer) {
  check(options);
  const std::vector<double> mesh = flow.mesh();
  const auto [low, high] = std::minmax(mesh.front(), mesh.back());
  Measurement measurement(flow, omega, omega.breaks(low, high), options.n);
  for (std::size_t i = 0; i + 1 < mesh.size(); ++i) {
    if (observer && !observer(mesh[i])) throw Interrupted();
    measurement.interval(mesh[i], mesh[i + 1], i == 0);
  }
  Certificate result;
  result.rounding = measurement.rounding();
  result.at_rounding = measurement.greatest() <= result.rounding;
  result.estimate = std::max(measurement.greatest(), result.rounding);
  result.bound =
      measurement.bound() + result.rounding + (options.noise + options.bias) * (high - low);
  result.error = flow.at(mesh.back()) * measurement.integral();
  if (omega.frame() == Frame::kBody) result.error = -result.error;
  result.omega_calls = measurement.omega_calls();
  return result;
}

}  // namespace rotor
