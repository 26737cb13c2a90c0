// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "measures.hpp"
#include "median.hpp"
#include "words.hpp"

/// @file
/// The stereo pair: whether its rows are those of one another, and whether its disparities are those of the depth.
/// Small patches of the left image are looked for in the right one, some rows higher and lower too.

namespace check {
namespace {

struct Point {
  double row_error = 0;  ///< pixels by which the right image is lower
  double disparity = 0;  ///< pixels, measured
  double expected = 0;   ///< pixels, by depth, focal length and baseline; 0: no depth
};

/// Corners, some to each part of the image.
std::vector<cv::Point> corners(const cv::Mat& grey, int margin) {
  cv::Mat strength;
  constexpr int window = 7;
  cv::cornerMinEigenVal(grey, strength, window);
  std::vector<cv::Point> found;
  constexpr int cell = 64;
  for (int y = margin; y + cell <= grey.rows - margin; y += cell)
    for (int x = margin; x + cell <= grey.cols - margin; x += cell) {
      cv::Point at;
      double best = 0;
      cv::minMaxLoc(strength(cv::Rect(x, y, cell, cell)), nullptr, &best, nullptr, &at);
      if (best > 0) found.push_back(at + cv::Point(x, y));
    }
  return found;
}

double top(double before, double here, double after) {
  const double curvature = before - 2 * here + after;
  return curvature < 0 ? 0.5 * (before - after) / curvature : 0;
}

constexpr int half = 9, rows = 7, beyond = 8;  // pixels: patch, rows looked at, columns beyond disparity 0

/// @return whether the patch was found.
bool find(const Sample& frame, const cv::Point& at, int most_disparity, Point& point) {
  const int left = std::max(half, at.x - most_disparity), right = std::min(frame.grey.cols - half - 1, at.x + beyond);
  const cv::Rect patch(at.x - half, at.y - half, 2 * half + 1, 2 * half + 1);
  const cv::Rect strip(left - half, at.y - half - rows, right - left + 2 * half + 1, 2 * (half + rows) + 1);
  if ((strip & cv::Rect({}, frame.grey.size())) != strip) return false;
  cv::Mat score;
  cv::matchTemplate(frame.right(strip), frame.grey(patch), score, cv::TM_CCOEFF_NORMED);
  double best = 0;
  cv::Point place;
  cv::minMaxLoc(score, nullptr, &best, nullptr, &place);
  constexpr double alike = 0.93, other_place = 0.85;
  if (best < alike || place.x < 1 || place.y < 1 || place.x + 1 >= score.cols || place.y + 1 >= score.rows)
    return false;
  cv::Mat elsewhere = score.clone();
  cv::circle(elsewhere, place, 4, cv::Scalar(-1), cv::FILLED);
  double second = 0;
  cv::minMaxLoc(elsewhere, nullptr, &second);
  if (second > other_place) return false;  // a repeated pattern
  const auto value = [&](int dx, int dy) { return static_cast<double>(score.at<float>(place.y + dy, place.x + dx)); };
  const double x = left + place.x + top(value(-1, 0), best, value(1, 0));
  point.row_error = place.y - rows + top(value(0, -1), best, value(0, 1));
  point.disparity = at.x - x;
  return true;
}

std::vector<Point> match(const Samples& samples) {
  constexpr std::size_t frames = 12;
  const dot::Intrinsics& camera = samples.recording.intrinsics;
  std::vector<Point> points;
  const std::size_t every = std::max<std::size_t>(1, samples.frames.size() / frames);
  for (std::size_t i = 0; i < samples.frames.size(); i += every) {
    const Sample& frame = samples.frames[i];
    if (frame.right.empty()) continue;
    const cv::Mat depth = has_depth(frame) ? metres(samples, frame) : cv::Mat();
    for (const cv::Point& at : corners(frame.grey, half + rows)) {
      Point point;
      if (!find(frame, at, static_cast<int>(0.16 * frame.grey.cols), point)) continue;
      const float z = depth.empty() ? 0 : depth.at<float>(at);
      point.expected = z > 0 ? camera.fx * camera.baseline / static_cast<double>(z) : 0;
      points.push_back(point);
    }
  }
  return points;
}

/// disparity = scale * expected + bias, robustly.
struct Line {
  double scale = 1, bias = 0;
};

Line fit(const std::vector<Point>& points) {
  std::vector<double> ratios;
  for (const Point& p : points)
    if (p.expected > 0) ratios.push_back(p.disparity / p.expected);
  Line line{median(ratios), 0};
  for (int round = 0; round < 20; ++round) {
    double w = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (const Point& p : points) {
      if (p.expected <= 0) continue;
      const double residual = p.disparity - line.scale * p.expected - line.bias;
      const double limit = std::max(0.5, 8 * std::pow(0.7, round));
      const double weight = 1 / (1 + std::pow(residual / limit, 4));
      w += weight, x += weight * p.expected, y += weight * p.disparity;
      xx += weight * p.expected * p.expected, xy += weight * p.expected * p.disparity;
    }
    const double determinant = w * xx - x * x;
    if (!(determinant > 0)) break;
    line = {(w * xy - x * y) / determinant, (xx * y - x * xy) / determinant};
  }
  return line;
}

constexpr std::size_t least_points = 60;

Finding rows_finding(const std::vector<Point>& points) {
  constexpr double most = 0.6;  // pixels; 0.1 to 0.3 on pairs without the fault
  std::vector<double> errors, sizes;
  for (const Point& p : points) errors.push_back(p.row_error), sizes.push_back(std::abs(p.row_error));
  const double size = median(sizes), mean = median(errors);
  const std::string said = "Half of " + text(static_cast<int>(points.size())) + " points lie over " + number(size, 2) +
                           " rows higher or lower in the right image (median " + number(mean, 2) + " lower).";
  if (size <= most) return fine("pair-rows", size, "px", said);
  return faulty(
      "pair-rows", size, "px", said,
      "Rectify the pair: what lies in a row of the left image must lie in the same row of the right one. Over "
      "half a row costs depth, over two rows most of it.");
}

Findings depth_findings(const std::vector<Point>& points) {
  constexpr double most_bias = 0.6;  // pixels
  constexpr double most_scale = 0.02, of_calibration = 0.25;
  const Line line = fit(points);
  Findings findings;
  if (!(line.scale > 0)) return {unknown("disparity-bias", "The depths of the points are too much alike.")};
  if (std::abs(std::log(line.scale)) > of_calibration) {
    findings.push_back(faulty("depth-unit", line.scale, "times too far",
                              "The depths are " + number(line.scale, 2) + " times those of the pair of images.",
                              "State the unit of the depth, the baseline in metres, and the focal length in pixels "
                              "of these images."));
    findings.push_back(unknown("disparity-bias", "The unit of the depth is wrong."));
    return findings;
  }
  findings.push_back(fine("depth-unit", line.scale, "times too far", "The depths are those of the pair of images."));
  const double percent = 100 * (1 / line.scale - 1);
  const std::string scale = "Focal length times baseline is " + number(std::abs(percent), 1) + " % " +
                            (percent > 0 ? "more" : "less") + " than the disparities of the pair say.";
  findings.push_back(
      std::abs(percent) > 100 * most_scale
          ? faulty("focal-baseline", percent, "%", scale,
                   "Use the calibration of the rectified images; look whether they were scaled or cropped.")
          : fine("focal-baseline", percent, "%", scale));
  const std::string bias = "The depth's disparities are " + number(std::abs(line.bias), 2) + " px " +
                           (line.bias < 0 ? "larger" : "smaller") + " than those of the pair.";
  findings.push_back(std::abs(line.bias) > most_bias
                         ? faulty("disparity-bias", -line.bias, "px", bias,
                                  "Look for a difference of the principal points of the pair, or for a crop, that the "
                                  "computation of the depth leaves out.")
                         : fine("disparity-bias", -line.bias, "px", bias));
  return findings;
}

}  // namespace

Findings check_pair(const Samples& samples) {
  const bool any =
      std::any_of(samples.frames.begin(), samples.frames.end(), [](const Sample& f) { return !f.right.empty(); });
  const auto none = [](const std::string& why) {
    return Findings{unknown("pair-rows", why), unknown("disparity-bias", why)};
  };
  if (!any)
    return none(samples.recording.distortion ? "The images have distortion: a pair must be rectified."
                                             : "There are no right images.");
  const std::vector<Point> points = match(samples);
  if (points.size() < least_points) return none("Too few points are found in both images.");
  Findings findings{rows_finding(points)};
  const auto with_depth = static_cast<std::size_t>(
      std::count_if(points.begin(), points.end(), [](const Point& p) { return p.expected > 0; }));
  if (samples.depth_from_pair || with_depth < least_points) {
    findings.push_back(unknown("disparity-bias", samples.depth_from_pair ? "The depth is computed from the pair."
                                                                         : "Too few of the points have depth."));
    return findings;
  }
  for (Finding& finding : depth_findings(points)) findings.push_back(std::move(finding));
  return findings;
}

}  // namespace check
