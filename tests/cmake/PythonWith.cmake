# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT

# dot_find_python(<out> <module>...): stores in `out` a Python 3 that has these modules, or nothing: whoever has several
# finds it in any of them.
function(dot_find_python out)
  set(${out} "" PARENT_SCOPE)
  find_program(DOT_PYTHON python3)
  find_program(DOT_SYSTEM_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
  mark_as_advanced(DOT_PYTHON DOT_SYSTEM_PYTHON)
  set(code "import importlib.util, sys; sys.exit(None in map(importlib.util.find_spec, sys.argv[1:]))")
  foreach(python IN LISTS DOT_PYTHON DOT_SYSTEM_PYTHON)
    if(python)
      execute_process(COMMAND "${python}" -c "${code}" ${ARGN} RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
      if(status EQUAL 0)
        set(${out} "${python}" PARENT_SCOPE)
        return()
      endif()
    endif()
  endforeach()
endfunction()
