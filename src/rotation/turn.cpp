#include "rotation/turn.hpp"

#include <cmath>
#include <cstdint>

namespace rotor {
namespace {

// pi/2 in three parts, of which two have 32 bits: for k < 2^32 their products with k are exact, and
// so is the difference from the first, for the two are within a factor of two of one another. What
// is left rounds by 2^-64 each time; the third part is known to 2^-195.
constexpr Extended kQuarter[] = {0xc90fdaa2p-31L, 0x85a308d3p-65L, 0x98cc51701b839a25p-132L};

}  // namespace

// The library's sine does not need the reduction, but is three times as fast after it.
ExtendedQuaternion turn(const ExtendedVector& u, Extended angle, Extended rest) {
  Extended half = angle / 2;
  if (!(std::abs(half / kQuarter[0]) < 0x1p32L)) half = std::atan2(std::sin(half), std::cos(half));
  const Extended k = std::rint(half / kQuarter[0]);
  half = ((half - k * kQuarter[0]) - k * kQuarter[1]) - k * kQuarter[2] + rest / 2;
  const Extended s = std::sin(half);
  const Extended c = std::cos(half);
  switch (std::isfinite(k) ? static_cast<std::int64_t>(k) & 3 : 0) {
    case 0:
      return {c, u.x() * s, u.y() * s, u.z() * s};
    case 1:
      return {-s, u.x() * c, u.y() * c, u.z() * c};
    case 2:
      return {-c, -u.x() * s, -u.y() * s, -u.z() * s};
    default:
      return {s, -u.x() * c, -u.y() * c, -u.z() * c};
  }
}

}  // namespace rotor
