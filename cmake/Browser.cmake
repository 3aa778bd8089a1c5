# What stands in for find_package where the compiler is emscripten's: it must not see /usr/include, so the three
# libraries of headers that tautline needs are reached through links of their own.

set(headers "${PROJECT_BINARY_DIR}/headers")
file(MAKE_DIRECTORY "${headers}")
foreach(folder boost nlohmann tl)
  if(NOT EXISTS "/usr/include/${folder}")
    message(FATAL_ERROR "no headers in /usr/include/${folder}: run tools/install_packages.sh wasm")
  endif()
  file(CREATE_LINK "/usr/include/${folder}" "${headers}/${folder}" SYMBOLIC)
endforeach()

foreach(library Boost::headers nlohmann_json::nlohmann_json tl::expected)
  add_library(${library} INTERFACE IMPORTED)
  target_include_directories(${library} SYSTEM INTERFACE "${headers}")
endforeach()
