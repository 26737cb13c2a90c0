// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

/// @file
/// Definitions of camera_motion/camera_step.hpp, which includes this file.

DOT_BEGIN_NAMESPACE

DOT_INLINE CameraSince CameraSince::after(const SE3d& T_cur_prev, const Matrix6<double>& step_covariance,
                                          double step_gain, double step_offset) const {
  const Matrix6<double> Ad = T_cur_prev.adjoint();
  return {T_cur_prev * T_now_ref, Ad * covariance * Ad.transpose() + step_covariance, gain * step_gain,
          step_gain * offset + step_offset, intervals + 1};
}

DOT_END_NAMESPACE
