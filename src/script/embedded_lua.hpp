// The files of lua/, compiled in (script/embed.cmake writes the definition).
#pragma once

#include <string>
#include <vector>

namespace rotor::script {

struct EmbeddedModule {
  std::string name;    // lua/NAME.lua is the module "rotor.NAME"
  std::string source;  // its text
};

const std::vector<EmbeddedModule>& embedded_modules();

}  // namespace rotor::script
