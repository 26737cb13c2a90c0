# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT

# Compiles and runs a program printed in README.md: the fenced block of `language` that follows the line
# `<!-- snippet: <name> -->`. It is given the sample folder as its argument.
function(dot_readme_snippet name language)
  set(readme "${PROJECT_SOURCE_DIR}/README.md")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${readme}")
  file(READ "${readme}" text)

  set(opening "<!-- snippet: ${name} -->\n```${language}\n")
  string(FIND "${text}" "${opening}" begin)
  if(begin EQUAL -1)
    message(FATAL_ERROR "README.md has no block '<!-- snippet: ${name} -->' followed by ```${language}")
  endif()
  string(LENGTH "${opening}" length)
  math(EXPR begin "${begin} + ${length}")
  string(SUBSTRING "${text}" ${begin} -1 text)
  string(FIND "${text}" "\n```" end)
  if(end EQUAL -1)
    message(FATAL_ERROR "README.md: the block '${name}' does not end")
  endif()
  string(SUBSTRING "${text}" 0 ${end} text)

  set(source "${CMAKE_CURRENT_BINARY_DIR}/snippets/${name}.${language}")
  file(CONFIGURE OUTPUT "${source}" CONTENT "@text@\n" @ONLY)
  add_executable(${name} "${source}")
  dot_own_target(${name})
  set_target_properties(${name} PROPERTIES C_STANDARD 99)
  target_link_libraries(${name} PRIVATE ${ARGN})
  add_test(NAME readme.${name} COMMAND ${name} "${PROJECT_SOURCE_DIR}/examples/data/mini")
endfunction()
