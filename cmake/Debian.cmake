# Three Debian packages, made by `make deb`: tautline, the program with its completions and manual; libtautline-env1,
# the environment of `learn train` as a shared library; and libtautline-dev, the static libraries with headers, CMake
# configuration and examples, and what programs in C need of the environment.

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME tautline)
# Each package has its own.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL program environment development)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
# Older than -1, which is for Debian to give.
set(CPACK_DEBIAN_PACKAGE_RELEASE 0tautline1)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "tautline maintainers <maintainers@users.noreply.tautline.dev>")
set(CPACK_DEBIAN_PACKAGE_SOURCE tautline)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME tautline)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION
    "planner for robots on a tether
Tautline finds the exact shortest motion of a robot on a tether among
obstacles, or proves that the tether allows none. It lists the ways in
which a tether can lie between two points, pulls laid cables tight and
draws its answers as SVG and PNG. Worlds are drawn in YAML or JSON, or
read from maps of ROS, MovingAI and GeoJSON.")

# The number is that of the library's name, libtautline_env.so.1.
set(CPACK_DEBIAN_ENVIRONMENT_PACKAGE_NAME libtautline-env1)
set(CPACK_DEBIAN_ENVIRONMENT_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_ENVIRONMENT_PACKAGE_SHLIBDEPS ON)
set(environment_control "${PROJECT_BINARY_DIR}/debian/environment_control")
file(WRITE "${environment_control}/shlibs" "libtautline_env 1 libtautline-env1 (>= ${PROJECT_VERSION})\n")
file(WRITE "${environment_control}/triggers" "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_ENVIRONMENT_PACKAGE_CONTROL_EXTRA "${environment_control}/shlibs" "${environment_control}/triggers")
set(CPACK_DEBIAN_ENVIRONMENT_DESCRIPTION
    "robot that drags a cable, as an environment for learning
Tautline plans for robots on a tether. This library is the environment in
which it trains policies: a robot that drags a cable among obstacles, with
what touches what and a reward for each step. It has a C interface, which
the example for Gymnasium in libtautline-dev uses from Python.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libtautline-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
# What the headers include, and what programs link with the static libraries.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "libboost-dev, libexpected-dev, libfontconfig-dev, libpng-dev, librsvg2-dev, libyaml-cpp-dev, nlohmann-json3-dev, \
libtautline-env1 (= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}), pkg-config")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION
    "planner for robots on a tether - development files
Tautline finds the exact shortest motion of a robot on a tether among
obstacles, or proves that the tether allows none.
.
This package holds the C++ library: static libraries, headers, the CMake
package tautline, and examples; and the header of libtautline_env.")

# tautline_gzip(SOURCE FILE FOLDER COMPONENT): installs SOURCE compressed, the same bytes each time.
function(tautline_gzip source file folder component)
  set(path "${PROJECT_BINARY_DIR}/debian/${component}/${file}")
  add_custom_command(
    OUTPUT "${path}"
    COMMAND ${CMAKE_COMMAND} -E make_directory "${PROJECT_BINARY_DIR}/debian/${component}"
    COMMAND gzip -9nc "${source}" > "${path}"
    DEPENDS "${source}"
    VERBATIM)
  add_custom_target(tautline_gzip_${component}_${file} ALL DEPENDS "${path}")
  install(FILES "${path}" DESTINATION "${folder}" COMPONENT ${component})
endfunction()

execute_process(
  COMMAND ${CMAKE_COMMAND} -E env LC_ALL=C date -u -R -d ${TAUTLINE_VERSION_DATE}
  OUTPUT_VARIABLE TAUTLINE_CHANGELOG_DATE
  OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
configure_file("${CMAKE_CURRENT_LIST_DIR}/changelog.Debian.in" "${PROJECT_BINARY_DIR}/debian/changelog.Debian" @ONLY)
foreach(component program environment development)
  string(TOUPPER ${component} upper)
  set(folder "${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME}")
  tautline_gzip("${PROJECT_BINARY_DIR}/debian/changelog.Debian" changelog.Debian.gz "${folder}" ${component})
  tautline_gzip("${PROJECT_SOURCE_DIR}/CHANGELOG.md" changelog.gz "${folder}" ${component})
  install(FILES "${CMAKE_CURRENT_LIST_DIR}/copyright" DESTINATION "${folder}" COMPONENT ${component})
endforeach()
# CPack writes scripts that call ldconfig, besides the trigger, wherever it finds what a shared library depends on.
file(WRITE "${PROJECT_BINARY_DIR}/debian/lintian-overrides"
     "libtautline-env1: maintscript-calls-ldconfig [postinst]\nlibtautline-env1: maintscript-calls-ldconfig [postrm]\n")
install(FILES "${PROJECT_BINARY_DIR}/debian/lintian-overrides" DESTINATION "${CMAKE_INSTALL_DATADIR}/lintian/overrides"
        RENAME libtautline-env1 COMPONENT environment)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/examples" DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/libtautline-dev"
        COMPONENT development)

include(CPack)
