// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>

#include "run/segmentation.hpp"
#include "sequence/sequence.hpp"

namespace real_time {

using FramePtr = std::shared_ptr<const runner::SequenceFrame>;

/// Segments a frame: with a network, or by the masks that it has.
using FrameSegmenter = std::function<runner::Segmentation(const runner::SequenceFrame&)>;

/// A network whose masks come late.
struct LateNetwork {
  FrameSegmenter segment;
  std::function<bool(const runner::SequenceFrame& frame)> takes;  ///< whether it is to see this frame
  double seconds = 0;                                             ///< that it takes for a frame, at least
};

/// The masks of a frame, which come after it. Times are in seconds of one clock.
struct LateSegmentation {
  int frame = 0;        ///< its number
  double captured = 0;  ///< when the frame came
  double done = 0;      ///< when its masks came
  runner::Segmentation segmentation;
};

}  // namespace real_time
