# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
#
# The interface of the shared LIBRARY of the compiled tier, as FOLDER (src/abi) has it: what it exports of our own, and
# the layout of the types, printed by the program LAYOUT. With ACCEPT, FOLDER is written. NM, EMULATOR.

cmake_minimum_required(VERSION 3.22)

execute_process(COMMAND "${NM}" -D --defined-only --demangle "${LIBRARY}" OUTPUT_VARIABLE symbols
                COMMAND_ERROR_IS_FATAL ANY)
# Instantiations of the standard library differ from compiler to compiler; no host looks for them here.
string(REGEX MATCHALL "[A-Za-z] (dot::|(vtable|typeinfo|typeinfo name) for dot::)[^\n]*" symbols "${symbols}")
list(TRANSFORM symbols REPLACE "^. " "")
list(REMOVE_DUPLICATES symbols) # constructors and destructors have several
list(SORT symbols)
list(JOIN symbols "\n" exports)
if(NOT exports)
  message(FATAL_ERROR "${LIBRARY} exports nothing of dot")
endif()
execute_process(COMMAND ${EMULATOR} "${LAYOUT}" OUTPUT_VARIABLE layout COMMAND_ERROR_IS_FATAL ANY)

if(ACCEPT)
  file(WRITE "${FOLDER}/exports.txt" "${exports}\n")
  file(WRITE "${FOLDER}/layout.txt" "${layout}")
  return()
endif()

set(changes)
foreach(part IN ITEMS exports layout)
  file(STRINGS "${FOLDER}/${part}.txt" accepted)
  string(STRIP "${${part}}" now)
  string(REPLACE "\n" ";" now "${now}")
  # Demanglers do not agree on spaces between closing angle brackets.
  list(TRANSFORM accepted REPLACE "> +>" ">>")
  list(TRANSFORM now REPLACE "> +>" ">>")
  if(NOT accepted STREQUAL now)
    set(gone ${accepted})
    list(REMOVE_ITEM gone ${now})
    set(new ${now})
    list(REMOVE_ITEM new ${accepted})
    list(TRANSFORM gone PREPEND "\n- ")
    list(TRANSFORM new PREPEND "\n+ ")
    string(APPEND changes "\n${part}.txt:" ${gone} ${new})
  endif()
endforeach()
if(changes)
  message(FATAL_ERROR "not the interface of ${FOLDER}. If it is meant, ./dev.sh abi accept writes it, CHANGELOG.md "
                      "says so, and the next version is another minor one.${changes}")
endif()
