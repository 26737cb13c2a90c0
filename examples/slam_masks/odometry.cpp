// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "odometry.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/features2d.hpp>

namespace slam {

namespace {

constexpr double drawn_share = 0.7;     // of the features that have a depth
constexpr float distinct = 0.8F;        // nearest descriptor against the second nearest
constexpr double same_descriptor = 64;  // bits of 256
constexpr double search_radii[] = {8, 4};
constexpr double nearest_point = 0.1;  // metres
constexpr double ransac_pixels = 3;
constexpr int ransac_rounds = 300;
constexpr int fewest_inliers = 15;
constexpr double keyframe_share = 0.5;  // of the most inliers; with fewer the next keyframe is due
constexpr double chi2_95 = 7.815;       // three degrees of freedom

dot::Vector3<double> back_project(const dot::Intrinsics& camera, const cv::Point2f& pixel, double z) {
  return {(pixel.x - camera.cx) / camera.fx * z, (pixel.y - camera.cy) / camera.fy * z, z};
}

}  // namespace

Odometry::Odometry(const dot::Intrinsics& camera, const dot::DepthNoise& noise, std::uint64_t seed)
    : camera_(camera), noise_(noise), random_(seed) {}

const dot::SE3d& Odometry::track(const Features& frame) {
  if (!started_) {
    started_ = true;
    set_keyframe(frame);
    return T_world_frame_;
  }
  const dot::SE3d predicted = T_world_frame_ * T_prev_frame_;
  dot::SE3d T_frame_key = consensus(match_anywhere(frame)).value_or(predicted.inverse() * T_world_key_);
  int inliers = 0;
  for (const double radius : search_radii) inliers = refine(match_near(frame, T_frame_key, radius), T_frame_key);
  const bool found = inliers >= fewest_inliers;
  if (!found) ++lost_;

  const dot::SE3d T_world_now = found ? (T_world_key_ * T_frame_key.inverse()).normalized() : predicted;
  T_prev_frame_ = T_world_frame_.inverse() * T_world_now;
  T_world_frame_ = T_world_now;
  most_inliers_ = std::max(most_inliers_, inliers);
  if (!found || inliers < keyframe_share * most_inliers_) set_keyframe(frame);
  return T_world_frame_;
}

void Odometry::set_keyframe(const Features& frame) {
  T_world_key_ = T_world_frame_;
  most_inliers_ = 0;
  points_.clear();
  descriptors_ = cv::Mat(0, frame.descriptors.cols, CV_8UC1);
  for (std::size_t i = 0; i < frame.size(); ++i) {
    if (random_.uniform(0.0, 1.0) > drawn_share || frame.depths[i] <= 0) continue;
    points_.push_back({back_project(camera_, frame.pixels[i], frame.depths[i]), noise_.pixel_sigma(1 / frame.depths[i]),
                       frame.sigmas[i]});
    descriptors_.push_back(frame.descriptors.row(static_cast<int>(i)));
  }
}

std::vector<Odometry::Match> Odometry::match_anywhere(const Features& frame) const {
  std::vector<Match> matches;
  if (points_.empty() || frame.size() < 2) return matches;
  std::vector<std::vector<cv::DMatch>> nearest;
  cv::BFMatcher(cv::NORM_HAMMING).knnMatch(descriptors_, frame.descriptors, nearest, 2);
  for (const std::vector<cv::DMatch>& pair : nearest) {
    if (pair[0].distance < distinct * pair[1].distance)
      matches.push_back(make_match(frame, static_cast<std::size_t>(pair[0].trainIdx),
                                   points_[static_cast<std::size_t>(pair[0].queryIdx)]));
  }
  return matches;
}

std::vector<Odometry::Match> Odometry::match_near(const Features& frame, const dot::SE3d& T_frame_key,
                                                  double radius) const {
  std::vector<Match> matches;
  for (std::size_t p = 0; p < points_.size(); ++p) {
    const dot::Vector3<double> X = T_frame_key * points_[p].X;
    if (X.z() < nearest_point) continue;
    const cv::Point2d expected(camera_.fx * X.x() / X.z() + camera_.cx, camera_.fy * X.y() / X.z() + camera_.cy);
    double least = same_descriptor;
    std::size_t best = frame.size();
    for (const std::size_t f : frame.near(expected, radius * points_[p].sigma)) {
      const double distance =
          cv::norm(descriptors_.row(static_cast<int>(p)), frame.descriptors.row(static_cast<int>(f)), cv::NORM_HAMMING);
      if (distance < least) {
        least = distance;
        best = f;
      }
    }
    if (best < frame.size()) matches.push_back(make_match(frame, best, points_[p]));
  }
  return matches;
}

Odometry::Match Odometry::make_match(const Features& frame, std::size_t feature, const Point& point) {
  const float z = frame.depths[feature];
  return {&point, frame.pixels[feature].x, frame.pixels[feature].y, std::hypot(point.sigma, frame.sigmas[feature]),
          z > 0 ? 1.0 / z : 0};
}

std::optional<dot::SE3d> Odometry::consensus(const std::vector<Match>& matches) const {
  if (matches.size() < fewest_inliers) return std::nullopt;
  std::vector<cv::Point3d> points;
  std::vector<cv::Point2d> pixels;
  for (const Match& m : matches) {
    points.emplace_back(m.point->X.x(), m.point->X.y(), m.point->X.z());
    pixels.emplace_back(m.u, m.v);
  }
  const cv::Matx33d K(camera_.fx, 0, camera_.cx, 0, camera_.fy, camera_.cy, 0, 0, 1);
  cv::Vec3d rotation, translation;
  std::vector<int> inliers;
  if (!cv::solvePnPRansac(points, pixels, K, cv::noArray(), rotation, translation, false, ransac_rounds, ransac_pixels,
                          0.999, inliers, cv::SOLVEPNP_AP3P) ||
      inliers.size() < fewest_inliers)
    return std::nullopt;
  return dot::SE3d{dot::so3::exp(dot::Vector3<double>(rotation[0], rotation[1], rotation[2])),
                   {translation[0], translation[1], translation[2]}};
}

int Odometry::refine(const std::vector<Match>& matches, dot::SE3d& T_frame_key) const {
  constexpr int iterations = 12;
  for (int iteration = 0;; ++iteration) {
    dot::Matrix6<double> H = dot::Matrix6<double>::Zero();
    dot::Vector6<double> b = dot::Vector6<double>::Zero();
    int inliers = 0;
    for (const Match& m : matches) {
      const dot::Vector3<double> X = T_frame_key * m.point->X;
      if (X.z() < nearest_point) continue;
      const double q = 1 / X.z();
      // Rows: pixel coordinates and inverse depth of the point; columns of `by_X`: its coordinates.
      dot::Matrix3<double> by_X;
      by_X << camera_.fx * q, 0, -camera_.fx * X.x() * q * q,  //
          0, camera_.fy * q, -camera_.fy * X.y() * q * q,      //
          0, 0, -q * q;
      const dot::Vector3<double> residual(camera_.fx * X.x() * q + camera_.cx - m.u,
                                          camera_.fy * X.y() * q + camera_.cy - m.v, m.q > 0 ? q - m.q : 0);
      // An error of the keyframe's depth moves the point along its ray there, by dX/dq = -z X.
      const dot::Vector3<double> by_depth = by_X * (T_frame_key.R * m.point->X) * (m.point->X.z() * m.point->sigma_q);
      dot::Matrix3<double> covariance = by_depth * by_depth.transpose();
      covariance(0, 0) += m.sigma * m.sigma;
      covariance(1, 1) += m.sigma * m.sigma;
      // Without a measurement the third row says nothing: a variance without bound.
      const double sigma_q = m.q > 0 ? noise_.pixel_sigma(q) : 1e6;
      covariance(2, 2) += sigma_q * sigma_q;
      const dot::Matrix3<double> information = covariance.inverse();
      const double chi2 = residual.dot(information * residual);
      if (chi2 < chi2_95) ++inliers;
      const double weight = 1 / (1 + chi2 / chi2_95);  // Cauchy's: what does not fit fades
      Eigen::Matrix<double, 3, 6> J;
      J << by_X, -by_X * dot::so3::hat(X);
      H += weight * J.transpose() * information * J;
      b += weight * J.transpose() * (information * residual);
    }
    if (iteration == iterations || inliers < fewest_inliers) return inliers;
    const dot::Vector6<double> step = -H.ldlt().solve(b);
    if (!step.allFinite()) return 0;
    T_frame_key = dot::SE3d::exp(step) * T_frame_key;
  }
}

}  // namespace slam
