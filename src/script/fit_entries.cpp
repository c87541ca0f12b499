#include "script/binding.hpp"

namespace rotor::script {

std::span<const Group> fit_groups() { return {}; }

}  // namespace rotor::script
