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

// Where f of one sign is nearest to zero at the middle of three samples, it may be beyond between
// them: a sample there, found by parabolas, and its neighbours of the other sign; nothing where the
// parabola stays away from zero.
struct Dip {
  Sample before;
  Sample beyond;
  Sample after;
};
std::optional<Dip> dip_between(const std::function<double(double)>& f, Sample a, Sample b,
                               Sample c) {
  constexpr int kMost = 20;
  const double sign = b.f > 0 ? 1 : -1;
  const double rounding = 16 * kEpsilon * std::max(std::abs(a.f), std::abs(c.f));
  for (int count = 0; count < kMost; ++count) {
    const double left = (b.f - a.f) / (b.t - a.t);
    const double right = (c.f - b.f) / (c.t - b.t);
    const double bend = (right - left) / (c.t - a.t);
    // Newton's form at b has the slope left + bend (b - a).
    const double slope = left + bend * (b.t - a.t);
    const double lowest = b.f - slope * slope / (4 * bend);
    if (!(sign * lowest < sign * b.f / 4)) return std::nullopt;
    const Sample at{b.t - slope / (2 * bend), 0};
    if (at.t == b.t || !((at.t > a.t) == (c.t > a.t) && (at.t < c.t) == (c.t > a.t)))
      return std::nullopt;
    const Sample x{at.t, f(at.t)};
    if (std::isnan(x.f)) return std::nullopt;
    const bool first = (x.t < b.t) == (c.t > a.t);
    if (sign * x.f < -rounding) return Dip{first ? a : b, x, first ? b : c};
    if (sign * x.f < sign * b.f) {
      (first ? c : a) = b;
      b = x;
    } else {
      (first ? a : c) = x;
    }
  }
  return std::nullopt;
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
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  Sample last{times.front(), kNan};
  Sample before = last;
  visit_times(times, observer, [&](double t) {
    const Sample now{t, f(t)};
    known = known || !std::isnan(now.f);
    if (now.f == 0) return;  // it comes through where it is on the other side
    if ((last.f < 0 && now.f > 0) || (last.f > 0 && now.f < 0)) {
      if (const auto zero = zero_between(f, last, now)) add(*zero, now.f > 0);
    } else if (before.f * last.f > 0 && last.f * now.f > 0 &&
               std::abs(last.f) <= std::min(std::abs(before.f), std::abs(now.f))) {
      if (const auto dip = dip_between(f, before, last, now)) {
        if (const auto zero = zero_between(f, dip->before, dip->beyond)) add(*zero, last.f < 0);
        if (const auto zero = zero_between(f, dip->beyond, dip->after)) add(*zero, last.f > 0);
      }
    }
    before = std::exchange(last, now);
  });
  if (!known) {
    throw std::invalid_argument("the function is nan at all " + std::to_string(times.size()) +
                                " times at which it was looked at");
  }
  return zeros;
}

}  // namespace rotor
