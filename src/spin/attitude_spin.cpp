#include "spin/attitude_spin.hpp"

#include <algorithm>

namespace rotor {

std::string AttitudeSpin::description() const {
  return "the omega of " + std::to_string(spline_.times().size()) + " attitudes";
}

std::vector<double> AttitudeSpin::breaks(double low, double high) const {
  const std::vector<double>& times = spline_.times();
  const auto first = std::upper_bound(times.begin(), times.end(), low);
  return {first, std::lower_bound(first, times.end(), high)};
}

}  // namespace rotor
