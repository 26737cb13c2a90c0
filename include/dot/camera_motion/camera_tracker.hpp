// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "dot/camera_motion/background.hpp"
#include "dot/camera_motion/background_mask.hpp"
#include "dot/camera_motion/bias_learning.hpp"
#include "dot/camera_motion/constant_velocity.hpp"
#include "dot/camera_motion/depth_learning.hpp"
#include "dot/camera_motion/estimator.hpp"
#include "dot/camera_motion/first_intervals.hpp"
#include "dot/camera_motion/fixed_parts.hpp"
#include "dot/camera_motion/host_motion.hpp"
#include "dot/camera_motion/lens_distortion.hpp"
#include "dot/camera_motion/unexpected_turn.hpp"
#include "dot/camera_motion/usual_correlation.hpp"
#include "dot/frame/frame.hpp"
#include "dot/frame/frame_data.hpp"
#include "dot/mask/painted_image.hpp"
#include "dot/points/select.hpp"

DOT_BEGIN_NAMESPACE

/// Estimates the camera's motion from frame to frame by the background. Learns the noise and the bias of the depth from
/// the background. Keeps the background's points, the camera's velocity and the learnt noise and bias.
template <typename Camera, typename Noise, typename Aligner>
class CameraTracker {
 public:
  /// The camera's motion from `prev` to `cur` (paper, section 3.3).
  /// @param prev null if there is none. @param seconds from `prev` to `cur`; 0 if it is too long or `prev` is null.
  /// @param objects their points in `prev`. Objects that stand confirm the motion, see MotionChoice.
  CameraStep track(const FramePtr& prev, const FrameData& cur, double seconds, const HostMotion& host,
                   const std::vector<const PointSet*>& objects, const Camera& camera,
                   const CameraMotionEstimator& estimator, Aligner& aligner, MinimaWorkspace& workspace);

  /// The earlier intervals that the last one proved to be wrong, the oldest first, with their right motions. What was
  /// concluded from them is wrong, too.
  const std::vector<RevisedInterval>& revised() const { return revised_; }

  /// Whether earlier motions proved to be wrong: those of `revised`, or all of a camera that parts of the image have
  /// held, see FixedParts.
  bool refuted() const { return refuted_; }

  /// Learns the noise and bias of the depth from the background. Must be called after `track`. @param noise is scaled.
  void learn_depth(const FrameData& cur, const CameraStep& step, const Camera& camera, const AlignSettings& settings,
                   int min_points, Noise& noise);

  /// What an unsteady scale of the depth adds to the covariance of a step (ScaleJitter). Objects share the scale, so it
  /// is not part of what the camera's error adds to theirs. Must be called after `learn_depth`.
  Matrix6<double> scale_covariance(const CameraStep& step) const;

  /// Finds what does not move with the scene. @param step led to `cur`. @param labels non-zero where objects are.
  /// @param ids which object it is, 0 = none. @param others boxes that may show movers, too.
  void find_fixed_parts(const FrameData& cur, const CameraStep& step, const PaintedImage<std::uint8_t>& labels,
                        const Image<std::uint32_t>& ids, const std::vector<std::array<int, 4>>& others,
                        const Camera& camera, const kernel::Kernels& kernels, const Threads& threads);

  /// Pixels that show something drawn over the image, also on objects.
  const OverlaidPixels& overlaid() const { return fixed_parts_.overlaid(); }

  /// Selects the points for measuring the next frame's motion, outside all objects and fixed parts. Must be called
  /// after `find_fixed_parts`. @param step led to `cur`.
  /// @return whether there are enough of them. Otherwise the present points are kept for the next frame.
  bool take_background(const FrameData& cur, const CameraStep& step, const Selector<Camera, Noise>& select,
                       int min_points);

  /// The bias to be subtracted from the next frame's depth.
  DepthBias depth_bias() const { return bias_learning_.bias(); }

  /// Standard deviation of the depth's scale from frame to frame, relative; 0 while it is not known.
  double scale_sigma() const { return std::sqrt(depth_learning_.scale_jitter.variance()); }

  /// Share of the image that does not move with the scene, 0 if it is too small to matter.
  double fixed_share() const { return fixed_parts_.share(); }

  /// Pixels by which the host's motion of the last interval moves the background otherwise than the image, if that
  /// refutes it; otherwise 0. At most the width of the image.
  double host_error() const { return host_error_; }

  /// Pixels by which a radial distortion that the camera model lacks moves a corner of the image, 0 if there is none.
  double distortion(const Camera& camera) const { return lens_.shift(camera); }

  /// Whether the motion was measured in every frame since the one of the background's points.
  bool is_sure() const { return !background_.guessed; }

  /// Forgets the frames, but keeps the learnt noise and bias.
  void forget_frames() noexcept {
    background_.forget();
    first_intervals_.clear();
    depth_learning_.clear();
  }
  /// Forgets everything.
  void forget() noexcept {
    background_.forget();
    first_intervals_.clear();
    revised_.clear();
    depth_learning_.forget();
    bias_learning_.forget();
    fixed_parts_.forget();
    held_ = refuted_ = false;
    velocity_known_ = velocity_measured_ = false;
    unseen_seconds_ = 0;
    steady_ = still_ = 0;
    host_error_ = 0;
    lens_ = {};
    turning_rows_ = 0;
    velocity_.setZero();
    correlation_ = {};
  }

 private:
  static constexpr double kSteady = 2;         ///< intervals in a row that make a velocity steady
  static constexpr double kShareOfNew = 0.25;  ///< of a frame in `turning_rows_`: three in a row make it the most
  static constexpr double kStill = 0.25;       ///< pixels by which the points move at most if the image is the same
  static constexpr double kKept = 0.25;        ///< share of the reach up to which an interval keeps the velocity

  /// T_cur_prev of each start, the most trusted first: from the host, and at constant velocity.
  void predict(const HostMotion& host, double seconds);
  void take_velocity(const CameraStep& step, const SE3d& predicted, double reach);
  void take_host_motion(const CameraMotion& motion, const FrameData& cur, const Camera& camera,
                        const CameraSettings& settings, Aligner& aligner, CameraStep& step) const;
  /// Replaces the host's motion by the image's own where that refutes it. @return as `estimate`.
  bool check_host_motion(const FramePtr& prev, const FrameData& cur, const HostMotion& host,
                         const std::vector<const PointSet*>& objects, const Camera& camera,
                         const CameraMotionEstimator& estimator, Aligner& aligner, MinimaWorkspace& workspace,
                         CameraStep& step);
  /// @return whether the motion was searched, because the velocity was not known or did not lead to it.
  bool estimate(const FramePtr& prev, const FrameData& cur, bool expected, const std::vector<const PointSet*>& objects,
                const Camera& camera, const CameraMotionEstimator& estimator, Aligner& aligner,
                MinimaWorkspace& workspace, CameraStep& step);
  static Matrix6<double> covariance_of_guess(const CameraSettings& settings, double seconds);

  Background background_;
  Vector6<double> velocity_ = Vector6<double>::Zero();  ///< twist per second
  bool velocity_known_ = false;                         ///< whether it is of the last interval
  bool velocity_measured_ = false;                      ///< whether it is the image's, not the host's
  double unseen_seconds_ = 0;                           ///< of the repeated images before the newest frame
  int steady_ = 0;                                      ///< intervals in a row that kept the velocity
  int still_ = 0;  ///< intervals since a search, all without motion, up to those that repeated images may explain
  double host_error_ = 0;    ///< see `host_error`
  double turning_rows_ = 0;  ///< share of the last frames whose rows turn (RollingShutter)
  LensDistortion lens_;
  UsualCorrelation correlation_;
  FirstIntervals first_intervals_;
  std::vector<RevisedInterval> revised_;
  FixedParts fixed_parts_;
  bool held_ = false;     ///< fixed parts were found in the last frame that have held the camera before
  bool refuted_ = false;  ///< see `refuted`
  DepthLearning depth_learning_;
  DepthBiasLearning bias_learning_;

  PointSet fresh_;
  BackgroundMask mask_;
  std::vector<SE3d> starts_ = std::vector<SE3d>(4);  ///< see `predict`; there are four at most
};

DOT_END_NAMESPACE

#include "dot/camera_motion/impl/camera_tracker.hpp"
