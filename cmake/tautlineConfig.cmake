# find_package(tautline) offers the header-only-dependency libraries: tautline::tether and what it needs.
# find_package(tautline COMPONENTS native) adds tautline::scene_native and tautline::draw_png.
include(CMakeFindDependencyMacro)
find_dependency(tl-expected)
find_dependency(nlohmann_json)
find_dependency(Boost)
include("${CMAKE_CURRENT_LIST_DIR}/tautlineTargets.cmake")

if("native" IN_LIST tautline_FIND_COMPONENTS)
  find_dependency(yaml-cpp)
  find_dependency(PNG)
  find_dependency(PkgConfig)
  pkg_check_modules(RSVG REQUIRED IMPORTED_TARGET librsvg-2.0)
  pkg_check_modules(FONTCONFIG REQUIRED IMPORTED_TARGET fontconfig)
  include("${CMAKE_CURRENT_LIST_DIR}/tautlineNativeTargets.cmake")
endif()
