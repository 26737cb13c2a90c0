# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT

# Warnings and language mode of one of our own targets. All of it is PRIVATE: nothing reaches a consumer.
function(dot_own_target target)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF C_EXTENSIONS OFF)
  if(MSVC)
    target_compile_options(${target} PRIVATE /W4)
  else()
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow "$<$<COMPILE_LANGUAGE:CXX>:-Wconversion>"
                                             "$<$<COMPILE_LANGUAGE:CXX>:-Wno-sign-conversion>")
  endif()
endfunction()

# One of our libraries: what it exports is stated in its headers, everything else is hidden. PIC, because SLAM systems
# link static libraries into shared ones.
function(dot_own_library target)
  dot_own_target(${target})
  set_target_properties(
    ${target}
    PROPERTIES CXX_VISIBILITY_PRESET hidden
               VISIBILITY_INLINES_HIDDEN ON
               POSITION_INDEPENDENT_CODE ON)
  # A parent project may set -ffast-math for everything in it. Our code needs NaN and infinity, and a library that is
  # linked so would make numbers near zero zeros in its whole process.
  if(NOT MSVC)
    target_compile_options(${target} PRIVATE -fno-fast-math)
    target_link_options(${target} PRIVATE -fno-fast-math)
  endif()
endfunction()
