# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
#
# OBJECTS, separated by commas, of the compiled tier contain no function of Eigen or of the header tier under a name that a host's own code may
# have too: a linker would keep one of the two, whatever flags it was compiled with. See src/CMakeLists.txt.

string(REPLACE "," ";" OBJECTS "${OBJECTS}")
execute_process(COMMAND "${NM}" ${OBJECTS} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
if(NOT symbols MATCHES "3dot7Tracker" OR NOT symbols MATCHES "14dot_core_eigen")
  message(FATAL_ERROR "${OBJECTS} lack dot::Tracker or any code of Eigen: this test looks at the wrong thing")
endif()
string(REGEX MATCHALL "[^\n ]*([^0-9]5Eigen|3dot[67]eigen(0|16|32|64))[^\n]*" shared "${symbols}")
# Containers and views that compute nothing are the exception.
string(REGEX MATCHALL "[WV] _ZNK?3dot[^\n]*" weak "${symbols}")
list(FILTER weak EXCLUDE REGEX "4core|_ZNK?3dot(7Tracker|5Image|3mat|9image_ref)")
list(APPEND shared ${weak})
if(shared)
  list(JOIN shared "\n  " shared)
  message(FATAL_ERROR "The compiled tier shares names with its host:\n  ${shared}")
endif()
