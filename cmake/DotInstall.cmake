# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT

include(CMakePackageConfigHelpers)
set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/dot")

# dot_install_component(<component> <target> [<component of the shared library>]): one export file each, so that loading
# one never asks for the dependencies of another.
function(dot_install_component component target)
  set(library libraries ${ARGN})
  list(GET library -1 library)
  install(
    TARGETS ${target}
    EXPORT dot-${component}
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT ${library}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${library} NAMELINK_COMPONENT development
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
  install(EXPORT dot-${component} NAMESPACE dot:: FILE dot-${component}-targets.cmake DESTINATION ${package_dir}
          COMPONENT development)
endfunction()

dot_install_component(headers dot_headers)
dot_install_component(core dot_core core_library)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/dot" DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        COMPONENT development FILES_MATCHING PATTERN "*.hpp")

# What a .pc file says of places follows from its own, so that the prefix can be moved; an absolute one is taken as it is.
foreach(dir INCLUDEDIR LIBDIR)
  if(IS_ABSOLUTE "${CMAKE_INSTALL_${dir}}")
    set(DOT_PC_${dir} "${CMAKE_INSTALL_${dir}}")
  else()
    set(DOT_PC_${dir} "\${prefix}/${CMAKE_INSTALL_${dir}}")
  endif()
endforeach()
if(IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}")
  set(DOT_PC_PREFIX "${CMAKE_INSTALL_PREFIX}")
else()
  file(RELATIVE_PATH up "/prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/prefix")
  string(REGEX REPLACE "/$" "" up "${up}")
  set(DOT_PC_PREFIX "\${pcfiledir}/${up}")
endif()
# OpenCV by its folders: its own opencv4.pc is often not installed, and where it is, it links all its modules, with them
# libGL and X11.
list(TRANSFORM OpenCV_INCLUDE_DIRS PREPEND "-I" OUTPUT_VARIABLE opencv_includes)
list(JOIN opencv_includes " " DOT_PC_OPENCV_CFLAGS)
set(DOT_PC_OPENCV_LIBS "-lopencv_imgproc -lopencv_core")
get_target_property(type opencv_core TYPE)
if(NOT type STREQUAL "INTERFACE_LIBRARY") # as which some package managers describe it: there is no file to ask for
  set(folder "$<TARGET_FILE_DIR:opencv_core>")
  set(known "$<IN_LIST:${folder},${CMAKE_CXX_IMPLICIT_LINK_DIRECTORIES}>")
  string(PREPEND DOT_PC_OPENCV_LIBS "$<$<NOT:${known}>:-L${folder} >")
endif()
# The standard library of C++, for a host in C that links the archive.
set(cxx_libs ${CMAKE_CXX_IMPLICIT_LINK_LIBRARIES})
list(FILTER cxx_libs INCLUDE REGEX "^(stdc|c)\\+\\+$")
list(REMOVE_DUPLICATES cxx_libs)
list(TRANSFORM cxx_libs PREPEND "-l")
list(JOIN cxx_libs " " DOT_PC_CXX_LIBS)

function(dot_install_pkgconfig name)
  configure_file("${PROJECT_SOURCE_DIR}/cmake/${name}.pc.in" "${PROJECT_BINARY_DIR}/${name}.pc.in" @ONLY)
  file(GENERATE OUTPUT "${PROJECT_BINARY_DIR}/${name}.pc" INPUT "${PROJECT_BINARY_DIR}/${name}.pc.in")
  install(FILES "${PROJECT_BINARY_DIR}/${name}.pc" DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
          COMPONENT development)
endfunction()
dot_install_pkgconfig(dot_core)

if(DOT_BUILD_CAPI)
  if(TARGET dot_capi)
    dot_install_component(capi dot_capi)
  endif()
  if(TARGET dot_capi_static)
    dot_install_component(capi_static dot_capi_static)
  endif()
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/capi/include/dot" DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
          COMPONENT development FILES_MATCHING PATTERN "*.h")
  dot_install_pkgconfig(dot_capi)
endif()

configure_file("${PROJECT_SOURCE_DIR}/cmake/dotComponents.cmake.in" "${PROJECT_BINARY_DIR}/dotComponents.cmake" @ONLY)
configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/dotConfig.cmake.in" "${PROJECT_BINARY_DIR}/dotConfig.cmake"
                              INSTALL_DESTINATION ${package_dir} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/dotConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/dotConfig.cmake" "${PROJECT_BINARY_DIR}/dotComponents.cmake"
              "${PROJECT_BINARY_DIR}/dotConfigVersion.cmake" DESTINATION ${package_dir} COMPONENT development)
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION ${CMAKE_INSTALL_DATADIR}/licenses/dot COMPONENT licence)

if(DOT_INSTALL_TOOLS)
  if(NOT DOT_BUILD_EXAMPLES)
    message(FATAL_ERROR "DOT_INSTALL_TOOLS needs DOT_BUILD_EXAMPLES")
  endif()
  install(TARGETS dot_run dot_eval RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT tools)
endif()
