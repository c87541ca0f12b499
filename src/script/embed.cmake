# Writes OUTPUT: the FILES (Lua sources), each as a raw string literal under its name without the suffix.
string(CONCAT text "// NOLINTBEGIN(readability-function-size)\n#include \"script/embedded_lua.hpp\"\n\nnamespace rotor::script {\n\n"
  "const std::vector<EmbeddedModule>& embedded_modules() {\n"
  "  static const std::vector<EmbeddedModule> modules = {\n")
foreach(file IN LISTS FILES)
  get_filename_component(name "${file}" NAME_WE)
  file(READ "${file}" source)
  string(APPEND text "      {\"${name}\", R\"lua_source(${source})lua_source\"},\n")
endforeach()
string(APPEND text "  };\n  return modules;\n}\n\n}  // namespace rotor::script\n// NOLINTEND(readability-function-size)\n")
file(WRITE "${OUTPUT}" "${text}")
