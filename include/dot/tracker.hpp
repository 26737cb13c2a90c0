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
/// Trackers are independent of one another. Only one thread at a time may use a given tracker; to read its
/// Result is no use of it. Buffers are allocated at the first frames and kept.
class DOT_EXPORT Tracker {
 public:
  /// @throws std::invalid_argument naming the field of `camera` or `options` that is out of range.
  explicit Tracker(const Intrinsics& camera, const Options& options = {});
  ~Tracker();
  /// Takes over the state of another tracker, which may then only be destroyed or assigned to.
  Tracker(Tracker&&) noexcept;
  /// Takes over the state of another tracker, which may then only be destroyed or assigned to.
  Tracker& operator=(Tracker&&) noexcept;

  /// Labels the objects of one frame, and prepares for the next one. The result is valid until the next call on this
  /// tracker.
  /// @throws std::invalid_argument naming the bad field of `frame`; the tracker is then unchanged.
  /// @throws std::bad_alloc if memory runs out. All frames and objects are then forgotten, as by `reset`; so they are
  /// after an exception of a host's pool.
  const Result& track(const Frame& frame);

  /// `track` in two steps, for a host that waits for the labels: this one returns as soon as they are ready. The result
  /// is valid until the next call. `prepare` alone does not end it: it sets its `too_little_depth`, `diagnosis` and
  /// time of Stage::Points. Without that call these are never set. @throws as `track`.
  const Result& label(const Frame& frame);

  /// Prepares for the next frame what `label` left: points of the new one. Without this call the next one does it. May
  /// run in another thread while all other parts of the result are read. Does nothing if all is prepared.
  /// @throws what `track` throws, except std::invalid_argument.
  void prepare();

  /// Takes masks that arrive late, for an earlier frame that was given to `track` without masks. A network may take
  /// longer than a frame. The masks are moved to the present by all motions measured since, and appear in the next
  /// result. The last result does not change, except for what `prepare` sets. Masks must come in the order of their
  /// frames, for frames after the last segmented one, and at most Options::mask.late_seconds late.
  /// @param frame_id Frame::id; the newest, if several frames have it.
  /// @throws std::invalid_argument naming the bad field, or frame_id if it is none of these frames; the tracker is then
  /// unchanged.
  /// @throws std::bad_alloc if memory runs out. All frames and objects are then forgotten, as by `reset`; so they are
  /// after an exception of a host's pool.
  void submit_masks(std::uint64_t frame_id, const Masks& masks);

  /// Forgets all frames and objects. Keeps the buffers and never reuses an id.
  void reset() noexcept;

  /// Lends the host's threads, of which Options::threads are used; with one, none are. Without this call, or for an
  /// empty pool, OpenCV's threads are used.
  void set_pool(ThreadPool pool);

  /// The settings given to the constructor.
  const Options& options() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace dot
