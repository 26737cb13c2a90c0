# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT

# Reads the version from version.hpp, its only home, and stores it in `out`.
function(dot_read_version header out)
  file(STRINGS "${header}" lines REGEX "^#define DOT_VERSION_")
  foreach(part MAJOR MINOR PATCH)
    if(NOT lines MATCHES "DOT_VERSION_${part} ([0-9]+)")
      message(FATAL_ERROR "${header}: DOT_VERSION_${part} not found")
    endif()
    set(${part} ${CMAKE_MATCH_1})
  endforeach()
  if(NOT lines MATCHES "DOT_VERSION_STRING \"${MAJOR}\\.${MINOR}\\.${PATCH}\"")
    message(FATAL_ERROR "${header}: DOT_VERSION_STRING is not \"${MAJOR}.${MINOR}.${PATCH}\"")
  endif()
  set(${out} ${MAJOR}.${MINOR}.${PATCH} PARENT_SCOPE)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${header}")
endfunction()
