// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "detections.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace network {

cv::Rect pixels_in(const cv::Rect2d& box) {
  const auto first = [](double edge) { return static_cast<int>(std::ceil(edge - 0.5)); };
  const int x = first(box.x), y = first(box.y);
  return {x, y, first(box.x + box.width) - x, first(box.y + box.height) - y};
}

cv::Mat sample(const Grid& grid, const cv::Rect& region, float threshold) {
  cv::Mat mask(region.size(), CV_8UC1, cv::Scalar(0));
  const auto value = [&](int x, int y) {
    const bool is_inside = x >= 0 && y >= 0 && x < grid.values.cols && y < grid.values.rows;
    return is_inside ? grid.values.at<float>(y, x) : 0.0F;
  };
  for (int j = 0; j < region.height; ++j) {
    const double v = grid.y0 + grid.y_step * (region.y + j + 0.5) - 0.5;
    const int y = static_cast<int>(std::floor(v));
    const auto b = static_cast<float>(v - y);
    for (int i = 0; i < region.width; ++i) {
      const double u = grid.x0 + grid.x_step * (region.x + i + 0.5) - 0.5;
      const int x = static_cast<int>(std::floor(u));
      const auto a = static_cast<float>(u - x);
      const float above = (1 - a) * value(x, y) + a * value(x + 1, y);
      const float below = (1 - a) * value(x, y + 1) + a * value(x + 1, y + 1);
      if ((1 - b) * above + b * below > threshold) mask.at<std::uint8_t>(j, i) = 255;
    }
  }
  return mask;
}

runner::Segmentation to_segmentation(std::vector<Detection> detections, const std::vector<Class>& classes,
                                     cv::Size image) {
  std::stable_sort(detections.begin(), detections.end(),
                   [](const Detection& a, const Detection& b) { return a.score > b.score; });
  runner::Segmentation segmentation;
  segmentation.ids = cv::Mat(image, CV_16UC1, cv::Scalar(0));
  for (const Detection& d : detections) {
    const Class& c = classes[static_cast<std::size_t>(d.class_index)];
    if (c.role == Role::Ignored) continue;
    cv::Mat place = segmentation.ids(d.region);
    const cv::Mat own = (place == 0) & d.mask;
    if (cv::countNonZero(own) == 0) continue;
    dot::Instance instance;
    instance.id = static_cast<std::uint32_t>(segmentation.instances.size() + 1);
    instance.class_id = d.class_index;
    instance.score = d.score;
    instance.always_dynamic = c.role == Role::Dynamic;
    place.setTo(static_cast<double>(instance.id), own);
    segmentation.instances.push_back(instance);
  }
  return segmentation;
}

}  // namespace network
