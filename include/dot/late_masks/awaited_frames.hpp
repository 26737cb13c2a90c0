// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "dot/camera_motion/camera_step.hpp"
#include "dot/camera_motion/first_intervals.hpp"
#include "dot/frame/frame_data.hpp"

DOT_BEGIN_NAMESPACE

/// A frame without segmentation, whose masks may still arrive.
struct AwaitedFrame {
  FramePtr frame;           ///< kept until its masks come or are too late
  CameraStep camera;        ///< the step that led to it
  CameraSince since;        ///< the camera's motion since then
  bool since_known = true;  ///< whether that was measured in every frame since

  /// Of the frame, seconds.
  double timestamp() const { return frame->timestamp; }
};

/// The frames since the last segmentation, the oldest first.
class AwaitedFrames {
 public:
  using const_iterator = std::vector<AwaitedFrame>::const_iterator;  ///< a place in the list

  /// Moves all to the next frame. @param step led to that frame.
  void advance(const CameraStep& step) {
    for (AwaitedFrame& f : frames_) {
      f.since = f.since.after(step);
      f.since_known = f.since_known && step.known();
    }
  }

  /// Corrects the steps that led to some of the frames. Must be called before the newest step is added.
  void revise(const std::vector<RevisedInterval>& revised) {
    for (const RevisedInterval& r : revised)
      for (AwaitedFrame& f : frames_)
        if (f.frame->timestamp == r.timestamp) f.camera = r.step;
    for (std::size_t i = 0; i < frames_.size(); ++i) {
      frames_[i].since = {};
      for (std::size_t k = i + 1; k < frames_.size(); ++k) frames_[i].since = frames_[i].since.after(frames_[k].camera);
    }
  }

  /// Adds the newest frame. Drops frames older than `seconds`, and the oldest ones if there are more than `most`.
  void add(const FramePtr& frame, const CameraStep& step, double seconds, int most) {
    const auto count = static_cast<std::size_t>(most);
    frames_.reserve(count);
    std::size_t drop = 0;
    while (drop < frames_.size() &&
           (frames_[drop].timestamp() < frame->timestamp - seconds - kClockError || frames_.size() - drop >= count))
      ++drop;
    frames_.erase(frames_.begin(), frames_.begin() + static_cast<std::ptrdiff_t>(drop));
    frames_.push_back({frame, step, {}, true});
  }

  /// The frame with this id, the newest one if there are several, end() if there is none.
  const_iterator find(std::uint64_t id) const {
    const auto found =
        std::find_if(frames_.rbegin(), frames_.rend(), [id](const AwaitedFrame& f) { return f.frame->id == id; });
    return found == frames_.rend() ? frames_.end() : std::prev(found.base());
  }

  /// Drops all frames up to this one, including it.
  void drop_through(const_iterator last) { frames_.erase(frames_.begin(), std::next(last)); }
  /// Drops all frames.
  void clear() noexcept { frames_.clear(); }

  /// The oldest frame.
  const_iterator begin() const { return frames_.begin(); }
  /// The place after the newest frame.
  const_iterator end() const { return frames_.end(); }
  /// Whether no frame waits.
  bool empty() const { return frames_.empty(); }
  /// Number of frames that wait.
  std::size_t size() const { return frames_.size(); }

 private:
  std::vector<AwaitedFrame> frames_;
};

DOT_END_NAMESPACE
