// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

namespace dot {

/// A rectified pinhole camera and, for stereo, its baseline. Pixel centres at integer coordinates.
struct Intrinsics {
  double fx = 0;        ///< pixels
  double fy = 0;        ///< pixels
  double cx = 0;        ///< pixels
  double cy = 0;        ///< pixels
  int width = 0;        ///< pixels
  int height = 0;       ///< pixels
  double baseline = 0;  ///< metres; 0 if the depth does not come from stereo
};

}  // namespace dot
