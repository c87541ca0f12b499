#include "dynamics/strobe.hpp"

#include <cmath>
#include <stdexcept>

#include "motion/times.hpp"
#include "rotation/text.hpp"

namespace rotor {

std::vector<double> strobe_times(const Run& run, double period) {
  const double length = std::abs(run.t1() - run.t0());
  if (!(period > 0))
    throw std::invalid_argument("the period must be positive, got " + text(period));
  if (period > length) {
    throw std::invalid_argument("the period " + text(period) + " is longer than the run, " +
                                text(run.t0()) + " .. " + text(run.t1()));
  }
  return times_every(run.t0(), run.t1(), period);
}

}  // namespace rotor
