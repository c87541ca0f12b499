#include "integrate/recurrence.hpp"

#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

namespace rotor {
namespace {

__extension__ using Wide = unsigned __int128;

// Angles as whole parts of pi: a step is then rounded by less than 1e-18 rad.
constexpr Wide kParts = Wide{1} << 62U;
constexpr Extended kOfParts = 0x1p62L;

Wide parts_of_pi(Extended angle) {
  const Extended turns = angle / std::numbers::pi_v<Extended>;
  return static_cast<Wide>((turns - std::floor(turns)) * kOfParts) % kParts;
}

// The least k with low <= a k mod m <= high, where low <= high < m: the multiples of a before the
// first beyond m miss the interval, or one is it; else the question is the same modulo a.
std::optional<Wide> first_between(Wide a, Wide m, Wide low, Wide high) {
  if (low == 0) return 0;
  if (a == 0) return std::nullopt;
  if (2 * a > m) return first_between(m - a, m, m - high, m - low);
  const Wide k = (low + a - 1) / a;
  if (k * a <= high) return k;
  const auto wraps = first_between((a - m % a) % a, a, low % a, high % a);
  if (!wraps) return std::nullopt;
  return (low + m * *wraps + a - 1) / a;
}

}  // namespace

std::vector<std::uint64_t> near_multiples_of_pi(Extended step, Extended offset, Extended width,
                                                std::uint64_t last) {
  constexpr std::size_t kMost = 1'000'000;
  std::vector<std::uint64_t> found;
  // What the rounding of the step comes to is looked through too.
  const Extended reach = width + static_cast<Extended>(last) * 0x1p-60L;
  const bool everywhere = 2 * reach >= std::numbers::pi_v<Extended>;
  const Wide a = parts_of_pi(step);
  const Wide across = everywhere ? kParts - 1 : parts_of_pi(2 * reach);
  // a k must lie between low and low + across.
  Wide low = parts_of_pi(-offset - reach);
  for (Wide k = 0;;) {
    const bool wrapped = low + across >= kParts;
    const auto next = wrapped ? std::optional<Wide>(0)  // 0 is between
                              : first_between(a, kParts, low, low + across);
    if (!next || k + *next > last) return found;
    k += *next;
    if (found.size() == kMost) {
      throw std::length_error(
          "the motion comes back more than a million times: too many to be looked through");
    }
    found.push_back(static_cast<std::uint64_t>(k));
    low = (low + 2 * kParts - (*next + 1) % kParts * a % kParts) % kParts;
    ++k;
  }
}

}  // namespace rotor
