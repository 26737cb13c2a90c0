// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

/// @file
/// Definitions of camera_motion/camera_step.hpp, which includes this file.

DOT_BEGIN_NAMESPACE

DOT_INLINE CameraStep CameraStep::at_row(double h) const {
  CameraStep out = *this;
  if (!rolling.is_usual) return out;
  out.T_cur_prev = SE3d::exp(rolling.twist(h)) * T_cur_prev;
  out.covariance += rolling.covariance_of_row(h) - rolling.covariance_of_all();
  return out;
}

DOT_INLINE CameraSince CameraSince::after(const SE3d& T_cur_prev, const Matrix6<double>& step_covariance,
                                          double step_gain, double step_offset) const {
  const Matrix6<double> Ad = T_cur_prev.adjoint();
  return {T_cur_prev * T_now_ref, Ad * covariance * Ad.transpose() + step_covariance, gain * step_gain,
          step_gain * offset + step_offset, intervals + 1};
}

DOT_END_NAMESPACE
