#include "script/binding.hpp"

namespace rotor::script {

std::span<const Group> triangle_groups() { return {}; }

}  // namespace rotor::script
