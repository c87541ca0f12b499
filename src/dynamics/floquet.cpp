#include "dynamics/floquet.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "dynamics/fft.hpp"
#include "rotation/text.hpp"
#include "spin/models.hpp"

namespace rotor {
namespace {

using Complex = std::complex<double>;

constexpr double kTwoPi = 2 * std::numbers::pi;
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

// The lines p_j of U(t) = sum p_j exp(b 2 pi (f + j/T) t) as |p_j|^2: of P, which has n samples
// over the period. Multiplication by b from the right is an i for the quaternions, of which 1 and a
// unit c across b are a basis: x = z1 + c z2.
std::vector<double> line_strengths(const Run& run, double period, const Vector& b, double beta,
                                   std::size_t n) {
  const Vector c = b.unitOrthogonal();
  const Vector cb = c.cross(b);
  std::vector<Complex> z1(n);
  std::vector<Complex> z2(n);
  const double forward = run.t1() >= run.t0() ? 1 : -1;
  for (std::size_t i = 0; i < n; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(n);
    Quaternion back;
    back.w() = std::cos(beta * part);
    back.vec() = -std::sin(beta * part) * b;
    const Quaternion p = run.propagator().flow->at(run.t0() + forward * period * part) * back;
    z1[i] = {p.w(), b.dot(p.vec())};
    z2[i] = {c.dot(p.vec()), cb.dot(p.vec())};
  }
  const auto first = fourier_transform(z1);
  const auto second = fourier_transform(z2);
  std::vector<double> strengths(n);
  const auto squares = static_cast<double>(n) * static_cast<double>(n);
  for (std::size_t j = 0; j < n; ++j)
    strengths[j] = (std::norm(first[j]) + std::norm(second[j])) / squares;
  return strengths;
}

// If omega repeats, U(t0 + 2 T) = U(t0 + T)^2.
void refuse_other_period(const Run& run, double period, const Quaternion& end, double of_t) {
  if (2 * period > std::abs(run.t1() - run.t0())) return;
  const double forward = run.t1() >= run.t0() ? 1 : -1;
  const Quaternion twice = run.propagator().flow->at(run.t0() + forward * 2 * period);
  const double off = (twice.coeffs() - (end * end).coeffs()).norm();
  // Of three quaternions, half the angle each.
  if (off > 4 * (run.propagator().error_estimate + of_t + 8 * kEpsilon)) {
    throw std::invalid_argument("omega does not repeat with the period " + text(period) +
                                ": after two periods the body is off by " + text(2 * off, 2) +
                                " rad");
  }
}

std::string term(int factor, const std::string& name) {
  return factor == 1 ? name : std::to_string(factor) + " " + name;
}

}  // namespace

std::optional<double> drive_period(const AngularVelocity& omega) {
  if (const auto* periodic = omega.as<PeriodicSpin>()) return periodic->period();
  if (const auto* turning = omega.as<TurningSpin>()) return kTwoPi / std::abs(turning->rate());
  return std::nullopt;
}

double greatest_rate(const Run& run, double t, double period) {
  constexpr int kLooks = 16;
  double greatest = 0;
  for (int i = 0; i < kLooks; ++i)
    greatest = std::max(greatest, norm(run.propagator().flow->generator(t + period * i / kLooks)));
  return greatest;
}

FloquetFrequencies floquet_frequencies(const Run& run, double period) {
  if (const auto* constant = run.driver().as<ConstantSpin>())
    return {0, norm(constant->value(0)) / (2 * kTwoPi), 1};
  const double length = std::abs(run.t1() - run.t0());
  if (!(period > 0 && std::isfinite(period))) {
    throw std::invalid_argument("the period must be positive, got " + text(period));
  }
  if (period > length) {
    throw std::invalid_argument("the period " + text(period) + " is longer than the run, " +
                                text(run.t0()) + " .. " + text(run.t1()));
  }
  const double forward = run.t1() >= run.t0() ? 1 : -1;
  // What the rounding of the start and of the end of two periods turns.
  const double of_t =
      kEpsilon * (std::abs(run.t0()) + 2 * period) * greatest_rate(run, run.t0(), forward * period);
  const Quaternion end = run.propagator().flow->at(run.t0() + forward * period);
  refuse_other_period(run, period, end, of_t);
  const double sine = end.vec().norm();
  const Vector b = sine > 0 ? Vector(end.vec() / sine) : Vector(Vector::UnitX());
  const double beta = std::atan2(sine, end.w());
  // Enough samples where the outer half of the lines has nothing: |P| = 1 is the sum of all.
  constexpr std::size_t kMostSamples = 1 << 16;
  std::vector<double> strengths;
  for (std::size_t n = 64; n <= kMostSamples; n *= 2) {
    strengths = line_strengths(run, period, b, beta, n);
    double outer = 0;
    for (std::size_t j = n / 4; j < n - n / 4; ++j) outer += strengths[j];
    if (outer < 1e-4) break;
  }
  const auto n = static_cast<std::ptrdiff_t>(strengths.size());
  // Of lines equally strong the slowest.
  const double error =
      (run.propagator().error_estimate + of_t + 8 * kEpsilon) / (2 * kTwoPi * period);
  FloquetFrequencies best = {1 / period, 0, -1, error};
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const auto j = static_cast<double>(i < n / 2 ? i : i - n);
    const double frequency = std::abs(beta / kTwoPi + j) / period;
    const double amplitude = std::sqrt(strengths[static_cast<std::size_t>(i)]);
    if (amplitude > best.amplitude + 1e-9 ||
        (amplitude > best.amplitude - 1e-9 && frequency < best.floquet))
      best = {best.drive, frequency, amplitude, error};
  }
  return best;
}

std::optional<FloquetFrequencies> floquet_frequencies(const Run& run) {
  if (run.driver().as<ConstantSpin>() != nullptr) return floquet_frequencies(run, 1);
  const auto period = drive_period(run.driver());
  if (!period || *period > std::abs(run.t1() - run.t0())) return std::nullopt;
  return floquet_frequencies(run, *period);
}

std::optional<Fraction> commensurate(const FloquetFrequencies& basis) {
  if (!(basis.drive > 0)) return std::nullopt;
  // The numbers in omega, and its period, are rounded.
  const double ratio = basis.floquet / basis.drive;
  return fraction_within(ratio, basis.error / basis.drive + 4 * kEpsilon * (1 + ratio));
}

std::string Combination::name() const {
  const std::string drive = j == 0 ? "" : term(std::abs(j), "drive");
  const std::string floquet = k == 0 ? "" : term(std::abs(k), "f_F");
  if (drive.empty() || floquet.empty()) return drive + floquet;
  // The frequency is positive: one of the two is added.
  return j > 0 ? drive + (k > 0 ? " + " : " - ") + floquet : floquet + " - " + drive;
}

std::optional<Combination> combination(const FloquetFrequencies& basis, double frequency,
                                       double tolerance) {
  constexpr int kMost = 8;
  constexpr double kMostDrives = 1000;
  // Each k has a combination within half a drive, or, without a drive, within half of f_F: by
  // chance one frequency in twenty, at most, has one within the tolerance.
  const double spacing = basis.drive > 0 ? basis.drive : basis.floquet;
  if (!(2 * tolerance * (2 * kMost + 1) * 20 < spacing)) return std::nullopt;
  std::optional<Combination> best;
  for (int k = -kMost; k <= kMost; ++k) {
    const double rest = frequency - k * basis.floquet;
    const double j = basis.drive > 0 ? std::nearbyint(rest / basis.drive) : 0;
    if (!(std::abs(j) <= kMostDrives)) continue;
    const Combination one = {static_cast<int>(j), k, rest - j * basis.drive};
    if (!(std::abs(one.difference) <= tolerance + std::abs(k) * basis.error) ||
        (one.j == 0 && one.k == 0))
      continue;
    const auto size = [](const Combination& c) { return std::abs(c.j) + std::abs(c.k); };
    if (!best || size(one) < size(*best) ||
        (size(one) == size(*best) && std::abs(one.difference) < std::abs(best->difference)))
      best = one;
  }
  return best;
}

}  // namespace rotor
