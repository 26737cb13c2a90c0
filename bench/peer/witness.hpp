// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <vector>

#include <opencv2/calib3d.hpp>
#include <opencv2/features2d.hpp>

#include "dot/camera/intrinsics.hpp"
#include "dot/lie/se3.hpp"

namespace dot::bench {

/// The camera's motion from features alone, for recordings whose poses are in doubt: SIFT, matched by the ratio of
/// distances, then the pose from points and pixels (RANSAC, refined on its inliers). It shares with the aligners only
/// the depth of the first frame.
class Witness {
 public:
  explicit Witness(const Intrinsics& c) : camera_(c), sift_(cv::SIFT::create(6000, 3, 0.01)) {}

  /// Grey images, the first one's depth in metres (NaN where there is none), masks of the background.
  SE3d motion(const cv::Mat& from, const cv::Mat& depth, const cv::Mat& from_mask, const cv::Mat& to,
              const cv::Mat& to_mask) const {
    std::vector<cv::KeyPoint> before, after;
    cv::Mat described_before, described_after;
    sift_->detectAndCompute(from, from_mask, before, described_before);
    sift_->detectAndCompute(to, to_mask, after, described_after);
    std::vector<std::vector<cv::DMatch>> matches;
    cv::BFMatcher().knnMatch(described_before, described_after, matches, 2);
    std::vector<cv::Point3d> points;
    std::vector<cv::Point2d> pixels;
    for (const auto& two : matches) {
      if (two.size() < 2 || two[0].distance > 0.75f * two[1].distance) continue;
      const cv::Point2f p = before[static_cast<std::size_t>(two[0].queryIdx)].pt;
      const double z = depth.at<float>(cvRound(p.y), cvRound(p.x));
      if (!(z > 0)) continue;
      points.emplace_back((p.x - camera_.cx) / camera_.fx * z, (p.y - camera_.cy) / camera_.fy * z, z);
      pixels.emplace_back(after[static_cast<std::size_t>(two[0].trainIdx)].pt);
    }
    const cv::Matx33d K(camera_.fx, 0, camera_.cx, 0, camera_.fy, camera_.cy, 0, 0, 1);
    cv::Vec3d rotation, translation;
    std::vector<int> inliers;
    if (points.size() < kFewest ||
        !cv::solvePnPRansac(points, pixels, K, cv::noArray(), rotation, translation, false, 2000, 1, 0.9999, inliers))
      throw std::runtime_error("too few features to tell the motion");
    std::vector<cv::Point3d> agreeing;
    std::vector<cv::Point2d> seen;
    for (const int i : inliers) {
      agreeing.push_back(points[static_cast<std::size_t>(i)]);
      seen.push_back(pixels[static_cast<std::size_t>(i)]);
    }
    if (agreeing.size() < kFewest) throw std::runtime_error("too few features to tell the motion");
    cv::solvePnPRefineLM(agreeing, seen, K, cv::noArray(), rotation, translation);
    return {so3::exp(Vector3<double>(rotation[0], rotation[1], rotation[2])),
            {translation[0], translation[1], translation[2]}};
  }

 private:
  static constexpr std::size_t kFewest = 50;
  Intrinsics camera_;
  cv::Ptr<cv::SIFT> sift_;
};

}  // namespace dot::bench
