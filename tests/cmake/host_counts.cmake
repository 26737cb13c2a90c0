# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
#
# PLAIN and HOST, the same host without and with dot, run with ARGUMENTS on the sample. Without, LEAST features are on
# movers at least, otherwise this means nothing. With dot
#  - a twentieth of the features on movers is left at most;
#  - from the ninth frame on parked cars have as many features as without, no single frame less than half (one car stays
#    undecided for longer when the depth is from stereo);
#  - there are as many features in all, but for a hundredth.

set(settled 8) # frames, 0.8 s

# Stores in <out>_<kind> the features of all frames, in <out>_parked_late those from `settled` on, in
# <out>_parked_<frame> those of each.
function(count out program)
  execute_process(COMMAND "${program}" ${ARGUMENTS} OUTPUT_VARIABLE text
                  ERROR_VARIABLE complaints COMMAND_ERROR_IS_FATAL ANY)
  if(complaints)
    message(FATAL_ERROR "${program} complains:\n${complaints}")
  endif()
  foreach(name IN ITEMS all movers parked parked_late)
    set(${name} 0)
  endforeach()
  string(REGEX MATCHALL "frame [^\n]*" lines "${text}")
  list(LENGTH lines frames)
  if(NOT frames EQUAL 24)
    message(FATAL_ERROR "${frames} frames:\n${text}")
  endif()
  foreach(line IN LISTS lines)
    string(REGEX MATCH "frame ([0-9]+): ([0-9]+) features, ([0-9]+) on movers, ([0-9]+) on parked" found "${line}")
    set(frame ${CMAKE_MATCH_1})
    math(EXPR all "${all} + ${CMAKE_MATCH_2}")
    math(EXPR movers "${movers} + ${CMAKE_MATCH_3}")
    math(EXPR parked "${parked} + ${CMAKE_MATCH_4}")
    set(${out}_parked_${frame} ${CMAKE_MATCH_4} PARENT_SCOPE)
    if(NOT frame LESS settled)
      math(EXPR parked_late "${parked_late} + ${CMAKE_MATCH_4}")
    endif()
  endforeach()
  foreach(name IN ITEMS all movers parked parked_late)
    set(${out}_${name} ${${name}} PARENT_SCOPE)
  endforeach()
  set(${out}_text "${text}" PARENT_SCOPE)
endfunction()

count(before "${PLAIN}")
count(after "${HOST}")
if(NOT after_text MATCHES "dot: images of 620 x 188")
  message(FATAL_ERROR "no word of the tracker's beginning:\n${after_text}")
endif()
foreach(name IN ITEMS all movers parked parked_late)
  message(STATUS "${name}: ${before_${name}} without dot, ${after_${name}} with it")
endforeach()
math(EXPR movers "${before_movers} / 20")
math(EXPR all "${before_all} * 99 / 100")
if(before_movers LESS LEAST OR before_parked_late LESS LEAST)
  message(FATAL_ERROR "too few features on cars for this test to mean anything")
endif()
if(after_movers GREATER movers)
  message(FATAL_ERROR "features on movers: more than ${movers}")
endif()
if(after_parked_late LESS before_parked_late)
  message(FATAL_ERROR "features on parked cars from frame ${settled} on: less than ${before_parked_late}")
endif()
foreach(frame RANGE ${settled} 23)
  math(EXPR parked "${before_parked_${frame}} / 2")
  if(after_parked_${frame} LESS parked)
    message(FATAL_ERROR "features on parked cars in frame ${frame}: ${after_parked_${frame}}, less than ${parked}")
  endif()
endforeach()
if(after_all LESS all)
  message(FATAL_ERROR "features in all: less than ${all}")
endif()
