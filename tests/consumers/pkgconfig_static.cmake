# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
#
# Links one host in C and one in C++ by `pkg-config --static`, against the archives of PREFIX: a copy of it in WORK
# without its shared libraries, so that nothing else can be what is linked. PKG_CONFIG, READELF, LIBDIR, C_COMPILER,
# CXX_COMPILER, C_FLAGS, CXX_FLAGS; with CAPI also the C library.

cmake_minimum_required(VERSION 3.22)

include("${CMAKE_CURRENT_LIST_DIR}/../cmake/Run.cmake")

file(REMOVE_RECURSE "${WORK}")
file(COPY "${PREFIX}/" DESTINATION "${WORK}/prefix" PATTERN "*.so*" EXCLUDE PATTERN "*.dylib" EXCLUDE)
set(ENV{PKG_CONFIG_PATH} "${WORK}/prefix/${LIBDIR}/pkgconfig")

# link(<package> <file> <compiler> <flags>...)
function(link package file compiler)
  run("${PKG_CONFIG}" --static --cflags --libs ${package})
  string(STRIP "${output}" flags)
  separate_arguments(flags UNIX_COMMAND "${flags}")
  run("${compiler}" ${ARGN} "${CMAKE_CURRENT_LIST_DIR}/${file}" ${flags} -o "${WORK}/${package}_host")
  run("${WORK}/${package}_host")
  run("${READELF}" -d "${WORK}/${package}_host")
  if(output MATCHES "libdot" OR NOT output MATCHES "libopencv_core")
    message(FATAL_ERROR "the host of ${package} is linked with\n${output}")
  endif()
endfunction()

separate_arguments(C_FLAGS UNIX_COMMAND "${C_FLAGS}")
separate_arguments(CXX_FLAGS UNIX_COMMAND "${CXX_FLAGS}")
link(dot_core add_subdirectory/main.cpp "${CXX_COMPILER}" -std=c++17 ${CXX_FLAGS})
if(CAPI)
  link(dot_capi c/main.c "${C_COMPILER}" -std=c99 ${C_FLAGS})
endif()
