// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <vector>

#include "camera_thread.hpp"
#include "clock.hpp"
#include "dot/tracker.hpp"
#include "late_segmentation.hpp"
#include "report.hpp"
#include "writer_thread.hpp"

namespace real_time {

/// A recording that is played as if it came from a camera.
struct Source {
  CameraThread::Reader read;
  std::vector<double> times;  ///< of the frames, seconds from the first one
  LateNetwork network;        ///< runs in a thread of its own
};

/// Plays the source: each frame is tracked without masks when it comes, unless a newer one is there. The network
/// segments the newest of these frames beside it, and its masks are submitted when they are done.
/// @param stop ends the run, as if the recording ended.
/// @param done called after each frame, in another thread.
/// @throws what one of the threads has thrown.
Report play(const Source& source, Clock& clock, std::atomic<bool>& stop, dot::Tracker& tracker,
            const ResultConsumer& done);

}  // namespace real_time
