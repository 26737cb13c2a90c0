# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
#
# An overlay port that lies beside the sources it builds: vcpkg install "dot[capi]" --overlay-ports=ports

get_filename_component(SOURCE_PATH "${CURRENT_PORT_DIR}/../.." ABSOLUTE)

vcpkg_check_features(
  OUT_FEATURE_OPTIONS FEATURE_OPTIONS
  FEATURES capi DOT_BUILD_CAPI tools DOT_BUILD_EXAMPLES tools DOT_INSTALL_TOOLS)

# A triplet has libraries of one kind.
string(COMPARE EQUAL "${VCPKG_LIBRARY_LINKAGE}" "dynamic" DOT_CAPI_SHARED)
string(COMPARE EQUAL "${VCPKG_LIBRARY_LINKAGE}" "static" DOT_CAPI_STATIC)

vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS
    ${FEATURE_OPTIONS}
    -DDOT_CAPI_SHARED=${DOT_CAPI_SHARED}
    -DDOT_CAPI_STATIC=${DOT_CAPI_STATIC}
    -DDOT_BUILD_TESTS=OFF
    -DDOT_BUILD_BENCH=OFF
    -DDOT_INSTALL=ON
  MAYBE_UNUSED_VARIABLES
    DOT_CAPI_SHARED
    DOT_CAPI_STATIC)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/dot)
vcpkg_fixup_pkgconfig()
if("tools" IN_LIST FEATURES)
  vcpkg_copy_tools(TOOL_NAMES dot_run dot_eval AUTO_CLEAN)
endif()

file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
file(INSTALL "${CMAKE_CURRENT_LIST_DIR}/usage" DESTINATION "${CURRENT_PACKAGES_DIR}/share/${PORT}")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
