# What stands in for find_package where the compiler is emscripten's: it must not see /usr/include, so the
# libraries of headers that tautline needs are reached through links of their own.

set(headers "${PROJECT_BINARY_DIR}/headers")
file(MAKE_DIRECTORY "${headers}")
foreach(folder boost nlohmann tl)
  if(NOT EXISTS "/usr/include/${folder}")
    message(FATAL_ERROR "no headers in /usr/include/${folder}: run tools/install_packages.sh wasm")
  endif()
  file(CREATE_LINK "/usr/include/${folder}" "${headers}/${folder}" SYMBOLIC)
endforeach()
if(NOT EXISTS /usr/include/eigen3/Eigen)
  message(FATAL_ERROR "no headers in /usr/include/eigen3: run tools/install_packages.sh wasm")
endif()
file(CREATE_LINK /usr/include/eigen3/Eigen "${headers}/Eigen" SYMBOLIC)

foreach(library Boost::headers Eigen3::Eigen nlohmann_json::nlohmann_json tl::expected)
  add_library(${library} INTERFACE IMPORTED)
  target_include_directories(${library} SYSTEM INTERFACE "${headers}")
endforeach()
