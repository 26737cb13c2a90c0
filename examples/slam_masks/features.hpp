// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <opencv2/core.hpp>
#include <opencv2/features2d.hpp>
#include <vector>

namespace slam {

/// Square cells over an image.
struct Grid {
  int columns = 0;
  int rows = 0;

  Grid() = default;
  explicit Grid(cv::Size image);
  std::size_t size() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  }
  /// Column and row of the cell at a place, or of the nearest one for a place outside.
  cv::Point cell(const cv::Point2d& place) const;
};

/// The features of a frame that lie outside a mask; row i of `descriptors` belongs to element i of the vectors.
struct Features {
  std::vector<cv::Point2f> pixels;
  std::vector<float> sigmas;  ///< of the pixel coordinates, px: a corner of a coarser level is found less exactly
  std::vector<float> depths;  ///< metres; 0 where none was measured
  cv::Mat descriptors;
  Grid grid;
  std::vector<std::vector<std::size_t>> cells;  ///< indices of the features in each cell

  std::size_t size() const { return pixels.size(); }

  /// Indices of those at most `radius` from a place, px.
  std::vector<std::size_t> near(const cv::Point2d& place, double radius) const;
};

/// ORB corners, spread over the image.
class FeatureExtractor {
 public:
  explicit FeatureExtractor(int budget);

  /// Looks for corners everywhere, once for all masks of a frame.
  /// @param image 8 bit, grey, BGR or BGRA. @param depth CV_32FC1, metres.
  void set_frame(const cv::Mat& image, const cv::Mat& depth);

  /// The strongest corners outside the mask, the same number in each cell of a grid as far as there are so many: what
  /// is excluded costs features only where the rest of the image has none to offer.
  /// @param exclude CV_8UC1, 255 = do not use.
  Features outside(const cv::Mat& exclude);

 private:
  int budget_ = 0;
  cv::Ptr<cv::ORB> orb_;
  cv::Mat grey_;
  cv::Mat depth_;
  std::vector<cv::KeyPoint> corners_;  ///< strongest first
};

}  // namespace slam
