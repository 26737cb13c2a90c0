// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

namespace dot {

/// Association, propagation and labels.
struct MaskSettings {
  double min_iou = 0.2;          ///< an instance continues a track from this overlap on ...
  double min_containment = 0.7;  ///< ... or from half of it on, when this share of the smaller of the two is covered
  double keep_seconds = 1.0;     ///< a track without mask and motion lives this long
  double late_seconds = 1.0;     ///< masks are awaited this long, at 7 bytes a pixel for each frame; 0: not at all
  int late_frames = 64;          ///< likewise for so many frames at most: a bound of the memory at any frame rate
  double depth_tolerance = 0.3;  ///< relative: predicted mask pixels whose measured depth differs more are trimmed
  int min_pixels = 30;           ///< smaller masks start no track, and predicted ones are not shown
  int max_instances = 1024;      ///< of one segmentation; more are refused: mostly an image that holds no instances
};

/// What the caller takes the mask for; see pipeline/exclusion.hpp.
struct ExclusionPolicy {
  bool exclude_not_observable = true;  ///< objects that never were decided; later they count as last decided
  bool exclude_static = false;
  int dilation = 2;  ///< pixels
};

}  // namespace dot
