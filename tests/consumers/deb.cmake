# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
#
# Makes the Debian packages of BUILD in WORK, unpacks them, and builds and runs the consumer in C against what was in
# them; where PYTHON is one with numpy, DEMO too. LINTIAN, where it is found, must have nothing to say. CPACK, DPKG_DEB,
# LIBDIR, GENERATOR, C_COMPILER.

cmake_minimum_required(VERSION 3.22)

include("${CMAKE_CURRENT_LIST_DIR}/../cmake/Run.cmake")

file(REMOVE_RECURSE "${WORK}")
run("${CPACK}" -G DEB --config "${BUILD}/CPackConfig.cmake" -B "${WORK}/packages")
foreach(package IN ITEMS libdot-capi0 libdot-dev python3-dot-slam)
  file(GLOB deb "${WORK}/packages/${package}_*.deb")
  if(NOT deb)
    message(FATAL_ERROR "no package ${package}:\n${output}")
  endif()
  run("${DPKG_DEB}" -f "${deb}" Depends)
  set(depends_${package} "${output}")
  run("${DPKG_DEB}" -c "${deb}")
  set(content_${package} "${output}")
  run("${DPKG_DEB}" -x "${deb}" "${WORK}/root")
endforeach()

if(LINTIAN)
  file(GLOB debs "${WORK}/packages/*.deb")
  set(suppress)
  if(LIBDIR STREQUAL "lib") # a build that was not configured for /usr
    set(suppress --suppress-tags pkg-config-unavailable-for-cross-compilation)
  endif()
  run("${LINTIAN}" --print-version)
  set(fail_on error)
  if(output MATCHES "^2\\.116\\.") # of Debian 12; others have other warnings
    set(fail_on error,warning)
  endif()
  run("${LINTIAN}" --fail-on ${fail_on} --allow-root ${suppress} ${debs})
endif()

# A host needs the library and nothing else at run time.
if(NOT content_libdot-capi0 MATCHES "libdot_capi\\.so\\.0" OR content_libdot-capi0 MATCHES "(include|\\.so\n|\\.so ->|\\.a\n)")
  message(FATAL_ERROR "libdot-capi0 holds\n${content_libdot-capi0}")
endif()
if(NOT depends_libdot-capi0 MATCHES "libopencv-core" OR depends_libdot-capi0 MATCHES "-dev|libgl|libx11")
  message(FATAL_ERROR "libdot-capi0 depends on ${depends_libdot-capi0}")
endif()
if(NOT depends_libdot-dev MATCHES "libdot-capi0 .*libeigen3-dev, libopencv-dev")
  message(FATAL_ERROR "libdot-dev depends on ${depends_libdot-dev}")
endif()

set(modules usr/lib/python3/dist-packages)
if(NOT content_python3-dot-slam MATCHES "/${modules}/dot_slam/__init__\\.py"
   OR NOT content_python3-dot-slam MATCHES "/dot_slam/py\\.typed" OR content_python3-dot-slam MATCHES "pycache|\\.so")
  message(FATAL_ERROR "python3-dot-slam holds\n${content_python3-dot-slam}")
endif()
if(NOT depends_python3-dot-slam MATCHES "libdot-capi0 .*python3 .*python3-numpy")
  message(FATAL_ERROR "python3-dot-slam depends on ${depends_python3-dot-slam}")
endif()

get_filename_component(here "${CMAKE_CURRENT_LIST_DIR}" ABSOLUTE)
run("${CMAKE_COMMAND}" -S "${here}/c" -B "${WORK}/host" -G "${GENERATOR}" "-DCMAKE_C_COMPILER=${C_COMPILER}"
    "-Ddot_ROOT=${WORK}/root/usr")
run("${CMAKE_COMMAND}" --build "${WORK}/host")
run("${WORK}/host/host")
if(PYTHON)
  file(GLOB library "${WORK}/root/usr/lib/libdot_capi.so.0" "${WORK}/root/usr/lib/*/libdot_capi.so.0")
  get_filename_component(library "${library}" DIRECTORY)
  run("${CMAKE_COMMAND}" -E env "PYTHONPATH=${WORK}/root/${modules}" "LD_LIBRARY_PATH=${library}" "${PYTHON}" -B "${DEMO}")
endif()
