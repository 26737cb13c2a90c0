# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT

# cpack -G DEB in the build folder makes Debian packages: libdot-capi0, the shared C library, which hosts depend on;
# libdot-core0.1, the shared C++ library, with BUILD_SHARED_LIBS; libdot-dev, to build hosts with; python3-dot-slam, the
# Python package; dot-tools, the programs, where they are installed. They pass lintian, if the build was configured with
# -DCMAKE_INSTALL_PREFIX=/usr: its libraries are then in the folder of their architecture.

set(CPACK_PACKAGE_NAME dot)
set(CPACK_PACKAGE_CONTACT "The dot authors <dot@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON) # of what is compiled; the rest is stated here
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
                                                WORLD_EXECUTE)

# What Debian wants to know of each package. The date honours SOURCE_DATE_EPOCH.
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
set(changelog "${PROJECT_BINARY_DIR}/debian/changelog")
file(WRITE "${changelog}" "dot (${PROJECT_VERSION}) unstable; urgency=medium\n\n  * See CHANGELOG.md of the sources.\n\n"
                          " -- ${CPACK_PACKAGE_CONTACT}  ${date}\n")
find_program(DOT_GZIP gzip)
mark_as_advanced(DOT_GZIP)
# dot_install_zipped(<file> <folder> <component>)
function(dot_install_zipped file folder component)
  if(DOT_GZIP)
    get_filename_component(name "${file}" NAME)
    execute_process(COMMAND "${DOT_GZIP}" -9nc "${file}" OUTPUT_FILE "${PROJECT_BINARY_DIR}/debian/${name}.gz")
    install(FILES "${PROJECT_BINARY_DIR}/debian/${name}.gz" DESTINATION "${CMAKE_INSTALL_DATADIR}/${folder}"
            COMPONENT ${component} EXCLUDE_FROM_ALL)
  endif()
endfunction()

set(about "It tells a visual SLAM system which of the objects in its images move\nand which are parked, from images, depth and instance masks.")

# dot_debian_package(<component> <package> <section> <description>)
macro(dot_debian_package component package section description)
  string(TOUPPER ${component} upper)
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${package})
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section})
  set(CPACK_COMPONENT_${upper}_DESCRIPTION "${about}\n${description}")
  install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} RENAME copyright
          COMPONENT ${component} EXCLUDE_FROM_ALL)
  dot_install_zipped("${changelog}" doc/${package} ${component})
endmacro()

# dot_debian_library(<component> <package> <description>): of a shared library.
macro(dot_debian_library component package description)
  dot_debian_package(${component} ${package} libs ${description})
  set(CPACK_DEBIAN_${upper}_PACKAGE_CONTROL_EXTRA "${PROJECT_SOURCE_DIR}/cmake/debian/triggers")
  set(PACKAGE ${package})
  configure_file("${PROJECT_SOURCE_DIR}/cmake/debian/lintian-overrides.in" "${PROJECT_BINARY_DIR}/debian/${package}" @ONLY)
  install(FILES "${PROJECT_BINARY_DIR}/debian/${package}" DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides
          COMPONENT ${component} EXCLUDE_FROM_ALL)
endmacro()

unset(CPACK_COMPONENTS_ALL)
set(depends libeigen3-dev libopencv-dev)
if(TARGET dot_capi)
  dot_debian_library(libraries libdot-capi0 "This package has its C library.")
  list(PREPEND depends "libdot-capi0 (= ${PROJECT_VERSION})")
endif()
if(BUILD_SHARED_LIBS)
  get_target_property(soversion dot_core SOVERSION)
  dot_debian_library(core_library libdot-core${soversion} "This package has its C++ library.")
  list(PREPEND depends "libdot-core${soversion} (= ${PROJECT_VERSION})")
endif()
dot_debian_package(development libdot-dev libdevel "This package has what hosts in C and C++ are built with.")
list(JOIN depends ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS)
if(TARGET dot_python)
  dot_debian_package(python python3-dot-slam python "This package is for Python 3.")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_ARCHITECTURE all)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS OFF)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
      "libdot-capi0 (= ${PROJECT_VERSION}), python3 (>= 3.9), python3-numpy (>= 1:1.21)")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS python3-opencv) # python3 -m dot_slam
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
      "${PROJECT_SOURCE_DIR}/python/debian/postinst;${PROJECT_SOURCE_DIR}/python/debian/prerm")
endif()
if(DOT_INSTALL_TOOLS)
  dot_debian_package(tools dot-tools science "This package has its programs for recorded sequences.")
  foreach(program IN ITEMS dot_run dot_eval)
    dot_install_zipped("${PROJECT_SOURCE_DIR}/cmake/debian/${program}.1" man/man1 tools)
  endforeach()
endif()
include(CPack)
