// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "dot/camera/intrinsics.hpp"
#include "dot/export.hpp"
#include "dot/pipeline/frame.hpp"
#include "dot/pipeline/options.hpp"
#include "dot/pipeline/result.hpp"

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
  const Result& track(const Frame& frame);

  /// Forgets all frames and objects; keeps buffers and never reuses an id.
  void reset();

  const Options& options() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace dot
