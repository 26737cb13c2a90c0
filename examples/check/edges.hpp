// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <opencv2/core.hpp>

/// @file
/// Upright edges of what a frame holds, as images that can be compared with each other.

namespace check {

/// Edges at the left and at the right of things, CV_32FC1, 1 or 0.
///
/// Matching widens things to both sides, and so do ragged masks: the two sides are then wrong by the same, in opposite
/// directions. Their mean is not.
struct Sides {
  cv::Mat left, right;
};

/// Where one thing ends in front of another.
/// @param metres 0 = none. @param fx_baseline of a stereo camera, 0 for others: far away its errors look like edges.
Sides depth_sides(const cv::Mat& metres, double fx_baseline);

/// Where masks begin and end.
Sides mask_sides(const cv::Mat& ids);

/// Strength of the image's upright edges, over that of their surroundings. CV_32FC1 with mean 0.
cv::Mat image_edges(const cv::Mat& grey);

}  // namespace check
