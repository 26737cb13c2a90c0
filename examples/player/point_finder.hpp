// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <opencv2/core.hpp>
#include <vector>

#include "dot/camera/intrinsics.hpp"
#include "dot/pipeline/options.hpp"
#include "dot/pipeline/result.hpp"
#include "sequence/sequence.hpp"

namespace player {

/// The pixels of a frame by which motion can be measured: those with texture and depth, chosen as the tracker chooses
/// its points (dot/points/select.hpp). A result does not tell them, so they are chosen again here, by the settings'
/// depth noise instead of the learnt one.
class PointFinder {
 public:
  PointFinder(const dot::Intrinsics& camera, const dot::Options& options);
  ~PointFinder();

  /// By track id; those of the background have the id 0.
  std::map<std::uint32_t, std::vector<cv::Point>> find(const runner::SequenceFrame& frame, const dot::Result& result);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace player
