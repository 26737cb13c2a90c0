// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>

#include "dot/camera/intrinsics.hpp"
#include "dot/export.hpp"
#include "dot/frame/frame.hpp"
#include "dot/pipeline/options.hpp"
#include "dot/pipeline/result.hpp"
#include "dot/threads/thread_pool.hpp"

namespace dot {

/// The default pipeline, compiled (target `dot::dot`): no template, no Eigen and no OpenCV in its interface.
///
/// Trackers are independent of one another; one thread at a time may use a given one. Buffers are taken at the first
/// frames and kept.
class DOT_EXPORT Tracker {
 public:
  /// @throws std::invalid_argument naming the field of `camera` or `options` that is out of range.
  explicit Tracker(const Intrinsics& camera, const Options& options = {});
  ~Tracker();
  Tracker(Tracker&&) noexcept;
  Tracker& operator=(Tracker&&) noexcept;

  /// Labels the objects of one frame. The result is valid until the next call on this tracker.
  /// @throws std::invalid_argument naming the bad field of `frame`; the tracker is then as it was before.
  /// @throws std::bad_alloc, or what a host's pool throws; everything is forgotten then, as by `reset`.
  const Result& track(const Frame& frame);

  /// Masks of an earlier frame, given to `track` without, that arrive only now: a network may take longer than a frame.
  /// They are carried to the present with all that has been measured since, and show in the next result; the last one
  /// is not changed. They come in the order of their frames, from after the last that was segmented, and at most
  /// Options::mask.late_seconds late.
  /// @param frame_id Frame::id; the newest, if several frames have it.
  /// @throws std::invalid_argument naming the bad field, or frame_id when it is none of these frames; the tracker is
  /// then as it was before.
  /// @throws std::bad_alloc, or what a host's pool throws; everything is forgotten then, as by `reset`.
  void submit_masks(std::uint64_t frame_id, const Masks& masks);

  /// Forgets all frames and objects; keeps buffers and never reuses an id.
  void reset() noexcept;

  /// Lends the host's threads, of which Options::threads are used; without, and for an empty pool, they are OpenCV's.
  void set_pool(ThreadPool pool);

  const Options& options() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace dot
