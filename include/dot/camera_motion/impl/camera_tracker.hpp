// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <type_traits>

/// @file
/// Definitions of camera_motion/camera_tracker.hpp, which includes this file.

DOT_BEGIN_NAMESPACE

template <typename Camera, typename Noise, typename Aligner>
CameraStep CameraTracker<Camera, Noise, Aligner>::track(const FramePtr& prev, const FrameData& cur, double seconds,
                                                        const HostMotion& host,
                                                        const std::vector<const PointSet*>& objects,
                                                        const Camera& camera, const CameraMotionEstimator& estimator,
                                                        Aligner& aligner, MinimaWorkspace& workspace) {
  CameraStep step;
  step.seconds = seconds;
  revised_.clear();
  refuted_ = false;
  host_error_ = 0;
  background_.points.subtract_bias(cur.bias, camera.width(), camera.height());
  if (seconds <= 0) {
    velocity_known_ = false;
    unseen_seconds_ = 0;
    still_ = 0;
    first_intervals_.clear();
    if (prev) step.covariance = covariance_of_guess(estimator.settings, cur.timestamp - prev->timestamp);
    return step;
  }
  first_intervals_.keep_frame(prev);
  if (held_) velocity_known_ = false;
  predict(host, seconds);
  step.T_cur_prev = starts_.front();
  const SE3d at_constant_velocity = starts_.back();
  bool searched = false;
  if (host.motion) {
    take_host_motion(*host.motion, cur, camera, estimator.settings, aligner, step);
    searched = check_host_motion(prev, cur, host, objects, camera, estimator, aligner, workspace, step);
  } else if (background_.points.size() < estimator.settings.min_points) {
    step.status = CameraStatus::TooLittleDepth;
  } else {
    searched = estimate(prev, cur, host.prior.has_value(), objects, camera, estimator, aligner, workspace, step);
  }

  if (step.status != CameraStatus::Tracked) still_ = 0;
  const bool repeated = step.status == CameraStatus::Tracked && cur.is_repeated();
  const double unknown_seconds = seconds + unseen_seconds_;
  if (step.status != CameraStatus::Tracked || background_.guessed || repeated || unseen_seconds_ > 0) {
    first_intervals_.clear();
  } else {
    first_intervals_.revise(background_, cur, step, camera, estimator, aligner, workspace, revised_);
    first_intervals_.add(background_, step, searched || !revised_.empty());
  }
  const bool rows_turn = !step.rolling.turn.isZero(0);
  if (step.known()) turning_rows_ += kShareOfNew * ((rows_turn ? 1 : 0) - turning_rows_);
  step.rolling.is_usual = rows_turn && turning_rows_ > 0.5 && background_.seconds == 0;
  if (step.known() && !cur.is_repeated() && !background_.guessed)
    lens_.add(background_.points, cur.pyramid.levels[0], camera, step.alignment, aligner.settings,
              estimator.settings.covariance_scale);
  refuted_ = !revised_.empty() || (held_ && step.status != CameraStatus::FromHost);
  held_ = false;
  if (repeated)
    unseen_seconds_ += seconds;
  else
    take_velocity(step, at_constant_velocity, estimator.reach(seconds));
  if (!step.known()) {
    step.covariance = covariance_of_guess(estimator.settings, unknown_seconds);
  } else if (step.status == CameraStatus::Tracked && background_.guessed) {
    // The previous frame's pose was a guess. Only the motion since the frame of the points is known well.
    const Matrix6<double> Ad = step.T_cur_prev.adjoint();
    step.covariance += Ad * background_.guess_covariance * Ad.transpose();
  }
  return step;
}

template <typename Camera, typename Noise, typename Aligner>
void CameraTracker<Camera, Noise, Aligner>::predict(const HostMotion& host, double seconds) {
  starts_.clear();
  if (host.prior) starts_.push_back(SE3d::from_row_major(*host.prior).normalized());
  if (velocity_known_ && unseen_seconds_ > 0) starts_.push_back(SE3d::exp(velocity_ * (unseen_seconds_ + seconds)));
  starts_.push_back(SE3d::exp(velocity_ * seconds));
}

/// Takes the velocity of an interval. After repeated images a motion between images is that since the last new one. But
/// if they were inserted for another frame rate, it is the interval's own: then this changes the velocity less.
/// @param predicted T_cur_prev at constant velocity. @param reach metres by which an interval may differ from that.
template <typename Camera, typename Noise, typename Aligner>
void CameraTracker<Camera, Noise, Aligner>::take_velocity(const CameraStep& step, const SE3d& predicted, double reach) {
  const bool kept = unseen_seconds_ == 0 && change_of_place(step.T_cur_prev, predicted) < kKept * reach;
  steady_ = velocity_known_ && step.known() && kept ? steady_ + 1 : 0;
  if (step.known()) {
    const bool guessed = step.status == CameraStatus::Tracked && background_.guessed;
    const Vector6<double> own = guessed ? step.alignment.state.T.log() / (background_.seconds + step.seconds)
                                        : step.T_cur_prev.log() / step.seconds;
    const Vector6<double> since_new = own * step.seconds / (unseen_seconds_ + step.seconds);
    const bool is_own = guessed || step.status == CameraStatus::FromHost ||
                        (velocity_known_ && (own - velocity_).norm() < (since_new - velocity_).norm());
    velocity_ = is_own ? own : since_new;
  }
  velocity_known_ = step.known();
  velocity_measured_ = step.status == CameraStatus::Tracked;
  unseen_seconds_ = 0;
}

template <typename Camera, typename Noise, typename Aligner>
void CameraTracker<Camera, Noise, Aligner>::take_host_motion(const CameraMotion& motion, const FrameData& cur,
                                                             const Camera& camera, const CameraSettings& settings,
                                                             Aligner& aligner, CameraStep& step) const {
  step.status = CameraStatus::FromHost;
  step.T_cur_prev = SE3d::from_row_major(motion.T_cur_prev).normalized();
  const Eigen::Map<const Matrix6<double>, Eigen::Unaligned> covariance(motion.covariance.data());
  step.covariance = 0.5 * (covariance + covariance.transpose());
  const AlignProblem<Camera> problem{background_.points, cur.pyramid, camera};
  step.alignment.state = aligner.photometry(problem, step.T_cur_prev * background_.T_now_points);
  step.alignment.sigma_intensity = aligner.intensity_sigma(problem, step.alignment.state, 0);
  step.rolling = RollingShutter::measure(problem.points, cur.pyramid.levels[0], camera, step.alignment,
                                         aligner.settings, settings.covariance_scale);
  step.rolling.in_motion.setZero();  // the motion was not found by these residuals
  step.covariance += step.rolling.covariance_of_all();
}

/// Images that come again do not show the camera's motion, and after a guess the image does not tell that of the last
/// interval alone. With a rolling shutter the image's own motion is less exact than its covariance says.
template <typename Camera, typename Noise, typename Aligner>
bool CameraTracker<Camera, Noise, Aligner>::check_host_motion(const FramePtr& prev, const FrameData& cur,
                                                              const HostMotion& host,
                                                              const std::vector<const PointSet*>& objects,
                                                              const Camera& camera,
                                                              const CameraMotionEstimator& estimator, Aligner& aligner,
                                                              MinimaWorkspace& workspace, CameraStep& step) {
  constexpr int kEnough = 500;          // points for the first look
  constexpr double kRollingPixels = 1;  // by which the two motions differ at least where rows turn
  const PointSet& points = background_.points;
  if (points.size() < estimator.settings.min_points || host.is_mounted() || background_.guessed || cur.is_repeated() ||
      prev->is_repeated() || unseen_seconds_ > 0)
    return false;
  const AlignProblem<Camera> problem{points, cur.pyramid, camera}, few{workspace.few, cur.pyramid, camera};
  workspace.few.take_every(std::max(1, points.size() / kEnough), points);
  const AlignState stated = step.alignment.state;
  if (!HostMotionCheck::doubts(few, stated, step, estimator, aligner)) return false;
  velocity_known_ = velocity_known_ && velocity_measured_;
  starts_.insert(starts_.begin(), step.T_cur_prev);
  CameraStep own;
  own.seconds = step.seconds;
  const bool searched = estimate(prev, cur, true, objects, camera, estimator, aligner, workspace, own);
  if (!HostMotionCheck::refutes(problem, own, stated, step, estimator, aligner, workspace)) return false;
  const double error = pose_distance(points, camera, stated.T, own.alignment.state.T);
  const bool rows_turn = turning_rows_ > 0.5 || !own.rolling.turn.isZero(0) || !step.rolling.turn.isZero(0);
  if (rows_turn && error < kRollingPixels) return false;
  host_error_ = std::min<double>(camera.width(), error);
  step = own;
  return searched;
}

/// @param expected the host gave a start.
template <typename Camera, typename Noise, typename Aligner>
bool CameraTracker<Camera, Noise, Aligner>::estimate(const FramePtr& prev, const FrameData& cur, bool expected,
                                                     const std::vector<const PointSet*>& objects, const Camera& camera,
                                                     const CameraMotionEstimator& estimator, Aligner& aligner,
                                                     MinimaWorkspace& workspace, CameraStep& step) {
  const SE3d& T_prev_points = background_.T_now_points;
  for (SE3d& T : starts_) T = T * T_prev_points;
  const CameraSettings& s = estimator.settings;
  const TurnSearch turns{s.search_turn * step.seconds, prev->pyramid};
  bool known = velocity_known_ && unseen_seconds_ == 0;
  const auto align = [&](const CameraSearch* search) {
    MotionEvidence evidence{objects, T_prev_points.inverse()};
    evidence.turns = &turns;
    if (known) {
      evidence.reach = estimator.reach(step.seconds);
      if (!expected) evidence.steadiness = std::min(1.0, steady_ / kSteady);  // a host may know of a change
    }
    step.alignment =
        estimator.estimate(background_.points, cur.pyramid, camera, starts_, search, evidence, aligner, workspace);
  };
  const auto moved = [&] {
    return !is_near(background_.points, camera, step.alignment.state.T, T_prev_points, kStill);
  };
  const CameraSearch search{s.search_speed * step.seconds, s.search_turn * step.seconds, prev->pyramid, T_prev_points};
  align(velocity_known_ ? nullptr : &search);
  bool ok = estimator.accepts(step.alignment, velocity_known_ || expected), searched = !velocity_known_;
  // If nothing has moved since the search, the images may have been one, repeated, before a camera that moves.
  const bool starts = still_ > 0 && moved();
  if (velocity_known_ && (!ok || starts || correlation_.has_dropped(step.alignment.phi))) {  // another velocity
    const Alignment predicted = step.alignment;
    known = known && !starts;
    align(&search);
    searched = estimator.accepts(step.alignment, false) &&
               (!ok || starts || UsualCorrelation::is_much_better(step.alignment.phi, predicted.phi));
    if (!searched) step.alignment = predicted;
    ok = ok || searched;
  }
  still_ = (searched || still_ > 0) && still_ < FrameData::kLongestRun && !moved() ? still_ + 1 : 0;
  // After an unexpected turn, what explains less than usual needs as much evidence as without a prediction.
  const bool turns_as_predicted = std::any_of(starts_.begin(), starts_.end(), [&](const SE3d& predicted) {
    return !UnexpectedTurn::is_in(background_.points, camera, step.alignment.state.T, predicted);
  });
  if (!turns_as_predicted && correlation_.has_dropped(step.alignment.phi))
    ok = ok && estimator.accepts(step.alignment, false);
  step.status = ok ? CameraStatus::Tracked : CameraStatus::Lost;
  if (!ok) return true;
  if (!cur.is_repeated()) correlation_.add(step.alignment.phi);
  estimator.set_motion(AlignProblem<Camera>{background_.points, cur.pyramid, camera}, T_prev_points, aligner, step);
  return searched;
}

/// Covariance of a motion of which only the limits are known: uniform within the range of a search.
template <typename Camera, typename Noise, typename Aligner>
Matrix6<double> CameraTracker<Camera, Noise, Aligner>::covariance_of_guess(const CameraSettings& settings,
                                                                           double seconds) {
  constexpr double kFarthest = 1e4;  // metres, after a gap of any length; a host's motion may not be longer either
  constexpr double kHalfTurn = 3.14159265358979323846;
  const double metres = std::min(settings.search_speed * seconds, kFarthest);
  const double radians = std::min(settings.search_turn * seconds, kHalfTurn);
  Matrix6<double> covariance = Matrix6<double>::Zero();
  covariance.diagonal() << Vector3<double>::Constant(metres * metres / 3),
      Vector3<double>::Constant(radians * radians / 3);
  return covariance;
}

template <typename Camera, typename Noise, typename Aligner>
void CameraTracker<Camera, Noise, Aligner>::learn_depth(const FrameData& cur, const CameraStep& step,
                                                        const Camera& camera, const AlignSettings& settings,
                                                        int min_points, Noise& noise) {
  if constexpr (std::is_same_v<Noise, DepthNoise>) {
    if (step.seconds <= 0) return;
    if (refuted_) {  // learnt with the wrong motions
      depth_learning_.forget();
      bias_learning_.forget();
      noise.forget_scales();
    }
    if (!step.known() || background_.guessed)
      depth_learning_.clear();
    else
      depth_learning_.learn(camera, step.T_cur_prev, cur.inverse_depth(), cur.timestamp, noise, cur.bias);
    if (!step.known()) return;
    const DepthNoiseSettings& s = noise.settings;
    bias_learning_.prior = s.source == DepthSource::Stereo ? s.stereo_bias_px / noise.focal_baseline : 0;
    if (background_.points.size() >= min_points)
      bias_learning_.learn(background_.points, cur.pyramid.levels[0], camera, step.alignment, settings, step.seconds);
  }
}

template <typename Camera, typename Noise, typename Aligner>
Matrix6<double> CameraTracker<Camera, Noise, Aligner>::scale_covariance(const CameraStep& step) const {
  Matrix6<double> covariance = Matrix6<double>::Zero();
  const Vector3<double>& t = step.T_cur_prev.t;
  if (step.status == CameraStatus::Tracked)
    covariance.template topLeftCorner<3, 3>() = depth_learning_.scale_jitter.variance() * t * t.transpose();
  return covariance;
}

template <typename Camera, typename Noise, typename Aligner>
void CameraTracker<Camera, Noise, Aligner>::find_fixed_parts(const FrameData& cur, const CameraStep& step,
                                                             const PaintedImage<std::uint8_t>& labels,
                                                             const Image<std::uint32_t>& ids,
                                                             const std::vector<std::array<int, 4>>& others,
                                                             const Camera& camera, const kernel::Kernels& kernels,
                                                             const Threads& threads) {
  mask_.set(labels, others);
  held_ = fixed_parts_.update(cur, mask_.pixels, ids, step, camera, kernels, threads);
  fixed_parts_.exclude(mask_.pixels);
}

template <typename Camera, typename Noise, typename Aligner>
bool CameraTracker<Camera, Noise, Aligner>::take_background(const FrameData& cur, const CameraStep& step,
                                                            const Selector<Camera, Noise>& select, int min_points) {
  const int width = mask_.pixels.width(), height = mask_.pixels.height();
  if constexpr (std::is_same_v<Noise, DepthNoise>)
    depth_learning_.remember(select.camera, cur.inverse_depth(), mask_.pixels, cur.timestamp, cur.bias);
  fresh_.clear();
  const SelectionSettings& s = select.settings;
  select({{0, 0, width, height},
          mask_.pixels.view(),
          cur.inverse_depth().view(),
          s.background_points,
          s.window_radius,
          s.min_gradient},
         fresh_);
  const bool enough = fresh_.size() >= min_points;
  if (enough) {
    select.sample_intensities(fresh_);
    background_.replace(fresh_, cur.bias);
  } else {
    background_.carry(step);
  }
  return enough;
}

DOT_END_NAMESPACE
