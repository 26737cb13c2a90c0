// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

namespace dot {

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
