#include "dynamics/section.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "motion/times.hpp"

namespace rotor {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr int kParts = 8;  // samples in an interval of the mesh

struct Sample {
  double t;
  double f;
};

// The zero of f between a and b, where it has different signs: by inverse quadratic interpolation
// where that is safe, else by halves (Chandrupatla, Advances in Engineering Software 28, 1997).
// Nothing where f jumps over it.
std::optional<double> zero_between(const std::function<double(double)>& f, Sample a, Sample b) {
  const double range = std::abs(b.f - a.f);
  const double slope = range / std::abs(b.t - a.t);
  Sample c = a;
  double part = 0.5;
  while (a.f != 0 && b.f != 0) {
    const Sample now{a.t + part * (b.t - a.t), 0};
    if (now.t == a.t || now.t == b.t) break;
    Sample x{now.t, f(now.t)};
    if (std::isnan(x.f)) return std::nullopt;
    if ((x.f > 0) == (a.f > 0)) {
      c = std::exchange(a, x);
    } else {
      c = std::exchange(b, std::exchange(a, x));
    }
    const double nearest = kEpsilon * std::max(std::abs(a.t), std::abs(b.t));
    const double least = nearest / std::abs(b.t - a.t);
    if (!(least < 0.5)) break;
    const double xi = (a.t - b.t) / (c.t - b.t);
    const double phi = (a.f - b.f) / (c.f - b.f);
    const bool safe = phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi;
    part = safe ? a.f / (b.f - a.f) * c.f / (b.f - c.f) +
                      (c.t - a.t) / (b.t - a.t) * a.f / (c.f - a.f) * b.f / (c.f - b.f)
                : 0.5;
    part = std::clamp(part, least, 1 - least);
  }
  // At late t one rounding of t may be more than that of f.
  const double of_t = std::abs(b.t - a.t) + 4 * kEpsilon * std::abs(a.t);
  if (a.f != 0 && b.f != 0 && std::abs(b.f - a.f) > 1e-6 * range + 16 * slope * of_t)
    return std::nullopt;
  return std::abs(a.f) < std::abs(b.f) ? a.t : b.t;
}

std::vector<double> times_to_look(const Run& run, const std::optional<std::size_t>& n) {
  if (n) {
    if (*n < 2) throw std::invalid_argument("n must be at least 2, got " + std::to_string(*n));
    return times_in(run.t0(), run.t1(), *n);
  }
  const std::vector<double> mesh = run.propagator().flow->mesh();
  std::vector<double> times{mesh.front()};
  times.reserve(kParts * mesh.size());
  for (std::size_t i = 1; i < mesh.size(); ++i) {
    for (int part = 1; part < kParts; ++part) {
      times.push_back(mesh[i - 1] + (mesh[i] - mesh[i - 1]) * part / kParts);
    }
    times.push_back(mesh[i]);
  }
  return times;
}

}  // namespace

std::vector<double> section(const Run& run, const std::function<double(double)>& f,
                            Direction direction, std::optional<std::size_t> n,
                            const Observer& observer, const std::function<double(double)>& below) {
  const std::vector<double> times = times_to_look(run, n);
  std::vector<double> zeros;
  bool known = false;
  const auto add = [&](double zero, bool rises) {
    const double sign = below ? below(zero) : 1;
    if (std::abs(sign) <= 8 * kEpsilon) return;
    if (direction == Direction::kBoth || (direction == Direction::kUp) == (rises == (sign > 0)))
      zeros.push_back(zero);
  };
  Sample last{times.front(), std::numeric_limits<double>::quiet_NaN()};
  visit_times(times, observer, [&](double t) {
    const Sample now{t, f(t)};
    known = known || !std::isnan(now.f);
    if (now.f == 0) return;  // it comes through where it is on the other side
    if ((last.f < 0 && now.f > 0) || (last.f > 0 && now.f < 0)) {
      if (const auto zero = zero_between(f, last, now)) add(*zero, now.f > 0);
    }
    last = now;
  });
  if (!known) {
    throw std::invalid_argument("the function is nan at all " + std::to_string(times.size()) +
                                " times at which it was looked at");
  }
  return zeros;
}

}  // namespace rotor
