// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <opencv2/core.hpp>
#include <vector>

#include "dot/frame/frame.hpp"

namespace player {

/// The borders of a region, holes too: the area is that between an odd and an even number of them. In pixels; what lies
/// within 0.6 px of a straight line is left out.
using Outlines = std::vector<std::vector<cv::Point>>;

enum class Holes { Keep, Fill };

/// @param mask CV_8UC1, non-zero = inside. @param offset of its first pixel in the frame.
Outlines outlines_of(const cv::Mat& mask, cv::Point offset, Holes holes = Holes::Keep);

/// The bounding box of each id but 0. @param ids CV_32SC1.
std::map<std::uint32_t, cv::Rect> boxes_of(const cv::Mat& ids);

/// The outlines of a segmentation's instances.
std::vector<Outlines> outlines_of(const dot::Masks& masks);

}  // namespace player
