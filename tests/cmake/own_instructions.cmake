# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
#
# OBJECTS, separated by commas: those of them that are built for more than the build's machine define no function that
# another unit may define too (a weak symbol). The linker might keep this copy for all, and crash on another machine.

string(REPLACE "," ";" objects "${OBJECTS}")
list(FILTER objects INCLUDE REGEX "kernels/avx")
list(LENGTH objects count)
if(NOT count EQUAL 2)
  message(FATAL_ERROR "expected the kernels for AVX2 and AVX-512, found '${objects}': this test looks at the wrong thing")
endif()
foreach(object IN LISTS objects)
  execute_process(COMMAND "${NM}" --defined-only "${object}" OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "[0-9a-f]+ [A-Zu-w] [^\n]+" outside "${symbols}")
  list(FILTER outside EXCLUDE REGEX "[atu]b?san")  # of sanitized builds
  list(LENGTH outside count)
  if(NOT count EQUAL 1 OR NOT outside MATCHES "3dot6kernel[46]avx(2|512)E$")
    list(JOIN outside "\n  " outside)
    message(FATAL_ERROR "${object} defines more, or other, than its table of kernels:\n  ${outside}")
  endif()
endforeach()
