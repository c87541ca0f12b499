#include "integrate/flow.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "rotation/text.hpp"

namespace rotor {

std::vector<TimeSpan> Flow::approaches(const Quaternion& /*target*/, double /*distance*/) const {
  const std::vector<double> times = mesh();
  std::vector<TimeSpan> spans;
  spans.reserve(times.size());
  for (std::size_t i = 1; i < times.size(); ++i) spans.push_back({times[i - 1], times[i]});
  return spans;
}

Quaternion FixedAxisFlow::at(double t) const {
  const Extended half = angle(t) / 2;
  Quaternion q;
  q.w() = static_cast<double>(std::cos(half));
  q.vec() = direction_ * static_cast<double>(std::sin(half));
  return q;
}

std::vector<TimeSpan> FixedAxisFlow::approaches(const Quaternion& target, double distance) const {
  if (norm(direction_.cross(target.vec())) >
      distance + 4 * std::numeric_limits<double>::epsilon()) {
    return {};
  }
  return Flow::approaches(target, distance);
}

UniformTurn::UniformTurn(const Vector& omega, double t0, double t1)
    : FixedAxisFlow(omega.isZero(0) ? Vector(Vector::UnitX()) : unit(omega)),
      rate_(omega.cast<Extended>().norm()),
      t0_(t0),
      t1_(t1) {
  if (!std::isfinite(static_cast<double>(angle(t1)))) {
    throw std::invalid_argument("omega (t1 - t0) is too large to be an angle");
  }
}

std::vector<double> UniformTurn::mesh() const {
  return even_mesh(t0_, t1_, static_cast<double>(std::abs(angle(t1_))));
}

std::vector<double> even_mesh(double t0, double t1, double turning) {
  constexpr double kMost = 1e7;
  const double count = std::max(1.0, std::ceil(turning / 5));
  if (!(count <= kMost)) {
    throw std::length_error("a turning of " + text(turning, 3) +
                            " rad is too long to look through");
  }
  std::vector<double> mesh;
  const auto parts = static_cast<std::size_t>(count);
  mesh.reserve(parts + 1);
  for (std::size_t i = 0; i < parts; ++i) {
    mesh.push_back(t0 + (t1 - t0) * (static_cast<double>(i) / count));
  }
  mesh.push_back(t1);
  return mesh;
}

}  // namespace rotor
