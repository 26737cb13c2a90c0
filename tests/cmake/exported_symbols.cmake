# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
#
# LIBRARY exports exactly the functions that HEADER declares with DOT_API, and those are the ones in LIST, where each
# change of what is exported has to be written down.

file(READ "${HEADER}" text)
string(REGEX REPLACE "/\\*([^*]|\\*+[^*/])*\\*+/" "" text "${text}")
string(REGEX REPLACE "(//|#)[^\n]*" "" text "${text}")
string(REPLACE ";" "\n" text "${text}")
string(REGEX MATCHALL "DOT_API[^(]*[ *\n](dot_[a-z0-9_]+)[ \n]*\\(" declarations "${text}")
set(declared)
foreach(declaration IN LISTS declarations)
  string(REGEX REPLACE ".*[ *\n](dot_[a-z0-9_]+)[ \n]*\\($" "\\1" name "${declaration}")
  list(APPEND declared ${name})
endforeach()
if(NOT declared)
  message(FATAL_ERROR "${HEADER} declares nothing with DOT_API")
endif()

execute_process(COMMAND "${NM}" -D --defined-only "${LIBRARY}" OUTPUT_VARIABLE lines COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[A-Za-z] [^\n]+" lines "${lines}")
set(exported)
foreach(line IN LISTS lines)
  if(NOT line MATCHES "^A ") # the version node itself
    string(REGEX REPLACE "^. ([^@]+).*" "\\1" name "${line}")
    list(APPEND exported ${name})
  endif()
endforeach()

file(STRINGS "${LIST}" listed)

list(SORT declared)
list(SORT listed)
if(NOT declared STREQUAL listed)
  message(FATAL_ERROR "declared in ${HEADER}:\n  ${declared}\nlisted in ${LIST}:\n  ${listed}")
endif()
list(SORT exported)
if(NOT declared STREQUAL exported)
  message(FATAL_ERROR "declared in ${HEADER}:\n  ${declared}\nexported by ${LIBRARY}:\n  ${exported}")
endif()
