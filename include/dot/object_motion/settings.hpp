// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

namespace dot {

/// The conditions for accepting an object's motion, and the range of its search.
struct ObjectSettings {
  int min_points = 30;               ///< inside the image
  double min_visible = 0.25;         ///< share of the object's points inside the image
  double min_phi = 0.85;             ///< Pearson correlation
  double min_phi_expected = 0.75;    ///< of a fit that agrees with the known velocity; below min_phi it is no evidence
  int min_inliers = 20;              ///< points that fit the line between intensities
  double min_inlier_share = 0.4;     ///< of the visible points
  double min_depth_agreement = 0.6;  ///< share of the points that the measured depth confirms
  double max_speed = 70;             ///< m/s
  double max_acceleration = 12;      ///< m/s^2
  double search_speed = 30;          ///< m/s: largest velocity hypothesis of a new object
  double reference_seconds = 0.4;    ///< age of the oldest reference used for slow objects
  int max_fitted = 100;              ///< most objects whose motion is estimated, the largest; others are predicted
};

/// Priors of an object's motion between frames, as rates per second. Generic: roads are not assumed.
struct MotionPriorSettings {
  double rotation = 0.35;       ///< rad/s, 1 sigma, any axis
  double velocity = 40;         ///< m/s, 1 sigma, any axis, about standing still
  double gain = 0.1;            ///< 1 sigma of an object's gain about the camera's
  double offset = 10;           ///< grey values, 1 sigma of an object's offset about the camera's
  bool ground_vehicle = false;  ///< rotate about the up vector only, move in the ground plane
  double up_x = 0;              ///< up, camera axes (used with ground_vehicle)
  double up_y = -1;             ///< down is positive y
  double up_z = 0;              ///< ahead is positive z
};

}  // namespace dot
