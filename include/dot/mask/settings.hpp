// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

namespace dot {

/// Association, propagation and labels.
struct MaskSettings {
  double min_iou = 0.2;          ///< least overlap of an instance with the track that it continues
  double min_containment = 0.7;  ///< half of min_iou is enough if this share of the smaller is covered
  double keep_seconds = 1.0;     ///< a track without mask and motion lives this long
  double late_seconds = 1.0;     ///< late masks are accepted so long, at 7 bytes a pixel for each frame; 0: never
  int late_frames = 64;          ///< and for so many frames at most: bounds the memory at any frame rate
  double depth_tolerance = 0.3;  ///< relative: predicted mask pixels whose measured depth differs more are trimmed
  int min_pixels = 30;           ///< smaller masks start no track, and smaller predicted masks are not shown
  int max_instances = 1024;      ///< of one segmentation; more are an error: mostly the image is no id image
};

}  // namespace dot
