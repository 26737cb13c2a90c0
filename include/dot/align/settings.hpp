// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/kernel/settings.hpp"

namespace dot {

/// The photometric Gauss-Newton aligner.
struct AlignSettings {
  int max_levels = 5;                               ///< of the image pyramid; fewer are used for small images
  int max_iterations = 12;                          ///< per level
  double huber = 1.345;                             ///< in sigma
  double tukey = 4.685;                             ///< in sigma: redescending cost that ranks local minima
  double gradient_noise = 0.06;                     ///< px: interpolation and model error, times the gradient
  double min_intensity_sigma = 0.8;                 ///< grey values, floor of the residual scale
  double outlier = 3.5;                             ///< in sigma, distance to the fitted line between intensities
  GradientSource gradient = GradientSource::Image;  ///< which gradients the derivatives of the residual use
  KernelVariant kernel = KernelVariant::Auto;       ///< for dot::Tracker; for tests and comparisons
};

/// The conditions for accepting a camera motion.
struct CameraSettings {
  int min_points = 100;  ///< of the background, inside the image; with fewer the status is TooLittleDepth or Lost
  double min_phi = 0.5;  ///< Pearson correlation
  double min_phi_unexpected = 0.85;  ///< the same while the velocity is unknown
  double min_margin = 0.02;   ///< while the velocity is unknown: share by which any other motion must fit worse. It is
                              ///< the standard error of a mean cost over some thousand points
  double min_inliers = 0.35;  ///< share of the visible points
  double multistart_margin = 0.005;  ///< a later start must be better by this share of the cost
  double search_speed = 45;          ///< m/s: range of the starts while the speed is unknown
  double search_turn = 1.2;          ///< rad/s: the same for rotations, up to 0.2 rad
  double max_acceleration = 20;  ///< m/s^2 of the camera; of two motions that explain the image, one within it is taken
  double multistart_shift = 0.8;  ///< metres: range of the shifted starts along the least determined direction
  double covariance_scale = 4;    ///< factor on Sigma_x, because residuals of neighbouring points are correlated
};

}  // namespace dot
