// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <vector>

#include "dot/image/depth_plateau.hpp"
#include "dot/points/settings.hpp"
#include "measures.hpp"
#include "words.hpp"

/// @file
/// Depth that ends at one value, where it should be missing. The tracker finds it in the same way, but says so only
/// once the camera has moved; here it is enough that frames agree on the value.

namespace check {
namespace {

dot::DepthPlateau plateau_of(const Samples& samples, const cv::Mat& depth) {
  const bool words = depth.type() == CV_16UC1;
  return dot::find_plateau(
      {depth.data, depth.cols, depth.rows, static_cast<std::ptrdiff_t>(depth.step[0]),
       words ? dot::PixelFormat::DepthU16 : dot::PixelFormat::DepthF32, samples.recording.depth_units_per_metre},
      dot::SelectionSettings{}.max_depth);
}

}  // namespace

Findings check_depth_saturation(const Samples& samples) {
  constexpr std::size_t least_frames = 2, one_of = 10;
  std::vector<dot::DepthPlateau> plateaus;
  double farthest = 0;  // metres
  for (const Sample& frame : samples.frames) {
    const dot::DepthPlateau plateau = plateau_of(samples, frame.depth);
    if (!(plateau.depth > 0)) continue;
    plateaus.push_back(plateau);
    farthest = std::max(farthest, plateau.depth);
  }
  if (plateaus.empty()) return {unknown("depth-saturated", "There is no depth.")};
  std::size_t flat = 0;
  double share = 0;
  for (const dot::DepthPlateau& plateau : plateaus) {
    if (plateau.depth < farthest) continue;
    share += 100 * plateau.share / static_cast<double>(plateaus.size());
    if (plateau.is_flat) ++flat;
  }
  const std::string said = number(share, 1) + " % of the pixels have the largest depth, " + number(farthest, 2) + " m.";
  if (flat < std::max(std::min(least_frames, plateaus.size()), plateaus.size() / one_of))
    return {fine("depth-saturated", share, "%", said)};
  return {faulty("depth-saturated", share, "%", said + " It is cut off there.",
                 "Write 0 where something is farther than the sensor measures, or is not measured at all. The tracker "
                 "leaves this depth out; anything else that uses it takes these pixels for a wall.")};
}

}  // namespace check
