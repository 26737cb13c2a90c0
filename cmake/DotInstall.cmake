# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT

include(CMakePackageConfigHelpers)
set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/dot")

# One export file per component, so that loading one never asks for the dependencies of another.
function(dot_install_component component)
  install(
    TARGETS ${ARGN}
    EXPORT dot-${component}
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(EXPORT dot-${component} NAMESPACE dot:: FILE dot-${component}-targets.cmake DESTINATION ${package_dir})
endfunction()

dot_install_component(headers dot_headers)
dot_install_component(core dot_core)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/dot" DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        FILES_MATCHING PATTERN "*.hpp")

if(DOT_BUILD_CAPI)
  dot_install_component(capi dot_capi)
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/capi/include/dot" DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
          FILES_MATCHING PATTERN "*.h")

  # The paths follow from the place of the .pc file, so that the prefix can be moved; an absolute one is taken as it is.
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
  configure_file("${PROJECT_SOURCE_DIR}/cmake/dot_capi.pc.in" "${PROJECT_BINARY_DIR}/dot_capi.pc" @ONLY)
  install(FILES "${PROJECT_BINARY_DIR}/dot_capi.pc" DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endif()

configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/dotConfig.cmake.in" "${PROJECT_BINARY_DIR}/dotConfig.cmake"
                              INSTALL_DESTINATION ${package_dir} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/dotConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/dotConfig.cmake" "${PROJECT_BINARY_DIR}/dotConfigVersion.cmake"
        DESTINATION ${package_dir})
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION ${CMAKE_INSTALL_DATADIR}/licenses/dot)
