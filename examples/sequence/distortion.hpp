// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <opencv2/core.hpp>

#include "dot/camera/intrinsics.hpp"

namespace runner {

/// How a lens departs from a pinhole.
struct Distortion {
  enum class Model {
    RadTan,      ///< k1 k2 p1 p2 k3, OpenCV's five coefficients
    Equidistant  ///< k1 k2 k3 k4, OpenCV's fisheye model (Kannala and Brandt)
  };
  Model model = Model::RadTan;
  std::array<double, 5> coefficients{};

  /// Where the lens puts the ray (x, y, 1), on the plane z = 1. Equidistant: with the ray's angle t to the axis,
  /// t_d = t (1 + k1 t^2 + k2 t^4 + k3 t^6 + k4 t^8) is the distance from the centre.
  Eigen::Vector2d distort(const Eigen::Vector2d& ray) const;
};

/// Turns images of a lens into those of a pinhole with the same intrinsics. What the lens does not show is black,
/// without depth and without masks.
class Undistorter {
 public:
  Undistorter(const dot::Intrinsics& camera, const Distortion& distortion);

  /// Grey or colour, bilinear. Pixels beyond the image repeat its border, so that no edge arises there.
  cv::Mat image(const cv::Mat& image) const;

  /// Depths or ids: the nearest pixel's, since a mean of two surfaces is none. 0 beyond the image.
  cv::Mat labels(const cv::Mat& labels) const;

 private:
  cv::Mat map_x_, map_y_;
};

}  // namespace runner
