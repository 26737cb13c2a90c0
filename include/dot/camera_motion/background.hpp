// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "dot/camera/depth_bias.hpp"
#include "dot/camera_motion/camera_step.hpp"
#include "dot/points/point_set.hpp"

DOT_BEGIN_NAMESPACE

/// The points by which the camera's motion is measured. They are of the newest frame that had enough points.
struct Background {
  PointSet points;       ///< with their depths and reference intensities
  SE3d T_now_points;     ///< camera motion from their frame to the newest one
  double seconds = 0;    ///< from their frame to the newest one
  bool guessed = false;  ///< T_now_points contains guessed steps, see guess_covariance
  Matrix6<double> guess_covariance = Matrix6<double>::Zero();  ///< of the left twist of the guessed steps' composition

  /// Drops the points. Keeps their memory.
  void forget() noexcept {
    points.clear();
    T_now_points = {};
    seconds = 0;
    guessed = false;
    guess_covariance.setZero();
  }

  /// Takes the points of the newest frame. @param fresh gets the old points, so that their memory is reused.
  void replace(PointSet& fresh, const DepthBias& bias) {
    std::swap(points, fresh);
    points.bias = bias;
    T_now_points = {};
    seconds = 0;
    guessed = false;
    guess_covariance.setZero();
  }

  /// Keeps the present points for the next frame, because the newest frame has too few.
  void carry(const CameraStep& step);
};

DOT_END_NAMESPACE

#ifndef DOT_USES_COMPILED_PIPELINE
#include "dot/camera_motion/impl/background.hpp"
#endif
