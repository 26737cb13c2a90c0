// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "edges.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace check {
namespace {

/// Holes of a row get the depth of their farther end: what a stereo camera does not see lies behind.
void fill_rows(cv::Mat& inverse) {
  for (int y = 0; y < inverse.rows; ++y) {
    auto* row = inverse.ptr<float>(y);
    int last = -1;
    for (int x = 0; x <= inverse.cols; ++x) {
      const bool end = x == inverse.cols;
      if (!end && row[x] <= 0) continue;
      if (end && last < 0) break;  // nothing in this row
      const float right = end ? row[last] : row[x];
      const float left = last < 0 ? right : row[last];
      std::fill(row + last + 1, row + x, std::min(left, right));
      last = x;
    }
  }
}

Sides no_sides(cv::Size size) { return {cv::Mat::zeros(size, CV_32F), cv::Mat::zeros(size, CV_32F)}; }

}  // namespace

Sides depth_sides(const cv::Mat& metres, double fx_baseline) {
  cv::Mat inverse = cv::Mat::zeros(metres.size(), CV_32F);
  for (int y = 0; y < metres.rows; ++y) {
    const auto* z = metres.ptr<float>(y);
    auto* q = inverse.ptr<float>(y);
    for (int x = 0; x < metres.cols; ++x)
      if (z[x] > 0) q[x] = 1 / z[x];
  }
  fill_rows(inverse);
  cv::medianBlur(inverse, inverse, 5);

  constexpr float jump = 0.12F;              // of the nearer surface's inverse depth, over two pixels
  constexpr double jump_of_disparity = 2.5;  // pixels
  const float least = fx_baseline > 0 ? static_cast<float>(jump_of_disparity / fx_baseline) : 0;
  Sides sides = no_sides(metres.size());
  for (int y = 1; y + 1 < metres.rows; ++y) {
    const auto* q = inverse.ptr<float>(y);
    for (int x = 1; x + 1 < metres.cols; ++x) {
      const float step = q[x + 1] - q[x - 1];
      const float needed = std::max(least, jump * std::max(q[x + 1], q[x - 1]));
      if (step > needed) sides.left.at<float>(y, x) = 1;
      if (-step > needed) sides.right.at<float>(y, x) = 1;
    }
  }
  return sides;
}

Sides mask_sides(const cv::Mat& ids) {
  cv::Mat wide;
  ids.convertTo(wide, CV_32F);
  Sides sides = no_sides(ids.size());
  for (int y = 0; y < ids.rows; ++y) {
    const auto* id = wide.ptr<float>(y);
    for (int x = 1; x < ids.cols; ++x) {
      if (id[x] == id[x - 1]) continue;
      if (id[x] > 0) sides.left.at<float>(y, x) = 1;
      if (id[x - 1] > 0) sides.right.at<float>(y, x) = 1;
    }
  }
  return sides;
}

cv::Mat image_edges(const cv::Mat& grey) {
  cv::Mat smooth, edges, around;
  cv::GaussianBlur(grey, smooth, {}, 1);
  cv::Sobel(smooth, edges, CV_32F, 1, 0);
  edges = cv::abs(edges);
  constexpr int surroundings = 31;
  cv::boxFilter(edges, around, CV_32F, {surroundings, surroundings});
  constexpr double least = 16;  // Sobel's units: noise and compression
  edges = edges / (around + least);
  cv::min(edges, 3, edges);  // a single strong line is not to outweigh the rest
  edges -= cv::mean(edges);
  return edges;
}

}  // namespace check
