# The functions with which each folder of tautline declares its library, its tests and its fuzz targets.

include(CMakePackageConfigHelpers)
include(GNUInstallDirs)
include(GoogleTest)

# tautline_library(NAME geometry
#   HEADERS polygon.h ...       every header of the folder that belongs to this library
#   SOURCES polygon.cc ...      none: a header-only library
#   DEPENDS base ...            libraries of tautline, by their short names
#   LINK Boost::headers ...     external targets that its headers need
#   PRIVATE_LINK PNG::PNG ...   external targets that only its sources need
#   NATIVE)                     needs a native library: installed, but found only with COMPONENTS native; left out
#                               where TAUTLINE_NATIVE is off
#
# Makes the target tautline_geometry, known to all as tautline::geometry, and installs it.
function(tautline_library)
  cmake_parse_arguments(PARSE_ARGV 0 arg "NATIVE" "NAME" "HEADERS;SOURCES;DEPENDS;LINK;PRIVATE_LINK")
  if(arg_NATIVE AND NOT TAUTLINE_NATIVE)
    return()
  endif()
  set(target tautline_${arg_NAME})
  if(arg_SOURCES)
    set(scope PUBLIC)
    add_library(${target} ${arg_SOURCES})
    if(TAUTLINE_NATIVE)
      # So that shared libraries can hold it. Functions are inlined as without: nobody puts others in their place.
      set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
      target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>)
    endif()
    target_link_libraries(${target} PRIVATE ${arg_PRIVATE_LINK})
  else()
    set(scope INTERFACE)
    add_library(${target} INTERFACE)
  endif()
  add_library(tautline::${arg_NAME} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${arg_NAME})

  list(TRANSFORM arg_DEPENDS PREPEND tautline::)
  target_link_libraries(${target} ${scope} ${arg_DEPENDS} ${arg_LINK})
  # Sources include their own header first, as the format has it, which shows that it compiles on its own. The test
  # `headers` compiles the others.
  set(alone ${arg_HEADERS})
  set(shown ${arg_SOURCES})
  list(TRANSFORM shown REPLACE "\\.cc$" ".h")
  list(REMOVE_ITEM alone ${shown})
  set(shown ${arg_HEADERS})
  list(REMOVE_ITEM shown ${alone})
  target_sources(
    ${target} ${scope}
    FILE_SET HEADERS BASE_DIRS "${PROJECT_SOURCE_DIR}" FILES ${shown}
    FILE_SET alone TYPE HEADERS BASE_DIRS "${PROJECT_SOURCE_DIR}" FILES ${alone})
  set_target_properties(${target} PROPERTIES INTERFACE_HEADER_SETS_TO_VERIFY alone)
  target_compile_features(${target} ${scope} cxx_std_20)
  # Fused multiply-add changes the sign of predicates, also of those inlined into a user's code.
  target_compile_options(${target} ${scope} -ffp-contract=off)

  list(TRANSFORM arg_HEADERS PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/")
  set_property(GLOBAL APPEND PROPERTY TAUTLINE_HEADERS ${arg_HEADERS})

  set(export tautlineTargets)
  if(arg_NATIVE)
    set(export tautlineNativeTargets)
  endif()
  install(
    TARGETS ${target}
    EXPORT ${export}
    ARCHIVE COMPONENT development
    FILE_SET HEADERS COMPONENT development
    FILE_SET alone COMPONENT development)
endfunction()

# tautline_test(NAME geometry_test SOURCES polygon_test.cc ... LINK tautline::geometry ...)
#
# One GoogleTest program per folder; its tests run in the root of the repository as geometry/Suite.Name.
function(tautline_test)
  if(NOT TAUTLINE_BUILD_TESTS)
    return()
  endif()
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME" "SOURCES;LINK")
  set(target tautline_${arg_NAME})
  add_executable(${target} ${arg_SOURCES})
  target_link_libraries(${target} PRIVATE ${arg_LINK} GTest::gmock GTest::gtest_main)
  string(REGEX REPLACE "_test$" "/" prefix ${arg_NAME})
  gtest_discover_tests(
    ${target}
    TEST_PREFIX ${prefix}
    WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}"
    DISCOVERY_MODE PRE_TEST
    PROPERTIES LABELS unit)
endfunction()

# tautline_fuzzer(NAME scene_fuzz SOURCES scene_fuzz.cc LINK tautline::scene ...)
#
# A fuzzer, or, in builds without fuzzers, the test corpus/scene_fuzz that replays the files in corpus/scene_fuzz.
function(tautline_fuzzer)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME" "SOURCES;LINK")
  add_executable(${arg_NAME} ${arg_SOURCES})
  target_link_libraries(${arg_NAME} PRIVATE ${arg_LINK})
  if(TAUTLINE_BUILD_FUZZERS)
    target_link_libraries(${arg_NAME} PRIVATE -fsanitize=fuzzer)
    add_dependencies(fuzzers ${arg_NAME})
    return()
  endif()
  target_sources(${arg_NAME} PRIVATE replay_corpus.cc)
  add_test(NAME corpus/${arg_NAME} COMMAND ${arg_NAME} "${CMAKE_CURRENT_SOURCE_DIR}/corpus/${arg_NAME}")
  set_tests_properties(corpus/${arg_NAME} PROPERTIES LABELS corpus)
endfunction()

# Installs tautlineConfig.cmake, after all libraries are declared.
function(tautline_install_package)
  set(folder ${CMAKE_INSTALL_LIBDIR}/cmake/tautline)
  foreach(export tautlineTargets tautlineNativeTargets)
    install(EXPORT ${export} NAMESPACE tautline:: DESTINATION ${folder} COMPONENT development)
  endforeach()
  set(version_file "${PROJECT_BINARY_DIR}/tautlineConfigVersion.cmake")
  write_basic_package_version_file("${version_file}" COMPATIBILITY SameMinorVersion)
  install(FILES "${PROJECT_SOURCE_DIR}/cmake/tautlineConfig.cmake" "${version_file}" DESTINATION ${folder}
          COMPONENT development)
endfunction()

# Writes the Doxyfile of `make api`, after all libraries are declared: the reference holds the installed headers.
function(tautline_configure_reference)
  get_property(headers GLOBAL PROPERTY TAUTLINE_HEADERS)
  list(JOIN headers "\" \\\n  \"" headers)
  configure_file("${PROJECT_SOURCE_DIR}/docs/Doxyfile.in" "${PROJECT_BINARY_DIR}/Doxyfile" @ONLY)
endfunction()
