// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "outlines.hpp"

#include <opencv2/imgproc.hpp>
#include <utility>

namespace player {
namespace {

cv::Mat to_mat(const dot::ImageRef& image) {
  const int bytes = dot::bytes_per_pixel(image.format);
  const int type = bytes == 1 ? CV_8UC1 : bytes == 2 ? CV_16UC1 : CV_32SC1;
  return cv::Mat(image.height, image.width, type, const_cast<void*>(image.data),
                 static_cast<std::size_t>(image.stride));
}

}  // namespace

Outlines outlines_of(const cv::Mat& mask, cv::Point offset, Holes holes) {
  constexpr double tolerance = 0.6;  // pixels
  // A border of zeros: on the image's own border findContours would see no pixels.
  cv::Mat padded;
  cv::copyMakeBorder(mask, padded, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
  Outlines found, outlines;
  cv::findContours(padded, found, holes == Holes::Keep ? cv::RETR_CCOMP : cv::RETR_EXTERNAL, cv::CHAIN_APPROX_SIMPLE,
                   offset - cv::Point(1, 1));
  for (const std::vector<cv::Point>& contour : found) {
    std::vector<cv::Point> simple;
    cv::approxPolyDP(contour, simple, tolerance, true);
    if (simple.size() >= 3) outlines.push_back(std::move(simple));
  }
  return outlines;
}

std::map<std::uint32_t, cv::Rect> boxes_of(const cv::Mat& ids) {
  std::map<std::uint32_t, cv::Rect> boxes;
  for (int y = 0; y < ids.rows; ++y) {
    const int* row = ids.ptr<int>(y);
    for (int x = 0; x < ids.cols;) {
      const int begin = x;
      while (x < ids.cols && row[x] == row[begin]) ++x;
      if (row[begin] != 0) boxes[static_cast<std::uint32_t>(row[begin])] |= cv::Rect(begin, y, x - begin, 1);
    }
  }
  return boxes;
}

std::vector<Outlines> outlines_of(const dot::Masks& masks) {
  std::vector<Outlines> instances;
  if (!masks.ids.empty()) {
    cv::Mat ids;
    to_mat(masks.ids).convertTo(ids, CV_32S);
    for (const auto& [id, box] : boxes_of(ids))
      instances.push_back(outlines_of(ids(box) == static_cast<double>(id), box.tl()));
  }
  for (const dot::Instance& instance : masks.instances)
    if (!instance.mask.empty()) instances.push_back(outlines_of(to_mat(instance.mask) != 0, {instance.x, instance.y}));
  return instances;
}

}  // namespace player
