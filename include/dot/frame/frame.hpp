// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "dot/image/span.hpp"
#include "dot/image/view.hpp"

/// @file
/// The tracker's input: plain values and views, without Eigen or OpenCV.

namespace dot {

/// One instance of a segmentation. Its mask is either `mask` (any 8-bit image, non-zero = object, placed with its top
/// left corner at x, y of the frame), or, where `mask` is empty, the pixels of Masks::ids that equal `id`.
struct Instance {
  std::uint32_t id = 0;         ///< the caller's, need not be stable from frame to frame
  ImageRef mask;                ///< Grey8 or Id8
  int x = 0;                    ///< pixels
  int y = 0;                    ///< pixels
  std::int32_t class_id = -1;   ///< the caller's, -1 = unknown
  float score = 1;              ///< of the network; of two masks of one object the one with the higher score is kept
  bool always_dynamic = false;  ///< people and other non-rigid objects: always reported as moving (paper, section 3.2)
};

/// The segmentation of one frame: an id image, or a list of instances that may overlap, or an id image with a list that
/// gives class and score of some of its ids. Both empty: the network ran and found nothing.
struct Masks {
  ImageRef ids;              ///< Id8, Id16 or Id32, of the frame's size, 0 = background
  Span<Instance> instances;  ///< may overlap; those that are boxes are cut to the objects in them, by depth
};

/// A camera motion that the host knows better than the tracker, with its covariance.
struct CameraMotion {
  /// T_cur_prev, row-major 3x4: a static point at X in the previous frame's camera is at T_cur_prev X in this one's.
  std::array<double, 12> T_cur_prev{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  /// Of the left twist [translation; rotation], row-major 6x6, metres and radians.
  std::array<double, 36> covariance{};
};

/// One frame. All views are borrowed for the duration of `track` or `label`.
struct Frame {
  std::uint64_t id = 0;        ///< the caller's number of the frame, returned in the result
  double timestamp = 0;        ///< seconds, strictly increasing
  ImageRef image;              ///< Grey8, Bgr8, Rgb8 or Bgra8
  ImageRef depth;              ///< DepthF32 or DepthU16; up to 1 mm, NaN, infinite, 65535 of 16 bits = no measurement
  std::optional<Masks> masks;  ///< absent: no segmentation for this frame, or not yet
  std::optional<CameraMotion> camera_motion;  ///< absent, or refuted by the image: estimated from that
  /// Start of that estimate, from odometry or an IMU: T_cur_prev, row-major 3x4. Absent: constant velocity alone.
  std::optional<std::array<double, 12>> camera_prior;
};

}  // namespace dot
