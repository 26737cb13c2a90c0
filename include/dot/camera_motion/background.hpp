// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "dot/camera/depth_bias.hpp"
#include "dot/camera_motion/camera_step.hpp"
#include "dot/points/point_set.hpp"

DOT_BEGIN_NAMESPACE

/// The points that the camera's motion is measured by: of the newest frame, or of the last one that had enough.
struct Background {
  PointSet points;
  SE3d T_now_points;     ///< camera motion from their frame to the newest one
  double seconds = 0;    ///< from their frame to the newest one
  bool guessed = false;  ///< T_now_points is a guess for a part of the way, whose covariance is
  Matrix6<double> guess_covariance = Matrix6<double>::Zero();

  void forget() noexcept {
    points.clear();
    T_now_points = {};
    seconds = 0;
    guessed = false;
    guess_covariance.setZero();
  }

  /// The frame that `step` leads to has points of its own. @param fresh is left with the old ones, for their memory.
  void replace(PointSet& fresh, const DepthBias& bias) {
    std::swap(points, fresh);
    points.bias = bias;
    T_now_points = {};
    seconds = 0;
    guessed = false;
    guess_covariance.setZero();
  }

  /// It has too few: the present points are to serve for the next frame, too.
  void carry(const CameraStep& step);
};

DOT_END_NAMESPACE

#ifndef DOT_USES_COMPILED_PIPELINE
#include "dot/camera_motion/impl/background.hpp"
#endif
