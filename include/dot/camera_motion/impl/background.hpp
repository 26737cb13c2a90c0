// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

/// @file
/// Definitions of camera_motion/background.hpp, which includes this file.

DOT_BEGIN_NAMESPACE

DOT_INLINE void Background::carry(const CameraStep& step) {
  const Matrix6<double> Ad = step.T_cur_prev.adjoint();
  T_now_points = step.T_cur_prev * T_now_points;
  seconds += step.seconds;
  guess_covariance = (Ad * guess_covariance * Ad.transpose()).eval();
  if (!step.known()) guess_covariance += step.covariance, guessed = true;
}

DOT_END_NAMESPACE
