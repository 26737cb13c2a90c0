// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <opencv2/core.hpp>
#include <vector>

#include "dot/pipeline/options.hpp"
#include "dot/pipeline/result.hpp"
#include "outlines.hpp"
#include "page/json.hpp"
#include "revised_motions.hpp"
#include "sequence/sequence.hpp"

namespace player {

/// What was found of a frame, besides the result itself.
struct FrameDrawing {
  std::map<std::uint32_t, Outlines> predicted;             ///< by track id, see MovedOutlines
  std::map<std::uint32_t, std::vector<cv::Point>> points;  ///< by track id, 0 = background, see PointFinder
  std::vector<RevisedMotion> revised;                      ///< see RevisedMotions
};

/// A frame as the page reads it. Lengths are in metres, speeds in m/s, times in seconds, places in pixels of the frame.
/// What was not measured is absent.
///
///     {"frame": 31, "time": 3.1, "interval": 0.1, "ms": 6.2, "masks": true,
///      "camera": {"status": "tracked", "words": ".", "speed": 8.1, "phi": 0.97, "points": 1893, "inliers": 1702,
///                 "revised": [{"frame": 29, "wrong": 0.31}, ...]},
///      "objects": [{"id": 5, "state": "moving", "reason": "", "words": "measured", "why": ".", "p": 0.98,
///                   "class": 2, "score": 0.9, "segmented": true, "always": true, "discovered": true, "area": 2000,
///                   "box": [x, y, width, height], "decided": "moving",
///                   "speed": 8.1, "sigma": 0.4, "limit": 0.5, "phi": 0.95, "range": 23.1, "points": 280,
///                   "inliers": 250, "pointSpeed": 8.2, "pointSigma": 0.6, "turning": true,
///                   "fused": 8.0, "fusedSigma": 0.2,
///                   "outline": [[x, y, x, y, ...], ...], "predicted": [...], "texture": [x, y, ...]}, ...],
///      "network": [[[x, y, ...], ...], ...], "texture": [x, y, ...]}
///
/// `revised` are earlier frames whose camera motion this frame proved to be wrong, by so many metres.
/// `always`, `discovered` and `turning` (by which the points move faster than with the centroid) are only there if
/// true, `network` (an outline for each instance) if the frame has masks, `revised` if there are any.
/// @param total_ms time of `track`.
page::Json frame_data(const runner::SequenceFrame& frame, const dot::Result& result, double total_ms,
                      const FrameDrawing& drawing, const dot::Options& options);

}  // namespace player
