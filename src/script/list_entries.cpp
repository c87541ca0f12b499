#include "script/binding.hpp"

namespace rotor::script {

std::span<const Group> list_groups() { return {}; }

}  // namespace rotor::script
