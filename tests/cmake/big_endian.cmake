# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
#
# SOURCE does not configure for a big-endian machine, and says why. FOLDER: to work in.

file(REMOVE_RECURSE "${FOLDER}")
file(WRITE "${FOLDER}/big_endian_machine.cmake" "set(CMAKE_CXX_BYTE_ORDER BIG_ENDIAN)\n")
execute_process(
  COMMAND "${CMAKE_COMMAND}" -S "${SOURCE}" -B "${FOLDER}/build" -G "${GENERATOR}" "-DCMAKE_CXX_COMPILER=${COMPILER}"
          "-DCMAKE_TOOLCHAIN_FILE=${TOOLCHAIN}" "-DCMAKE_PROJECT_dot_INCLUDE=${FOLDER}/big_endian_machine.cmake"
  RESULT_VARIABLE status
  OUTPUT_VARIABLE output
  ERROR_VARIABLE output)
if(status EQUAL 0 OR NOT output MATCHES "dot does not support big-endian machines")
  message(FATAL_ERROR "configured for a big-endian machine with status ${status}:\n${output}")
endif()
