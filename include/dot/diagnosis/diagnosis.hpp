// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace dot {

/// What may be wrong with the input. With each its figure.
enum class Suspicion : std::uint8_t {
  None,              ///< nothing; figure 0
  ImplausibleTimes,  ///< steps between frames that no camera has; the last one, seconds
  RepeatedImages,    ///< images that are those of the frame before; share of the last frames, 0 to 1
  TooLittleDepth,    ///< share of the pixels with depth, 0 to 1, if there are too few points to track. What lies beyond
                     ///< `selection.max_depth` has none: in another unit that may be all
  TooLittleTexture,  ///< share of frames with too few points to track though they have depth, 0 to 1
  ImplausibleDepth,  ///< depths that no scene has, so that their unit may be wrong; the typical one, metres
  DepthOutOfStep,    ///< depth that is of another frame than the image; frames by which it is late, negative: early
  MasksCoverImage,   ///< masks that leave too few background points to track; the share that they cover, 0 to 1
  SaturatedDepth,    ///< depth that is cut off at a largest value instead of missing; share of the pixels, 0 to 1
  FixedPart,         ///< a part of the image that does not move with the scene; share of the image, 0 to 1
  RollingShutter,    ///< rows that a turning camera shows turned against each other; first to last row, radians. Wrong
                     ///< intrinsics, and depth that is no z, look like it
  UnsteadyScale,     ///< depth whose scale differs from frame to frame, as that of a network; its sigma, relative
  HostMotion,        ///< Frame::camera_motion that the image refutes and that was not used; error, pixels in the image
  LensDistortion     ///< radial distortion that the camera model lacks, or depth along the ray; pixels, at a corner
};

/// Name of a suspicion, lower case with underscores; empty for None.
constexpr const char* to_string(Suspicion suspicion) {
  constexpr const char* names[] = {"",
                                   "implausible_times",
                                   "repeated_images",
                                   "too_little_depth",
                                   "too_little_texture",
                                   "implausible_depth",
                                   "depth_out_of_step",
                                   "masks_cover_image",
                                   "saturated_depth",
                                   "fixed_part",
                                   "rolling_shutter",
                                   "unsteady_scale",
                                   "host_motion",
                                   "lens_distortion"};
  return suspicion <= Suspicion::LensDistortion ? names[static_cast<int>(suspicion)] : "?";
}

/// What the tracker suspects of its input. It says so of the last frames, and takes it back when they are better.
struct Diagnosis {
  Suspicion reason = Suspicion::None;  ///< the gravest suspicion
  double figure = 0;                   ///< in the unit that `Suspicion` names
};

}  // namespace dot
