#include "spin/derivatives.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "rotation/extended.hpp"

namespace rotor {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kNodes = 12;
constexpr std::size_t kCount = Derivatives::kCount;

Derivatives from_jets(const VectorJet& jets, double t) {
  Derivatives result;
  for (std::size_t k = 0; k < kCount; ++k) {
    for (int i = 0; i < 3; ++i) result.c[k](i) = jets[static_cast<std::size_t>(i)].c[k];
  }
  // A rounding of each, and of t.
  for (std::size_t k = 0; k < kCount; ++k) {
    const double slope = k + 1 < kCount ? static_cast<double>(k + 1) * norm(result.c[k + 1]) : 0;
    result.error[k] = kEpsilon * (4 * norm(result.c[k]) + std::abs(t) * slope);
  }
  return result;
}

using Square = Eigen::Matrix<Extended, kNodes, kNodes>;
using Column = Eigen::Matrix<Extended, kNodes, 1>;
using Values = Eigen::Matrix<Extended, kNodes, 3>;

// The Chebyshev nodes on [-1, 1], and the matrix that turns values there into the coefficients of
// the powers of x.
struct Interpolation {
  Column nodes;
  Square powers;
};
const Interpolation& interpolation() {
  static const Interpolation result = [] {
    Interpolation made;
    Square vandermonde;
    for (int i = 0; i < kNodes; ++i) {
      made.nodes(i) = std::cos(std::numbers::pi_v<Extended> * (2 * i + 1) / (2 * kNodes));
      Extended power = 1;
      for (int k = 0; k < kNodes; ++k, power *= made.nodes(i)) vandermonde(i, k) = power;
    }
    made.powers = vandermonde.inverse();
    return made;
  }();
  return result;
}

// The polynomial on [low, high], about t: (x0 + s/half)^k has the powers of s.
Derivatives from_values(const AngularVelocity& omega, double t, double low, double high) {
  const Interpolation& rule = interpolation();
  const Extended middle = (Extended{low} + high) / 2;
  const Extended half = (Extended{high} - low) / 2;
  Values values;
  Column rounding;
  double least = kInfinity;
  double most = 0;
  for (int i = 0; i < kNodes; ++i) {
    const auto place = static_cast<double>(middle + half * rule.nodes(i));
    const Vector value = omega(place);
    values.row(i) = value.transpose().cast<Extended>();
    rounding(i) = 4 * kEpsilon * norm(value);
    least = std::min(least, norm(value));
    most = std::max(most, norm(value));
  }
  // An ulp of t, at the mean rate at which omega changes there.
  rounding.array() +=
      kEpsilon * (most - least) * std::max(std::abs(low), std::abs(high)) / (2 * half);
  Square about = Square::Zero();  // row k: of c[k] half^k, by the powers of x
  const Extended x0 = (t - middle) / half;
  for (int n = 0; n < kNodes; ++n) {
    Extended binomial = 1;
    for (int k = n; k >= 0; --k) {  // n over k, x0^(n - k)
      about(k, n) = binomial;
      binomial = binomial * x0 * k / (n - k + 1);
    }
  }
  const Square to_coefficients = about * rule.powers;
  const Values coefficients = to_coefficients * values;
  const Column noise = to_coefficients.cwiseAbs() * rounding;
  // Twelve values make a polynomial of anything; a jump or a kink at t shows between its nodes.
  constexpr Extended kBetween = 0.05L;  // of half
  Extended miss = 0;
  for (const Extended x : {-kBetween, kBetween}) {
    const auto place = static_cast<double>(t + half * x);
    if (place < low || place > high) continue;
    Eigen::Matrix<Extended, 1, 3> foretold = coefficients.row(kNodes - 1);
    const Extended at = (Extended{place} - t) / half;
    for (int k = kNodes - 1; k-- > 0;) foretold = foretold * at + coefficients.row(k);
    const Vector value = omega(place);
    miss = std::max(miss, (value.transpose().cast<Extended>() - foretold).norm());
  }
  Derivatives result;
  Extended scale = 1;
  for (std::size_t k = 0; k < kCount; ++k, scale /= half) {
    const auto row = static_cast<int>(k);
    result.c[k] = (scale * coefficients.row(row)).transpose().cast<double>();
    const Extended missed = miss / std::pow(kBetween, static_cast<Extended>(k));
    result.error[k] = static_cast<double>(scale * (noise(row) + missed));
  }
  return result;
}

// For each coefficient the distance at which it differs least from that of the next longer one.
// What is a derivative is found at all shorter distances too, but for the noise there.
Derivatives by_differences(const AngularVelocity& omega, double t, double low, double high) {
  constexpr int kDistances = 32;
  constexpr std::size_t kWitnesses = 4;  // shorter distances that have to bear it out
  constexpr double kNoise = 16;          // omega may well round more often than once
  std::vector<Derivatives> levels;
  double reach = (high - low) / 2;
  for (int i = 0; i < kDistances && reach > 1e6 * kEpsilon * std::abs(t); ++i, reach /= 2) {
    levels.push_back(from_values(omega, t, std::max(low, t - reach), std::min(high, t + reach)));
  }
  Derivatives best;
  best.c.fill(Vector::Zero());
  best.error.fill(kInfinity);
  for (std::size_t k = 0; k < kCount; ++k) {
    const auto apart = [&](std::size_t i, std::size_t j) {
      return norm(Vector(levels[i].c[k] - levels[j].c[k]));
    };
    std::size_t chosen = 0;
    for (std::size_t i = 1; i + kWitnesses < levels.size(); ++i) {
      const double error = apart(i, i - 1) + levels[i].error[k];
      if (!(error < best.error[k])) continue;
      best.c[k] = levels[i].c[k];
      best.error[k] = error;
      chosen = i;
    }
    for (std::size_t i = chosen + 1; i < levels.size(); ++i) {
      best.error[k] = std::max(best.error[k], apart(i, chosen) - kNoise * levels[i].error[k]);
    }
  }
  return best;
}

}  // namespace

bool Derivatives::differs_from_zero(std::size_t k) const { return norm(c[k]) > 4 * error[k]; }

Derivatives derivatives_at(const AngularVelocity& omega, double t, double low, double high) {
  std::string no_jets;
  try {
    return from_jets(omega.jet(t), t);
  } catch (const NotDifferentiable& why) {
    no_jets = why.what();
  }
  Derivatives result;
  result.c.fill(Vector::Zero());
  result.error.fill(kInfinity);
  try {
    if (low < high) result = by_differences(omega, t, low, high);
  } catch (const NonFiniteOmega&) {
    result.error.fill(kInfinity);
  }
  result.no_jets = no_jets;
  return result;
}

}  // namespace rotor
