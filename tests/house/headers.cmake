# Every header of src/ is self-contained: each compiles as a translation unit of its own.
file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/src
  ${PROJECT_SOURCE_DIR}/src/*.hpp)
foreach(header ${headers})
  set(unit ${CMAKE_CURRENT_BINARY_DIR}/headers/${header}.cpp)
  file(CONFIGURE OUTPUT ${unit} CONTENT "#include \"${header}\"\n")
  list(APPEND header_units ${unit})
endforeach()
add_library(header_check OBJECT ${header_units})
target_link_libraries(header_check PRIVATE rotor_script)
target_compile_options(header_check PRIVATE -O0)
