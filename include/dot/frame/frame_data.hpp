// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>

#include "dot/camera/depth_bias.hpp"
#include "dot/frame/depth_measurements.hpp"
#include "dot/image/depth_pyramid.hpp"
#include "dot/image/pyramid.hpp"

DOT_BEGIN_NAMESPACE

/// The stored data of a frame: its image and its depth, at all levels of the pyramid.
struct FrameData {
  std::uint64_t id = 0;        ///< the caller's
  double timestamp = 0;        ///< seconds
  Pyramid pyramid;             ///< of the grey image
  DepthPyramid depth;          ///< 1/m, after `bias` was subtracted
  DepthBias bias;              ///< that was subtracted from `depth`
  DepthMeasurements measured;  ///< of sparse `depth`, if they are far apart
  int repeats = 0;             ///< frames before it, without a gap, that have the same image

  /// Whether the image is that of the frame before because a driver or a host repeated it. Such a frame says nothing
  /// about motion. A longer run comes from a camera that stands and has no noise.
  bool is_repeated() const { return repeats > 0 && repeats <= kLongestRun; }

  static constexpr int kLongestRun = 4;  ///< images that a driver repeats in a row

  /// Of full size, 1/m.
  const Image<float>& inverse_depth() const { return depth.levels[0]; }
};

/// Seconds by which two times that should be equal may differ, by rounding.
inline constexpr double kClockError = 1e-6;

/// A frame lent by the FrameStore; it keeps the frame from being recycled.
using FramePtr = std::shared_ptr<const FrameData>;

DOT_END_NAMESPACE
