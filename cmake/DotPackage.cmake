# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT

# cpack -G DEB in the build folder makes Debian packages: libdot-capi0, the shared C library, which hosts depend on;
# libdot-dev, to build hosts with; python3-dot-slam, the Python package; dot-tools, the programs, where they are installed.

set(CPACK_PACKAGE_NAME dot)
set(CPACK_PACKAGE_CONTACT "The dot authors <dot@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_COMPONENTS_ALL development)
if(TARGET dot_capi OR BUILD_SHARED_LIBS)
  list(APPEND CPACK_COMPONENTS_ALL libraries)
  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libdot-capi0 (= ${PROJECT_VERSION}), ")
endif()
if(TARGET dot_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
if(DOT_INSTALL_TOOLS)
  list(APPEND CPACK_COMPONENTS_ALL tools)
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON) # of what is compiled; the rest is stated here
set(CPACK_DEBIAN_LIBRARIES_PACKAGE_NAME libdot-capi0)
set(CPACK_DEBIAN_LIBRARIES_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libdot-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libeigen3-dev, libopencv-dev")
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-dot-slam)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "libdot-capi0 (= ${PROJECT_VERSION}), python3 (>= 3.9), python3-numpy (>= 1:1.21)")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS python3-opencv) # python3 -m dot_slam
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA "${PROJECT_SOURCE_DIR}/python/debian/postinst;${PROJECT_SOURCE_DIR}/python/debian/prerm")
set(CPACK_DEBIAN_TOOLS_PACKAGE_NAME dot-tools)
set(CPACK_DEBIAN_TOOLS_PACKAGE_SECTION science)
include(CPack)
