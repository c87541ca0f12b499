#include "rotation/random.hpp"

#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

#include "rotation/extended.hpp"

namespace rotor {
namespace {

constexpr std::size_t kMost = 10'000'000;

// Uniform quaternions. The distributions of <random> differ between libraries, its engines do not.
class UniformQuaternions {
 public:
  explicit UniformQuaternions(std::uint64_t seed) : engine_(seed) {}

  // Marsaglia: with (a, b) and (c, d) uniform in the unit disc and s = a^2 + b^2, which is then
  // uniform in [0, 1], (a, b, (c, d) sqrt((1 - s)/(c^2 + d^2))) is uniform on the sphere S^3.
  ExtendedQuaternion next() {
    const auto [a, b] = in_disc();
    const auto [c, d] = in_disc();
    const Extended k = std::sqrt((1 - a * a - b * b) / (c * c + d * d));
    return {a, b, c * k, d * k};
  }

 private:
  struct Point {
    Extended x, y;
  };
  Point in_disc() {
    for (;;) {
      const Extended x = coordinate();
      const Point p{x, coordinate()};
      const Extended squared = p.x * p.x + p.y * p.y;
      if (0 < squared && squared <= 1) return p;
    }
  }
  // In [-1, 1), a multiple of 2^-52.
  Extended coordinate() { return std::ldexp(Extended(engine_() >> 11), -52) - 1; }

  std::mt19937_64 engine_;
};

}  // namespace

std::vector<Rotation> random_rotations(std::uint64_t seed, std::size_t count) {
  if (count > kMost) {
    throw std::invalid_argument("random: expected at most 1e7 rotations, got " +
                                std::to_string(count));
  }
  UniformQuaternions quaternions(seed);
  std::vector<Rotation> rotations;
  rotations.reserve(count);
  for (std::size_t i = 0; i < count; ++i) rotations.push_back(canonical_of(quaternions.next()));
  return rotations;
}

}  // namespace rotor
