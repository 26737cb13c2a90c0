// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

/// @file
/// Masks as COCO's format has them. Run lengths count the pixels column by column, from the top left one on: first
/// those outside of the mask, then those in it, and so on in turn.

namespace runner {

/// The run lengths of a compressed string. Each is a number of groups of five bits, the lowest first, a character each:
/// 48 plus the group, plus 32 if more follow; bit 16 of the last group is the sign. From the fourth on, a length is the
/// difference to the one before the last.
/// @throws std::invalid_argument saying what is wrong.
std::vector<std::int64_t> decode_run_lengths(const std::string& text);

/// Sets the pixels of a mask to `id`.
/// @param ids CV_16UC1.
/// @throws std::invalid_argument when the lengths are not those of an image of this size.
void paint_runs(const std::vector<std::int64_t>& lengths, std::uint16_t id, cv::Mat& ids);

/// Sets the pixels whose centres lie in a polygon to `id`. The corner of the image is 0, 0, and the centre of the first
/// pixel 0.5, 0.5. What of it lies outside of the image does not count.
/// @param xy x and y of each corner in turn, pixels; 1e30 at most.
/// @throws std::invalid_argument when there are fewer than three corners, or half a corner.
void paint_polygon(const std::vector<double>& xy, std::uint16_t id, cv::Mat& ids);

}  // namespace runner
