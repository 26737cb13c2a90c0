// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <opencv2/core.hpp>

#include "dot/camera/intrinsics.hpp"
#include "dot/pipeline/result.hpp"
#include "outlines.hpp"
#include "sequence/sequence.hpp"

namespace player {

/// Where the objects of the frame before are expected in the new one, by the motions that were found: each labelled
/// pixel, at its depth, moved by the camera's motion and the object's (by its fused velocity where the new frame did
/// not measure it; not at all if it was last decided to be static).
///
/// Beside a network's outline it shows whether motion and mask agree. The tracker's own prediction is made before it
/// measures, and is not part of a result.
class MovedOutlines {
 public:
  explicit MovedOutlines(const dot::Intrinsics& camera) : camera_(camera) {}

  /// The outlines by track id, and keeps what the next frame needs. None after a camera motion that is a guess, or
  /// where an object had no depth.
  std::map<std::uint32_t, Outlines> next(const runner::SequenceFrame& frame, const dot::Result& result);

 private:
  Outlines moved(const dot::ObjectResult& object, const cv::Rect& box, const dot::Result& result) const;

  dot::Intrinsics camera_;
  cv::Mat ids_;    ///< of the frame before, CV_32SC1
  cv::Mat depth_;  ///< of the frame before, CV_32FC1, metres
  std::map<std::uint32_t, cv::Rect> boxes_;
};

}  // namespace player
