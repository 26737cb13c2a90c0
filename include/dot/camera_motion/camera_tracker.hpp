// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "dot/camera_motion/background.hpp"
#include "dot/camera_motion/bias_learning.hpp"
#include "dot/camera_motion/depth_learning.hpp"
#include "dot/camera_motion/estimator.hpp"
#include "dot/frame/frame.hpp"
#include "dot/frame/frame_data.hpp"
#include "dot/image/morphology.hpp"
#include "dot/points/select.hpp"

DOT_BEGIN_NAMESPACE

/// What the host knows of the camera's motion over the last interval.
struct HostMotion {
  std::optional<CameraMotion> motion;           ///< to be taken instead of an estimate
  std::optional<std::array<double, 12>> prior;  ///< T_cur_prev, row-major 3x4, where the estimate is to start
};

/// The camera's motion from frame to frame, by the background, and what the background tells of the depth: how noisy
/// and how biased it is. Keeps the background's points, the camera's velocity and what was learnt.
template <typename Camera, typename Noise, typename Aligner>
class CameraTracker {
 public:
  /// The camera's motion from `prev` to `cur` (paper, section 3.3).
  /// @param prev null: there is none. @param seconds from it to `cur`; 0: too long, or there is none.
  CameraStep track(const FramePtr& prev, const FrameData& cur, double seconds, const HostMotion& host,
                   const Camera& camera, const CameraMotionEstimator& estimator, Aligner& aligner,
                   MinimaWorkspace& workspace);

  /// How wrong the depth is, by what the background shows, after `track`. @param noise is scaled by that.
  void learn_depth(const FrameData& cur, const CameraStep& step, const Camera& camera, const AlignSettings& settings,
                   int min_points, Noise& noise);

  /// Chooses the points by which the next frame's motion will be measured, of what no object covers.
  /// @param step that led to `cur`. @param labels non-zero where objects are.
  /// @return whether there are enough of them; otherwise the present points are to serve for the next frame, too.
  bool take_background(const FrameData& cur, const CameraStep& step, const Image<std::uint8_t>& labels,
                       const Selector<Camera, Noise>& select, int min_points);

  /// The bias to be subtracted from the next frame's depth.
  DepthBias depth_bias() const { return bias_learning_.bias(); }

  /// Whether the motion of the frames since the background was seen was measured, in all of them.
  bool is_sure() const { return !background_.guessed; }

  /// Forgets the frames, keeps what was learnt.
  void forget_frames() noexcept {
    background_.forget();
    depth_learning_.clear();
  }
  /// Forgets all.
  void forget() noexcept {
    background_.forget();
    depth_learning_.forget();
    bias_learning_.forget();
    velocity_known_ = false;
    velocity_.setZero();
  }

 private:
  /// T_cur_prev of each start, the most trusted first: from the host, and at constant velocity.
  void predict(const HostMotion& host, double seconds);
  void take_host_motion(const CameraMotion& motion, const FrameData& cur, const Camera& camera, Aligner& aligner,
                        CameraStep& step) const;
  void estimate(const FramePtr& prev, const FrameData& cur, bool expected, const Camera& camera,
                const CameraMotionEstimator& estimator, Aligner& aligner, MinimaWorkspace& workspace, CameraStep& step);
  static Matrix6<double> covariance_of_guess(const CameraSettings& settings, double seconds);

  Background background_;
  Vector6<double> velocity_ = Vector6<double>::Zero();  ///< twist per second
  bool velocity_known_ = false;                         ///< of the last interval
  DepthLearning depth_learning_;
  DepthBiasLearning bias_learning_;

  PointSet fresh_;
  Image<std::uint8_t> mask_;       ///< 255: background, some pixels away from any object
  Image<std::uint8_t> mask_rows_;  ///< scratch of the erosion that makes it
  std::vector<SE3d> starts_;
};

DOT_END_NAMESPACE

#include "dot/camera_motion/impl/camera_tracker.hpp"
