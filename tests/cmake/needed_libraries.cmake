# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
#
# LIBRARY names no other library than those that it is known to need; above all neither libGL nor X11.

execute_process(COMMAND "${READELF}" -d "${LIBRARY}" OUTPUT_VARIABLE dynamic COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "NEEDED[^\n]*" needed "${dynamic}")
string(REGEX MATCHALL "lib(opencv_core|stdc\\+\\+|c\\+\\+)" found "${needed}")
list(LENGTH found count)
if(NOT count EQUAL 2)
  message(FATAL_ERROR "${LIBRARY} needs neither OpenCV nor C++? This test looks at the wrong thing:\n${needed}")
endif()
foreach(entry IN LISTS needed)
  if(NOT entry MATCHES "(lib(opencv_core|opencv_imgproc|stdc\\+\\+|c\\+\\+|c\\+\\+abi|m|gcc_s|c|pthread)|ld-[a-z0-9-]+)\\.so")
    message(FATAL_ERROR "${LIBRARY}: unexpected ${entry}")
  endif()
endforeach()
