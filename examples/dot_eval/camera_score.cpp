// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "camera_score.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "pose_error.hpp"
#include "statistics.hpp"

namespace eval {
namespace {

/// How the motion from `a` to `b` of the estimate differs from the true one.
Eigen::Matrix4d difference(const Poses& truth, const Poses& estimate, std::size_t a, std::size_t b) {
  const Eigen::Matrix4d true_motion = truth[a].inverse() * truth[b];
  const Eigen::Matrix4d motion = estimate[a].inverse() * estimate[b];
  return true_motion.inverse() * motion;
}

double translation(const Eigen::Matrix4d& T) { return T.topRightCorner<3, 1>().norm(); }

double rotation_deg(const Eigen::Matrix4d& T) { return rotation_angle_deg(T.topLeftCorner<3, 3>()); }

/// Positions with their mean taken away, a column each.
Eigen::Matrix3Xd centred_positions(const Poses& poses) {
  Eigen::Matrix3Xd positions(3, static_cast<Eigen::Index>(poses.size()));
  for (std::size_t i = 0; i < poses.size(); ++i)
    positions.col(static_cast<Eigen::Index>(i)) = poses[i].topRightCorner<3, 1>();
  return positions.colwise() - positions.rowwise().mean().eval();
}

/// RMS distance under the rotation and shift that make it smallest (Umeyama 1991, without scale).
double aligned_error(const Poses& truth, const Poses& estimate) {
  const Eigen::Matrix3Xd a = centred_positions(truth);
  const Eigen::Matrix3Xd b = centred_positions(estimate);
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(b * a.transpose(), Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Matrix3d& U = svd.matrixU();
  const Eigen::Matrix3d& V = svd.matrixV();
  const Eigen::Vector3d signs(1, 1, (V * U.transpose()).determinant() < 0 ? -1 : 1);
  const Eigen::Matrix3d R = V * signs.asDiagonal() * U.transpose();
  return std::sqrt((a - R * b).colwise().squaredNorm().mean());
}

/// @param distance true path up to each frame, metres.
std::optional<StretchError> stretch_error(const Poses& truth, const Poses& estimate,
                                          const std::vector<double>& distance) {
  constexpr std::size_t every = 10;  // frames between starts
  std::vector<double> percent;
  std::vector<double> deg_per_100m;
  for (std::size_t first = 0; first < truth.size(); first += every) {
    for (int length = 100; length <= 800; length += 100) {
      const auto end = std::upper_bound(distance.begin(), distance.end(), distance[first] + length);
      if (end == distance.end()) break;
      const Eigen::Matrix4d error =
          difference(truth, estimate, first, static_cast<std::size_t>(end - distance.begin()));
      percent.push_back(100 * translation(error) / length);
      deg_per_100m.push_back(100 * rotation_deg(error) / length);
    }
  }
  if (percent.empty()) return std::nullopt;
  return StretchError{mean(percent), mean(deg_per_100m), static_cast<int>(percent.size())};
}

}  // namespace

double CameraScore::rpe_trans_cm() const { return root_mean_square(step_cm); }
double CameraScore::rpe_trans_median_cm() const { return median(step_cm); }
double CameraScore::rpe_trans_max_cm() const { return percentile(step_cm, 100); }
double CameraScore::rpe_rot_deg() const { return root_mean_square(step_deg); }
double CameraScore::rpe_rot_median_deg() const { return median(step_deg); }
double CameraScore::nees_per_axis() const { return mean(step_nees); }

double camera_nees(const dot::SE3d& truth, const dot::SE3d& estimate, const dot::Matrix6<double>& covariance) {
  const dot::Vector6<double> error = (estimate * truth.inverse()).log();
  return error.dot(covariance.ldlt().solve(error)) / 6;
}

CameraScore score_camera(const Poses& truth, const Poses& estimate) {
  constexpr double cm_per_m = 100;
  CameraScore score;
  score.frames = static_cast<int>(truth.size());
  std::vector<double> distance{0};
  for (std::size_t i = 0; i + 1 < truth.size(); ++i) {
    const Eigen::Matrix4d error = difference(truth, estimate, i, i + 1);
    score.step_cm.push_back(cm_per_m * translation(error));
    score.step_deg.push_back(rotation_deg(error));
    distance.push_back(distance.back() + translation(truth[i].inverse() * truth[i + 1]));
  }
  score.path_m = distance.back();
  score.drift_percent = 100 * ratio(translation(difference(truth, estimate, 0, truth.size() - 1)), score.path_m);
  score.ate_m = aligned_error(truth, estimate);
  score.stretch = stretch_error(truth, estimate, distance);
  return score;
}

}  // namespace eval
