// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <opencv2/core.hpp>

#include "dot/pipeline/result.hpp"
#include "sequence/sequence.hpp"

namespace runner {

/// The frame with its objects: moving ones in a warm colour, static ones outlined in green, undecided ones greyed, a
/// label at each and a strip with the legend below. Small images are enlarged by a whole factor.
/// @param total_ms time of `track`, shown in the strip.
cv::Mat draw_overlay(const SequenceFrame& frame, const dot::Result& result, double total_ms);

}  // namespace runner
