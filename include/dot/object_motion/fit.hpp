// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/motion/estimate.hpp"
#include "dot/motion/reason.hpp"

DOT_BEGIN_NAMESPACE

/// One object's motion over one interval, or the reason why there is none.
struct ObjectFit {
  Reason reason = Reason::Diverged;                 ///< None if there is a motion
  SE3d T_o;                                         ///< reference camera's axes
  Matrix6<double> sigma = Matrix6<double>::Zero();  ///< Sigma_x: twist of T_o about the moved centroid, photometric
  double phi = 0;                                   ///< Pearson correlation
  int n_points = 0;                                 ///< points inside the image
  int n_inliers = 0;                                ///< of these, points that fit the line between intensities
  MotionEstimate motion;                            ///< velocity and its errors

  /// Whether there is a motion.
  bool ok() const { return reason == Reason::None; }

  /// For a fit to an image taken *before* the reference: the same motion forwards, in the axes of that image's camera.
  /// @param C camera motion from the reference to that image.
  ObjectFit reversed(const SE3d& C) const;
};

DOT_END_NAMESPACE

#ifndef DOT_USES_COMPILED_PIPELINE
#include "dot/object_motion/impl/fit.hpp"
#endif
