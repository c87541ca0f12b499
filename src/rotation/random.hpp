// Random rotations that are the same everywhere.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rotation/rotation.hpp"

namespace rotor {

/// `count` rotations drawn uniformly on SO(3) (Haar measure: no attitude is preferred, and R * S is
/// distributed as S for every R), canonical. The axis is uniform on the sphere, the angle theta in
/// [0, pi] has the density (1 - cos theta)/pi. The same seed gives the same rotations on every
/// machine, and the first ones do not depend on `count`. Throws std::invalid_argument for more than
/// 1e7.
std::vector<Rotation> random_rotations(std::uint64_t seed, std::size_t count);

}  // namespace rotor
