// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "dot/pipeline/result.hpp"
#include "object_score.hpp"
#include "sequence/sequence.hpp"

namespace eval {

/// A frame worth looking at.
struct Picture {
  int frame = 0;
  std::string title;
  std::vector<std::uint8_t> jpeg;
};

/// Keeps pictures of a few telling frames of a run: the worst of each half (most pixels whose motion is told wrongly),
/// and the one in which most moves. Each shows the answer (run/overlay.hpp) and, as white lines, the true movers.
class PictureBook {
 public:
  explicit PictureBook(int frames) : frames_(frames) {}

  /// The next frame, `index` counted from 0.
  /// @param instance true ids, CV_32SC1; may be empty.
  void consider(int index, const runner::SequenceFrame& frame, const runner::TruthEntry& entry, const cv::Mat& instance,
                const FramePixels& pixels, const dot::Result& result, double total_ms);

  /// The pictures in order of time, each frame once.
  std::vector<Picture> take();

 private:
  struct Slot {
    long value = -1;
    Picture picture;
  };

  int frames_ = 0;
  std::array<Slot, 3> slots_;
};

}  // namespace eval
