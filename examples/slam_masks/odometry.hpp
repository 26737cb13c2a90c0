// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "dot/camera/depth_noise.hpp"
#include "dot/camera/intrinsics.hpp"
#include "dot/lie/se3.hpp"
#include "features.hpp"

namespace slam {

/// Visual odometry from features with depth: each frame is matched to a keyframe, RANSAC finds the motion that most
/// matches agree on, Gauss-Newton refines it. It takes the world for rigid, as most SLAM systems do; what moves must be
/// kept out of the features.
class Odometry {
 public:
  /// @param seed of the points drawn: each keyframe gives a random part of its features, so that runs with several
  ///   seeds show how much of an error is chance.
  Odometry(const dot::Intrinsics& camera, const dot::DepthNoise& noise, std::uint64_t seed);

  /// Pose of the next frame's camera in the first one's.
  const dot::SE3d& track(const Features& frame);

  /// Frames so far in which too few matches agreed; the camera then went on as in the frame before.
  int lost() const { return lost_; }

 private:
  struct Point {
    dot::Vector3<double> X;  ///< in the keyframe's camera
    double sigma_q = 0;      ///< of its inverse depth, 1/m
    double sigma = 0;        ///< of its pixel coordinates, px
  };
  struct Match {
    const Point* point = nullptr;
    double u = 0, v = 0;  ///< px
    double sigma = 0;     ///< of the difference of the pixel coordinates, px
    double q = 0;         ///< inverse depth in the frame, 1/m; 0 where none was measured
  };

  void set_keyframe(const Features& frame);
  /// Each point's most similar feature, wherever it is, if it is so by far.
  std::vector<Match> match_anywhere(const Features& frame) const;
  /// Each point's most similar feature near the place to which T_frame_key takes it.
  /// @param radius px, times the point's sigma.
  std::vector<Match> match_near(const Features& frame, const dot::SE3d& T_frame_key, double radius) const;
  static Match make_match(const Features& frame, std::size_t feature, const Point& point);
  /// The motion that most matches agree on, if there are enough of them.
  std::optional<dot::SE3d> consensus(const std::vector<Match>& matches) const;
  /// Refines T_frame_key; returns the number of matches that agree with it.
  int refine(const std::vector<Match>& matches, dot::SE3d& T_frame_key) const;

  dot::Intrinsics camera_;
  dot::DepthNoise noise_;
  cv::RNG random_;
  std::vector<Point> points_;  ///< of the keyframe
  cv::Mat descriptors_;        ///< a row for each of them
  int most_inliers_ = 0;       ///< since the keyframe
  dot::SE3d T_world_key_;
  dot::SE3d T_world_frame_;
  dot::SE3d T_prev_frame_;
  bool started_ = false;
  int lost_ = 0;
};

}  // namespace slam
