# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT

include(GoogleTest)

set(DOT_TEST_TIMEOUT 300 CACHE STRING "seconds that one test may take; more where an emulator runs it")

# Left out with sanitizers: long films, statistics over many seeds and counts of allocations, of code that other tests run
# as well.
set(unsanitized
    Belt.BeforeAStandingCameraIsNotTheScene
    DepthGradient.LeftOutOfTheDerivativeItCostsNothingOnSlantedPlanes
    Departing.FlipsWithinHalfASecond
    FixedPart.IsNotSuspectedInAScene
    FixedPart.IsNotTheSceneInWhichALorryPassesAStandingCamera
    Flicker.ChangesNoDecision
    *FrameRate.*
    LostCamera.MakesNothingMove
    *MissedMask.*
    Overlay.IsNotACarAheadOfTheSameSpeed
    RollingShutterPipeline.NorByAHostsMotionOfTheMiddleRow
    RollingShutterPipeline.TheCamerasMotionIsThatOfTheMiddleRow
    RollingShutterPipeline.WhatStandsIsNotCalledMoving
    SteadyState.*)
if(CMAKE_CXX_FLAGS MATCHES "-fsanitize=thread")
  list(APPEND unsanitized *OnOpenCvsThreads*) # see dev.sh
endif()

# dot_test_program(<target> <module> [LABELS <label>...]): the tests of a GoogleTest program, as <module>.<suite>.<name>.
# With sanitizers a program takes most of a second to start, so there all of its tests are one, named <module>.
function(dot_test_program target module)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "" "LABELS")
  if(sanitized)
    list(JOIN unsanitized ":" filter)
    set(shards 1)
    if(module STREQUAL "pipeline") # which takes as long as all others
      set(shards 2)
    endif()
    foreach(shard RANGE 1 ${shards})
      set(name ${module})
      if(shards GREATER 1)
        set(name ${module}.${shard})
      endif()
      math(EXPR index "${shard} - 1")
      add_test(NAME ${name} COMMAND ${target} --gtest_brief=1 --gtest_filter=-${filter})
      set_tests_properties(${name} PROPERTIES TIMEOUT 1200 LABELS "${arg_LABELS}"
                                              ENVIRONMENT "GTEST_TOTAL_SHARDS=${shards};GTEST_SHARD_INDEX=${index}")
    endforeach()
  else()
    gtest_discover_tests(${target} TEST_PREFIX ${module}. DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT ${DOT_TEST_TIMEOUT} LABELS "${arg_LABELS}")
  endif()
endfunction()
