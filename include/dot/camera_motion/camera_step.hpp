// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/align/aligner.hpp"
#include "dot/camera_motion/rolling_shutter.hpp"
#include "dot/camera_motion/status.hpp"
#include "dot/lie/se3.hpp"

DOT_BEGIN_NAMESPACE

/// The camera's motion from the previous frame to the current one.
struct CameraStep {
  CameraStatus status = CameraStatus::FirstFrame;        ///< how the motion was found
  double seconds = 0;                                    ///< since the previous frame; 0: there is none
  SE3d T_cur_prev;                                       ///< T_c of the paper, for all rows together
  Matrix6<double> covariance = Matrix6<double>::Zero();  ///< of the left twist of T_cur_prev
  RollingShutter rolling;                                ///< what it leaves out; zero if that may be chance
  Alignment alignment;                                   ///< of the background, if there was one

  /// Whether it was measured, not guessed.
  bool known() const { return status == CameraStatus::Tracked || status == CameraStatus::FromHost; }

  /// The step as a row of the image has it: the same, unless a rolling shutter reads the rows one after another while
  /// the camera's turn changes. @param h of the row: -1/2 at the top of the image, 0 in the middle, 1/2 at the bottom.
  CameraStep at_row(double h) const;
};

/// The camera's motion since a past frame, `ref`, composed of several steps. `now` is the frame after the last step.
struct CameraSince {
  SE3d T_now_ref;                                        ///< composed motion
  Matrix6<double> covariance = Matrix6<double>::Zero();  ///< of its left twist
  double gain = 1;                                       ///< I_now = gain I_ref + offset
  double offset = 0;                                     ///< grey values
  int intervals = 0;                                     ///< steps

  /// The motion with one more step.
  CameraSince after(const SE3d& T_cur_prev, const Matrix6<double>& step_covariance, double step_gain,
                    double step_offset) const;
  /// The same, with the step of a frame.
  CameraSince after(const CameraStep& step) const {
    return after(step.T_cur_prev, step.covariance, step.alignment.state.gain, step.alignment.state.offset);
  }
};

DOT_END_NAMESPACE

#ifndef DOT_USES_COMPILED_PIPELINE
#include "dot/camera_motion/impl/camera_step.hpp"
#endif
