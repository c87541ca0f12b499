// When an angle that grows by equal steps comes back to where it was.
#pragma once

#include <cstdint>
#include <vector>

#include "rotation/rotation.hpp"

namespace rotor {

/// The k from 0 to `last` for which offset + k step lies within `width` of a multiple of pi,
/// rising: found one after the other by Euclid's algorithm, however far apart they are. Those at
/// the border may be among them. Throws std::length_error where there are more than a million.
std::vector<std::uint64_t> near_multiples_of_pi(Extended step, Extended offset, Extended width,
                                                std::uint64_t last);

}  // namespace rotor
