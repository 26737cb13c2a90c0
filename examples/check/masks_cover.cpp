// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include "dot/diagnosis/watch.hpp"
#include "measures.hpp"
#include "median.hpp"
#include "words.hpp"

/// @file
/// How much of the image lies under masks. The camera's motion is that of what has none. Things that fill the view may
/// leave enough of it: from the tracker's limit on this is a hint, and a fault where hardly anything is left.

namespace check {

Findings check_masks_cover(const Samples& samples) {
  constexpr double most = 0.85, nearly_all = 0.95;  // of the image
  constexpr double seldom = 0.05;                   // of the frames: so many whole images are no chance
  std::vector<double> shares;
  int covered = 0, whole = 0;
  for (const Sample& frame : samples.frames) {
    if (frame.ids.empty()) continue;
    const double share = cv::countNonZero(frame.ids) / static_cast<double>(frame.ids.total());
    shares.push_back(share);
    if (share > dot::Watch::kMasked) ++covered;
    if (share > nearly_all) ++whole;
  }
  const char* const name = "masks-cover";
  if (shares.empty()) return {unknown(name, "There are no masks.")};
  const auto frames = static_cast<double>(shares.size());
  const double percent = 100 * median(shares);
  const std::string said = "Masks cover " + number(percent, 0) + " % of the image (median), over " +
                           number(100 * dot::Watch::kMasked, 0) + " % of it in " + number(100 * covered / frames, 0) +
                           " % of the frames, nearly all of it in " + number(100 * whole / frames, 0) + " %.";
  const char* const advice =
      "Give masks of things that can move, and 0 to the rest: the camera's motion is found from pixels without a mask. "
      "Look for a mask of the whole image, for a background that is an instance of its own, for classes such as road "
      "and building, and for a network that cuts everything into pieces (Segment Anything without prompts).";
  if (percent > 100 * most || whole > seldom * frames) return {faulty(name, percent, "% of the image", said, advice)};
  if (covered > 0.5 * frames || whole > 0) return {hint(name, percent, "% of the image", said, advice)};
  return {fine(name, percent, "% of the image", said)};
}

}  // namespace check
