// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

/// @file
/// Definitions of object_motion/fit.hpp, which includes this file.

DOT_BEGIN_NAMESPACE

DOT_INLINE ObjectFit ObjectFit::reversed(const SE3d& C) const {
  ObjectFit out = *this;
  out.T_o = C * T_o.inverse() * C.inverse();
  Matrix6<double> turn = Matrix6<double>::Zero();
  turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() = C.R * T_o.R.transpose();
  out.sigma = turn * sigma * turn.transpose();
  out.motion = motion.rotated(C.R);
  out.motion.velocity = -out.motion.velocity;
  out.motion.angular_velocity = -out.motion.angular_velocity;
  return out;
}

DOT_END_NAMESPACE
