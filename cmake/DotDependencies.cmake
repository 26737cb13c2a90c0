# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT

# Also in the installed package configuration.
set(DOT_EIGEN_MINIMUM 3.3)
set(DOT_OPENCV_MINIMUM 4.5)

# No version in the call: Eigen's package accepts only its own major version, so asking for 3.3 would refuse Eigen 5.
find_package(Eigen3 CONFIG REQUIRED)
if(Eigen3_VERSION VERSION_LESS DOT_EIGEN_MINIMUM)
  message(FATAL_ERROR "dot needs Eigen ${DOT_EIGEN_MINIMUM} or newer, found ${Eigen3_VERSION} in ${Eigen3_DIR}")
endif()
find_package(OpenCV ${DOT_OPENCV_MINIMUM} CONFIG REQUIRED COMPONENTS core imgproc)
