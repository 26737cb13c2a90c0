// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "measures.hpp"
#include "median.hpp"
#include "words.hpp"

/// @file
/// A part of the vehicle or robot in the picture: its edges stay where they are while those of the scene move.

namespace check {
namespace {

constexpr float textured = 1;   ///< grey values a pixel: mean gradient from which a pixel counts
constexpr float stays = 0.85F;  ///< length of the mean gradient over the mean of their lengths
constexpr int surroundings = 31;
constexpr double of_part = 0.6;   ///< share of textured pixels that stay, within the part
constexpr double of_rest = 0.25;  ///< the most in the rest of the picture: the camera moves
constexpr double least_area = 2;  ///< per cent of the picture

struct Gradients {
  cv::Mat stay;  ///< CV_32FC1, 1 where an edge stays
  cv::Mat all;   ///< likewise of any edge
};

Gradients look_at(const Samples& samples) {
  const cv::Size size = samples.frames[0].grey.size();
  cv::Mat sum_x = cv::Mat::zeros(size, CV_32F), sum_y = sum_x.clone(), lengths = sum_x.clone();
  int count = 0;
  for (std::size_t i = 0; i < samples.frames.size(); i += 2, ++count) {
    cv::Mat smooth, x, y, length;
    cv::GaussianBlur(samples.frames[i].grey, smooth, {}, 1);
    constexpr double per_pixel = 1 / 8.0;  // of Sobel's kernel
    cv::Sobel(smooth, x, CV_32F, 1, 0, 3, per_pixel);
    cv::Sobel(smooth, y, CV_32F, 0, 1, 3, per_pixel);
    cv::magnitude(x, y, length);
    sum_x += x, sum_y += y, lengths += length;
  }
  cv::Mat mean;
  cv::magnitude(sum_x, sum_y, mean);
  const cv::Mat strong = lengths > textured * static_cast<float>(count);
  Gradients gradients;
  strong.convertTo(gradients.all, CV_32F, 1 / 255.0);
  cv::Mat(strong & (mean > stays * lengths)).convertTo(gradients.stay, CV_32F, 1 / 255.0);
  return gradients;
}

/// The largest region in which nearly all edges stay.
cv::Mat largest_part(const Gradients& gradients) {
  cv::Mat stay, all, labels, statistics, centres;
  cv::boxFilter(gradients.stay, stay, CV_32F, {surroundings, surroundings});
  cv::boxFilter(gradients.all, all, CV_32F, {surroundings, surroundings});
  constexpr double enough = 0.05;  // of the surroundings are edges
  const cv::Mat fixed = (stay > of_part * all) & (all > enough);
  const int count = cv::connectedComponentsWithStats(fixed, labels, statistics, centres);
  int largest = 0;
  for (int i = 1; i < count; ++i)
    if (largest == 0 || statistics.at<int>(i, cv::CC_STAT_AREA) > statistics.at<int>(largest, cv::CC_STAT_AREA))
      largest = i;
  return largest == 0 ? cv::Mat(cv::Mat::zeros(fixed.size(), CV_8U)) : cv::Mat(labels == largest);
}

/// Whether the part is nearer than most of the picture. What is far, or has no depth and is at the top as the sky is,
/// stays as well while the camera goes ahead.
bool may_be_near(const Samples& samples, const cv::Mat& part) {
  constexpr double nearer = 0.5;       // of the median depth
  constexpr double least_share = 0.3;  // of the part's pixels that have depth, to count
  std::vector<double> inside, all;
  int pixels = 0;
  const Sample& frame = samples.frames[samples.frames.size() / 2];
  if (!has_depth(frame)) return true;
  const cv::Mat z = metres(samples, frame);
  for (int y = 0; y < z.rows; y += 2)
    for (int x = 0; x < z.cols; x += 2) {
      const bool in_part = part.at<std::uint8_t>(y, x) != 0;
      if (in_part) ++pixels;
      if (z.at<float>(y, x) <= 0) continue;
      all.push_back(static_cast<double>(z.at<float>(y, x)));
      if (in_part) inside.push_back(all.back());
    }
  if (static_cast<double>(inside.size()) < least_share * pixels || inside.empty()) return cv::boundingRect(part).y > 1;
  return median(std::move(inside)) < nearer * median(std::move(all));
}

const char* side_of(const cv::Rect& box, cv::Size size) {
  if (box.y + box.height >= size.height - 1) return "at the bottom";
  if (box.y <= 1) return "at the top";
  if (box.x <= 1) return "at the left";
  return box.x + box.width >= size.width - 1 ? "at the right" : "inside";
}

}  // namespace

Findings check_fixed_parts(const Samples& samples) {
  constexpr std::size_t least_frames = 10;
  if (samples.frames.size() < least_frames) return {unknown("fixed-part", "There are too few frames.")};
  const Gradients gradients = look_at(samples);
  const cv::Mat part = largest_part(gradients);
  const double area = 100.0 * cv::countNonZero(part) / static_cast<double>(part.total());
  const cv::Mat rest = part == 0;
  const double moving_edges = cv::mean(gradients.all, rest)[0];
  const double still = moving_edges > 0 ? cv::mean(gradients.stay, rest)[0] / moving_edges : 1;
  if (still > of_rest) return {unknown("fixed-part", "The camera does not move enough.")};
  if (area < least_area || !may_be_near(samples, part))
    return {fine("fixed-part", area, "%", "No part of the picture stays while the rest moves.")};
  return {
      faulty("fixed-part", area, "%",
             number(area, 0) + " % of the picture, " + side_of(cv::boundingRect(part), part.size()) +
                 ", stays while the rest moves: a hood, a gripper or a frame.",
             "Set the depth to 0 there, so that it says nothing of the camera's motion, or crop the image (and move "
             "the principal point).")};
}

}  // namespace check
