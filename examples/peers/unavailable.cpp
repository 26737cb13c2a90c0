// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

/// In the place of the rules, where OpenCV has no optical flow.

#include "rule.hpp"
#include "sequence/errors.hpp"

namespace peers {

std::vector<PublishedRule> published_rules(const dot::Intrinsics&) {
  throw runner::UsageError(
      "--compare needs OpenCV's video module (Debian: libopencv-video-dev), which was not there when this program was "
      "built");
}

}  // namespace peers
