// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "revised_motions.hpp"

#include <algorithm>
#include <cmath>

namespace player {

std::vector<RevisedMotion> RevisedMotions::next(const dot::Result& result) {
  std::vector<RevisedMotion> found;
  for (const dot::CameraRevision& revision : result.revised) {
    const auto then = std::find_if(motions_.rbegin(), motions_.rend(),
                                   [&](const Motion& motion) { return motion.frame_id == revision.frame_id; });
    if (then == motions_.rend()) continue;
    double squared = 0;
    for (const std::size_t i : {3U, 7U, 11U}) squared += std::pow(revision.T_cur_prev[i] - then->T_cur_prev[i], 2);
    found.push_back({revision.frame_id, std::sqrt(squared)});
  }
  motions_.push_back({result.frame_id, result.camera.T_cur_prev});
  if (motions_.size() > kept) motions_.pop_front();
  return found;
}

}  // namespace player
