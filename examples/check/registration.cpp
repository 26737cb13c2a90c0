// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "alignment.hpp"
#include "measures.hpp"
#include "words.hpp"

/// @file
/// Whether the depth is of the same moment and of the same pixels as the image: edges of things in the depth are edges
/// in the image.

namespace check {
namespace {

/// Share of the pixels below which edges of the depth are those of its holes.
constexpr double least_coverage = 0.3;

double coverage(const Samples& samples) {
  double valid = 0, all = 0;
  for (const Sample& frame : samples.frames) valid += cv::countNonZero(frame.depth), all += frame.depth.size().area();
  return valid / all;
}

Finding size_finding(const Samples& samples) {
  for (const Sample& frame : samples.frames)
    if (!has_depth(frame)) {
      const double percent = 100.0 * frame.depth.cols / frame.grey.cols;
      return faulty(
          "depth-size", percent, "%",
          "The depth of frame " + text(samples.recording.entries[frame.index].number) + " is " +
              size_text(frame.depth.size()) + ", the image " + size_text(frame.grey.size()) + ".",
          "Register the depth to the image: each pixel of the image needs the depth of what it shows. Scaling "
          "is right only where both are of one lens.");
    }
  return fine("depth-size", 100, "%", "The depth has the size of the image.");
}

Finding lag_finding(const Lag& lag) {
  if (lag.clear) {
    const int frames = std::abs(lag.frames);
    return faulty(
        "depth-lag", lag.frames, "frames",
        "The depth comes " + count_text(frames, "frame") + (lag.frames > 0 ? " late: " : " early: ") +
            "its edges lie on those of the image " + count_text(frames, "frame") +
            (lag.frames > 0 ? " before." : " after."),
        "Pair images and depth by their timestamps, not by their order of arrival; look for a buffer that holds "
        "one of the two back.");
  }
  if (!lag.known)
    return unknown("depth-lag", "No lag fits clearly better than the others: too little moves, or has edges in depth.");
  return fine("depth-lag", 0, "frames", "Depth and image are of the same moment.");
}

Finding offset_finding(const Lag& lag, int frames) {
  constexpr double least_height = 0.1;
  constexpr int least_frames = 12;
  constexpr double most_spread = 2.5;  // pixels, over the parts of the recording
  constexpr double most = 2.5;         // pixels; up to 1.5 on recordings without the fault
  if (lag.match.height < least_height)
    return unknown("depth-offset", "The edges of the depth are not seen in the image.");
  if (frames < least_frames || lag.spread > most_spread)
    return unknown("depth-offset", "The parts of the recording do not agree on an offset, or are too short.");
  const double pixels = std::hypot(lag.match.offset.x, lag.match.offset.y);
  const std::string where = number(lag.match.offset.x, 1) + " px to the right and " + number(lag.match.offset.y, 1) +
                            " px down (negative: left, up)";
  if (pixels <= most) return fine("depth-offset", pixels, "px", "The depth lies on the image: " + where + ".");
  return faulty(
      "depth-offset", pixels, "px", "The depth does not lie on the image: it is " + where + ".",
      "Register the depth to the camera that takes the image (its pose and both intrinsics), and see that both "
      "are cropped and rectified alike.");
}

}  // namespace

Findings check_registration(const Samples& samples) {
  Findings findings{size_finding(samples)};
  const auto give_up = [&](const std::string& why) {
    findings.push_back(unknown("depth-lag", why));
    findings.push_back(unknown("depth-offset", why));
    return findings;
  };
  if (samples.depth_from_pair) return give_up("The depth is computed from the image itself.");
  if (findings[0].verdict == Verdict::Fault) return give_up("The depth has another size.");
  if (coverage(samples) < least_coverage) return give_up("Too few pixels have depth.");

  const dot::Intrinsics& camera = samples.recording.intrinsics;
  const bool stereo = samples.recording.depth_source == dot::DepthSource::Stereo;
  Alignment alignment(samples.frames[0].grey.size());
  const int count = static_cast<int>(samples.frames.size());
  for (int i = 0; i < count; ++i) {
    const Sample& frame = samples.frames[static_cast<std::size_t>(i)];
    alignment.add(depth_sides(metres(samples, frame), stereo ? camera.fx * camera.baseline : 0),
                  image_edges(frame.grey), frame.follows, i * Alignment::kParts / count);
  }
  const Lag lag = find_lag(alignment);
  findings.push_back(lag_finding(lag));
  findings.push_back(offset_finding(lag, count));
  return findings;
}

}  // namespace check
