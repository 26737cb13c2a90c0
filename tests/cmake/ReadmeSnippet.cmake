# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT

include("${CMAKE_CURRENT_LIST_DIR}/Snippet.cmake")

# Compiles and runs a program printed in README.md, see dot_snippet. It is given the sample folder as its argument.
function(dot_readme_snippet name language)
  dot_snippet(README.md ${name} ${language} text)
  set(source "${CMAKE_CURRENT_BINARY_DIR}/snippets/${name}.${language}")
  dot_write("${source}" "${text}")
  add_executable(${name} "${source}")
  dot_own_target(${name})
  set_target_properties(${name} PROPERTIES C_STANDARD 99)
  target_link_libraries(${name} PRIVATE ${ARGN})
  add_test(NAME readme.${name} COMMAND ${name} "${PROJECT_SOURCE_DIR}/examples/data/mini")
  # They print what the log says, which is nothing in a program that does all well.
  set_tests_properties(readme.${name} PROPERTIES FAIL_REGULAR_EXPRESSION "dot: |suspicion")
endfunction()
