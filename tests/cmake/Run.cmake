# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT

# run(COMMAND ARGUMENT...): in the folder RUN_IN, if that is set. What it prints is in `output`. Fails where the command
# does.
function(run)
  set(folder)
  if(RUN_IN)
    set(folder WORKING_DIRECTORY "${RUN_IN}")
  endif()
  execute_process(COMMAND ${ARGN} ${folder} OUTPUT_VARIABLE out ERROR_VARIABLE out RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGN}: ${status}\n${out}")
  endif()
  set(output "${out}" PARENT_SCOPE)
endfunction()
