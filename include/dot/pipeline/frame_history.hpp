// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

#include "dot/image/image.hpp"
#include "dot/image/pyramid.hpp"
#include "dot/pipeline/object_motion.hpp"

DOT_BEGIN_NAMESPACE

/// A frame without segmentation, whose masks may still come.
struct PastFrame {
  std::uint64_t id = 0;  ///< the caller's
  Pyramid image;
  Image<float> inverse_depth;  ///< 1/m
  ObjectReference since;       ///< when it was and what has moved since; of no object and without points
  bool camera_known = true;    ///< its motion, in every frame since
};

/// The frames since the last segmentation, as far as masks are awaited for them: about 5.3 bytes a pixel each. Buffers
/// are taken over from the pipeline by swapping, and used again.
class FrameHistory {
 public:
  /// The newest frame: to be filled in by the caller, with the buffers of one that was dropped.
  PastFrame& add() {
    if (spare_.empty()) spare_.emplace_back();
    frames_.push_back(std::move(spare_.back()));
    spare_.pop_back();
    PastFrame& newest = frames_.back();
    newest.since = {};
    newest.camera_known = true;
    return newest;
  }

  /// Drops the frames before this time, seconds.
  void drop_before(double timestamp) {
    while (!frames_.empty() && frames_.front().since.timestamp < timestamp) drop_oldest();
  }
  void clear() {
    while (!frames_.empty()) drop_oldest();
  }

  /// The camera's motion over the last interval.
  void advance(const SE3d& T_c, const Matrix6<double>& covariance, double gain, double offset, bool known) {
    for (PastFrame& f : frames_) {
      f.since.advance(T_c, covariance, gain, offset);
      f.camera_known &= known;
    }
  }

  /// The frame of this id, the newest if there are several; null when there is none.
  PastFrame* find(std::uint64_t id) {
    for (auto f = frames_.rbegin(); f != frames_.rend(); ++f)
      if (f->id == id) return &*f;
    return nullptr;
  }

  bool empty() const { return frames_.empty(); }
  const PastFrame& oldest() const { return frames_.front(); }
  const PastFrame& newest() const { return frames_.back(); }

 private:
  void drop_oldest() {
    spare_.push_back(std::move(frames_.front()));
    frames_.pop_front();
  }

  std::deque<PastFrame> frames_;  ///< newest last
  std::vector<PastFrame> spare_;
};

DOT_END_NAMESPACE
