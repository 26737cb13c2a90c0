# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT

# Text files of the source tree as constants of a program. Included, it defines dot_embed; run as a script
# (cmake -DNAME= -DOUTPUT= -DFILES= -P), it writes the source file.

# dot_embed(TARGET NAMESPACE::CONSTANT FILE...): adds to TARGET the definition of
# `const std::string_view NAMESPACE::CONSTANT`: the files, one after the other. A change of a file rebuilds it.
function(dot_embed target name)
  string(MAKE_C_IDENTIFIER "${name}" file)
  set(output "${CMAKE_CURRENT_BINARY_DIR}/embedded/${file}.cpp")
  list(TRANSFORM ARGN PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/" OUTPUT_VARIABLE files)
  add_custom_command(
    OUTPUT "${output}"
    COMMAND "${CMAKE_COMMAND}" "-DNAME=${name}" "-DOUTPUT=${output}" "-DFILES=${files}" -P
            "${PROJECT_SOURCE_DIR}/cmake/DotEmbed.cmake"
    DEPENDS ${files} "${PROJECT_SOURCE_DIR}/cmake/DotEmbed.cmake"
    VERBATIM)
  target_sources(${target} PRIVATE "${output}")
endfunction()

if(NOT CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
  return()
endif()

set(bytes)
foreach(file IN LISTS FILES)
  file(READ "${file}" hex HEX)
  string(APPEND bytes "${hex}")
endforeach()
# As numbers, because compilers limit the length of a string literal.
string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
string(REGEX MATCH "^(.*)::(.*)$" matched "${NAME}")
# The files are ASCII: a byte beyond it does not compile where char is signed.
file(
  WRITE "${OUTPUT}"
  "#include <string_view>\n\nnamespace ${CMAKE_MATCH_1} {\n"
  "static constexpr char bytes[] = {${bytes}};\n"
  "extern const std::string_view ${CMAKE_MATCH_2};\n"
  "const std::string_view ${CMAKE_MATCH_2}(bytes, sizeof bytes);\n"
  "}  // namespace ${CMAKE_MATCH_1}\n")
