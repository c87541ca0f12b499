#include "script/binding.hpp"

namespace rotor::script {

std::span<const Group> sequence_groups() { return {}; }

}  // namespace rotor::script
