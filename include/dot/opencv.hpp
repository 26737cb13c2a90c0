// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <opencv2/core.hpp>

#include "dot/image/opencv.hpp"
#include "dot/pipeline/exclusion.hpp"
#include "dot/tracker.hpp"

/// @file
/// All functions that a host with cv::Mat needs:
///
///     dot::Tracker tracker(camera, options);
///     ...
///     dot::Frame frame = dot::make_frame(id, seconds, image, depth, 1000);
///     if (!instances.empty()) frame.masks = dot::Masks{dot::id_view(instances), {}};
///     const dot::Result& result = tracker.track(frame);
///     orb->detect(image, features, dot::feature_mask(result));

namespace dot {

/// A frame that borrows the memory of `image` and `depth`: see `view` and `depth_view` for their types. Without masks
/// and camera motion.
/// @param timestamp seconds, strictly increasing. @param units_per_metre of CV_16UC1 depth.
inline Frame make_frame(std::uint64_t id, double timestamp, const cv::Mat& image, const cv::Mat& depth,
                        double units_per_metre = 1000) {
  Frame frame;
  frame.id = id;
  frame.timestamp = timestamp;
  frame.image = view(image);
  frame.depth = depth_view(depth, units_per_metre);
  return frame;
}

namespace detail {

template <typename Write>
cv::Mat written_mask(const Result& result, const ExclusionPolicy& policy, Write write) {
  cv::Mat out(result.labels.height, result.labels.width, CV_8UC1);
  write(result, policy, {out.data, out.cols, out.rows, static_cast<std::ptrdiff_t>(out.step[0])});
  return out;
}

}  // namespace detail

/// A new CV_8UC1 image: 255 = do not use this pixel, 0 = use it.
inline cv::Mat exclusion_mask(const Result& result, const ExclusionPolicy& policy = {}) {
  return detail::written_mask(
      result, policy,
      [](const Result& r, const ExclusionPolicy& p, ImageView<std::uint8_t> out) { exclusion_mask(r, p, out); });
}

/// A new CV_8UC1 image in the polarity of OpenCV's feature detectors: 0 = do not use this pixel, 255 = use it.
inline cv::Mat feature_mask(const Result& result, const ExclusionPolicy& policy = {}) {
  return detail::written_mask(
      result, policy,
      [](const Result& r, const ExclusionPolicy& p, ImageView<std::uint8_t> out) { feature_mask(r, p, out); });
}

}  // namespace dot
