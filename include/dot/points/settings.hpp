// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

namespace dot {

/// Selection of the pixels of a frame that become points.
struct SelectionSettings {
  int background_points = 2000;   ///< budget for the background of one frame
  int object_points = 300;        ///< budget for one object
  int min_object_pixels = 60;     ///< smaller masks get no points
  double min_depth_share = 0.15;  ///< of an object's pixels; fewer depths may be wrong, those of a lidar if far off
  double min_gradient = 2.5;      ///< grey values per pixel, background
  double object_gradient = 4;     ///< grey values per pixel; half of it if that gives few points
  double max_depth = 400;         ///< metres; farther depth counts as not measured
  int window_radius = 5;          ///< pixels: half size of the window whose plane gives a point its depth
};

}  // namespace dot
