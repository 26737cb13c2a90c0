// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "late_masks_feed.hpp"

#include <stdexcept>
#include <string>

#include "dot/image/opencv.hpp"

namespace real_time {

bool LateMasksFeed::submit(const LateSegmentation& late) {
  const runner::Segmentation& s = late.segmentation;
  try {
    tracker_.submit_masks(static_cast<std::uint64_t>(late.frame),
                          {dot::id_view(s.ids), {s.instances.data(), s.instances.size()}});
  } catch (const std::invalid_argument& error) {
    // The field that the tracker names when it does not wait for this frame, or no longer.
    if (std::string(error.what()).rfind("frame_id: ", 0) != 0) throw;
    ++refused_;
    return false;
  }
  latencies_.push_back(late.done - late.captured);
  return true;
}

}  // namespace real_time
