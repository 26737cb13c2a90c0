# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
#
# Builds the wheel, with the C library LIBRARY, installs it into a new virtual environment, which has numpy and OpenCV of
# PYTHON, and runs SEQUENCE from an empty folder. The labels must be the files in EXPECTED, which dot_run has written.

cmake_minimum_required(VERSION 3.22)

include("${CMAKE_CURRENT_LIST_DIR}/../cmake/Run.cmake")
set(RUN_IN "${WORK}/empty")

# setuptools writes into its sources.
file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}/empty")
file(COPY "${SOURCE}/python" DESTINATION "${WORK}/source" PATTERN build EXCLUDE PATTERN "*.egg-info" EXCLUDE
     PATTERN "*.so.*" EXCLUDE)
file(COPY "${SOURCE}/LICENSE" DESTINATION "${WORK}/source")
file(COPY "${SOURCE}/include/dot/version.hpp" DESTINATION "${WORK}/source/include/dot")

unset(ENV{PYTHONPATH})
set(ENV{PIP_DISABLE_PIP_VERSION_CHECK} 1)
set(ENV{DOT_SLAM_LIBRARY} "${LIBRARY}")
run("${PYTHON}" -m pip wheel --no-build-isolation --no-deps --no-index -w "${WORK}/wheels" "${WORK}/source/python")
file(GLOB wheel "${WORK}/wheels/dot_slam-*-py3-none-*.whl")
if(NOT wheel OR wheel MATCHES "-any\\.whl")
  message(FATAL_ERROR "no wheel for any Python 3 and this platform:\n${output}")
endif()

run("${PYTHON}" -m venv --system-site-packages "${WORK}/venv")
set(python "${WORK}/venv/bin/python")
run("${python}" -m pip install --no-index --no-deps "${wheel}")
run("${python}" -c "print(__import__('dot_slam').__file__)")
if(NOT output MATCHES "^${WORK}/venv/")
  message(FATAL_ERROR "another dot_slam was imported: ${output}")
endif()
run("${python}" -m dot_slam "${SEQUENCE}" --out results)
file(GLOB expected "${EXPECTED}/*.png")
list(LENGTH expected count)
if(count EQUAL 0)
  message(FATAL_ERROR "${EXPECTED} holds no labels")
endif()
foreach(label IN LISTS expected)
  get_filename_component(name "${label}" NAME)
  run("${CMAKE_COMMAND}" -E compare_files "${label}" "results/labels/${name}")
endforeach()
message(STATUS "${count} label images as of dot_run")
