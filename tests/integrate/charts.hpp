// Functions f for the generalized Euler vector.
#pragma once

#include <memory>
#include <utility>

#include "integrate/generalized.hpp"
#include "spin/jet.hpp"

namespace rotor {

inline std::shared_ptr<const GeneralizedAngle> angle_function(GeneralizedAngle::Function f) {
  return std::make_shared<const GeneralizedAngle>(std::move(f));
}
inline std::shared_ptr<const GeneralizedAngle> identity_angle() {
  return angle_function([](const Jet& x) { return x; });
}
/// theta + theta^3/10.
inline std::shared_ptr<const GeneralizedAngle> cubic_angle() {
  return angle_function([](const Jet& x) { return x + x * x * x * 0.1; });
}
/// 2 sin(theta/2): twice M.
inline std::shared_ptr<const GeneralizedAngle> half_sine_angle() {
  return angle_function([](const Jet& x) { return sin(x * 0.5) * 2; });
}
/// tan(theta/2): G.
inline std::shared_ptr<const GeneralizedAngle> half_tangent_angle() {
  return angle_function([](const Jet& x) { return tan(x * 0.5); });
}

}  // namespace rotor
