// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace dot {

/// Why an object has no motion estimate in this frame (or was dropped after it).
enum class Reason : std::uint8_t {
  None,              ///< it has one
  New,               ///< first seen in this frame, and the frame before gives no motion
  NoReference,       ///< the frames before this one were dropped (gap in time, or reset)
  TooFewPixels,      ///< its mask is too small
  TooLittleDepth,    ///< its mask has too little valid depth
  TooLittleTexture,  ///< too few pixels with a gradient
  LeavesImage,       ///< too small a part of it stays inside the image
  Occluded,          ///< nearer objects hide too much of it
  Diverged,          ///< the alignment did not converge
  LowCorrelation,    ///< reference and tracked intensities do not correlate (phi)
  TooFewInliers,     ///< too few points agree with the fitted line between intensities
  DepthDisagrees,    ///< the motion found contradicts the measured depth
  Implausible,       ///< the motion found is faster than Options::object.max_speed
  Hidden,            ///< it is neither predicted to be visible nor shown by a mask in this frame; or it was discovered,
                     ///< and is not confirmed to move any more
  CameraLost,        ///< no camera motion, hence no object motion
  Lost,              ///< dropped: not seen for longer than Options::mask.keep_seconds, or one of too many
  TooManyObjects     ///< not among the Options::object.max_fitted largest: predicted at its last velocity
};

/// Name of a reason, lower case with underscores; empty for None.
constexpr const char* to_string(Reason reason) {
  constexpr const char* names[] = {"",
                                   "new",
                                   "no_reference",
                                   "too_few_pixels",
                                   "too_little_depth",
                                   "too_little_texture",
                                   "leaves_image",
                                   "occluded",
                                   "diverged",
                                   "low_correlation",
                                   "too_few_inliers",
                                   "depth_disagrees",
                                   "implausible",
                                   "hidden",
                                   "camera_lost",
                                   "lost",
                                   "too_many_objects"};
  return reason <= Reason::TooManyObjects ? names[static_cast<int>(reason)] : "?";
}

}  // namespace dot
