#include "dynamics/separation.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

namespace rotor {
namespace {

struct Separation {
  double quaternion;
  double rotation;
};

Separation separation(const Quaternion& p, const Quaternion& q) {
  const Quaternion between = p.conjugate() * q;
  return {(p.coeffs() - q.coeffs()).norm(),
          2 * std::atan2(norm(between.vec()), std::abs(between.w()))};
}

}  // namespace

SeparationChange greatest_separation_change(const Run& a, const Run& b,
                                            std::span<const double> times,
                                            const Observer& observer) {
  if (times.size() < 2) {
    throw std::invalid_argument("a change of separation needs at least 2 times, got " +
                                std::to_string(times.size()));
  }
  SeparationChange greatest;
  std::optional<Separation> first;
  visit_times(times, observer, [&](double t) {
    const Separation now = separation(a.attitude(t).quaternion, b.attitude(t).quaternion);
    if (!first) first = now;
    greatest.quaternion =
        std::max(greatest.quaternion, std::abs(now.quaternion - first->quaternion));
    greatest.rotation = std::max(greatest.rotation, std::abs(now.rotation - first->rotation));
  });
  return greatest;
}

}  // namespace rotor
