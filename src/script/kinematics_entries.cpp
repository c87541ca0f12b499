#include "script/binding.hpp"

namespace rotor::script {

std::span<const Group> kinematics_groups() { return {}; }

}  // namespace rotor::script
