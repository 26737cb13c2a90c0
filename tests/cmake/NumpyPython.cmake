# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT

# Stores in `out` a Python 3 that has numpy, or nothing: whoever has several finds it in any of them.
function(dot_find_numpy_python out)
  set(${out} "" PARENT_SCOPE)
  find_program(DOT_PYTHON python3)
  find_program(DOT_SYSTEM_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
  mark_as_advanced(DOT_PYTHON DOT_SYSTEM_PYTHON)
  foreach(python IN LISTS DOT_PYTHON DOT_SYSTEM_PYTHON)
    if(python)
      execute_process(COMMAND "${python}" -c "import numpy" RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
      if(status EQUAL 0)
        set(${out} "${python}" PARENT_SCOPE)
        return()
      endif()
    endif()
  endforeach()
  message(STATUS "no Python with numpy: the example in Python is not tested")
endfunction()
