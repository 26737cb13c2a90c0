// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "measures.hpp"
#include "median.hpp"
#include "words.hpp"

/// @file
/// How much there is to work with: pixels that have depth, and contrast.

namespace check {
namespace {

Finding depth_finding(const Samples& samples) {
  // A lidar's points are spread over the picture, and planes between them are filled in.
  constexpr double least = 15, least_of_lidar = 1;  // per cent
  const dot::DepthSource source = samples.recording.depth_source;
  const bool dense = source == dot::DepthSource::Stereo || source == dot::DepthSource::Rgbd;
  std::vector<double> shares;
  for (const Sample& frame : samples.frames)  // those whose depth was left out say nothing of the others
    if (const int measured = cv::countNonZero(frame.depth > 0); measured > 0)
      shares.push_back(100.0 * measured / static_cast<double>(frame.depth.total()));
  const double share = shares.empty() ? 0 : median(shares);
  const std::string said = number(share, share < 10 ? 1 : 0) + " % of the pixels have depth.";
  if (share >= (dense ? least : least_of_lidar)) return fine("depth-sparse", share, "%", said);
  return faulty("depth-sparse", share, "%", said,
                dense
                    ? "Look at the matcher's settings, the range of the camera, light and rectification. If the depth "
                      "comes from a lidar, say so: `depth lidar` in intrinsics.txt, or depth_noise.source."
                    : "The tracker needs the depth of a few per cent of the pixels.");
}

constexpr int side = 32;  // pixels

/// Standard deviation of the grey values in a small square: of the richer squares of a picture.
double contrast(const cv::Mat& grey) {
  constexpr double richer = 0.7;
  std::vector<double> deviations;
  for (int y = 0; y + side <= grey.rows; y += side)
    for (int x = 0; x + side <= grey.cols; x += side) {
      cv::Scalar mean, deviation;
      cv::meanStdDev(grey(cv::Rect(x, y, side, side)), mean, deviation);
      deviations.push_back(deviation[0]);
    }
  return deviations.empty() ? 0 : quantile(std::move(deviations), richer);
}

Finding texture_finding(const Samples& samples) {
  // Grey values; 9 and more on the sequences tried. Of a KITTI sequence whose contrast was lowered to 7 a third of the
  // standing objects stayed undecided.
  constexpr double least = 8;
  if (const cv::Mat& grey = samples.frames[0].grey; std::min(grey.cols, grey.rows) < side)
    return unknown("texture-low", "The images are smaller than " + text(side) + " pixels.");
  std::vector<double> contrasts;
  for (std::size_t i = 0; i < samples.frames.size(); i += 4) contrasts.push_back(contrast(samples.frames[i].grey));
  const double found = median(contrasts);
  const std::string said =
      "In squares of 32 pixels the grey values spread by " + number(found, 1) + " (standard deviation).";
  if (found >= least) return fine("texture-low", found, "grey values", said);
  return faulty(
      "texture-low", found, "grey values", said,
      "More light, a longer exposure or more gain; a lens that is in focus; 8 bits that use the whole range of "
      "values. Plain walls alone do not show how the camera moves.");
}

}  // namespace

Findings check_amounts(const Samples& samples) { return {depth_finding(samples), texture_finding(samples)}; }

}  // namespace check
