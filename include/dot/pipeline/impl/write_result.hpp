// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>

/// @file
/// Definitions of pipeline/dot.hpp, which includes this file.

DOT_BEGIN_NAMESPACE

namespace writing {

/// Copies row by row.
template <typename Derived, typename Out>
void copy(const Eigen::MatrixBase<Derived>& m, Out& out) {
  for (Eigen::Index r = 0; r < m.rows(); ++r)
    for (Eigen::Index c = 0; c < m.cols(); ++c) out[static_cast<std::size_t>(r * m.cols() + c)] = m(r, c);
}

inline CameraResult result_of(const CameraStep& step, const Matrix6<double>& covariance) {
  CameraResult out;
  out.status = step.status;
  out.T_cur_prev = step.T_cur_prev.row_major();
  copy(covariance, out.covariance);
  out.phi = step.alignment.phi;
  out.gain = step.alignment.state.gain;
  out.offset = step.alignment.state.offset;
  out.residual_sigma = step.alignment.sigma_intensity;
  out.reduced_chi2 = step.alignment.reduced_chi2;
  out.n_points = step.alignment.seen;
  out.n_inliers = step.alignment.inliers;
  return out;
}

/// What is known of an object without a frame.
inline ObjectResult identity_of(const Track& t) {
  ObjectResult out;
  out.id = t.identity.id;
  out.discovered = t.identity.discovered;
  out.class_id = t.identity.class_id;
  out.score = t.identity.score;
  out.always_dynamic = t.belief.always_dynamic;
  out.p_moving = t.belief.p_moving;
  out.last_decided = t.belief.last_decided;
  if (!t.candidacy.is_candidate) out.state = t.belief.state;  // otherwise it is not confirmed any more
  return out;
}

/// Of an object that was dropped between two frames.
inline ObjectResult last_result_of(const Track& t) {
  ObjectResult out = identity_of(t);
  out.reason = Reason::Lost;
  return out;
}

inline ObjectResult result_of(const Track& t) {
  ObjectResult out = identity_of(t);
  out.segmented = t.segmented;
  out.instance_id = t.segmented ? t.identity.instance_id : 0;
  if (t.is_shown()) {
    out.area = t.outline.mask.area;
    out.box = t.outline.mask.box();
  }
  copy(t.belief.velocity_now, out.fused_velocity);
  copy(t.belief.velocity_covariance, out.fused_covariance);
  const ObjectFit& fit = t.motion.step.fit;
  out.reason = fit.reason;
  if (t.candidacy.is_candidate && !t.lost) out.reason = Reason::Hidden;
  out.phi = fit.phi;
  out.n_points = fit.n_points;
  out.n_inliers = fit.n_inliers;
  if (out.reason != Reason::None) return out;
  out.T_o = fit.T_o.row_major();
  copy(fit.sigma, out.covariance);
  copy(fit.motion.velocity, out.velocity);
  copy(fit.motion.covariance, out.velocity_covariance);
  copy(fit.motion.angular_velocity, out.angular_velocity);
  copy(fit.motion.angular_covariance, out.angular_covariance);
  out.point_speed = fit.motion.point_speed();
  out.point_speed_sigma = fit.motion.point_speed_sigma();
  out.speed = fit.motion.velocity.norm();
  out.disparity_px = fit.motion.disparity_px;
  out.disparity_noise_px = fit.motion.disparity_noise_px;
  out.entropy = fit.motion.entropy;
  out.range = fit.motion.range;
  out.interval = fit.motion.span_seconds;
  return out;
}

}  // namespace writing

/// Drops the lost objects. The next result names those that the last one has shown and not called lost.
template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::drop_lost() {
  for (const Track* t : tracks_.all()) {
    if (!t->lost || !t->is_reported()) continue;
    const ObjectResult* last = result_.find(t->identity.id);
    if (last && last->reason != Reason::Lost) dropped_.push_back(writing::last_result_of(*t));
  }
  tracks_.drop_lost();
}

template <typename Camera, typename Classifier, typename Noise, typename Aligner>
void Dot<Camera, Classifier, Noise, Aligner>::write_result(const Frame& frame, const CameraStep& camera_step) {
  result_.frame_id = frame.id;
  result_.timestamp = frame.timestamp;
  result_.interval = camera_step.seconds;
  result_.too_little_depth = false;  // until `prepare`, as the two after it
  result_.diagnosis = {};
  result_.stage_ms[static_cast<std::size_t>(Stage::Points)] = 0;
  if constexpr (std::is_same_v<Noise, DepthNoise>)
    result_.disparity_bias_px = current_->bias.is_zero() ? 0 : current_->bias.rms() * depth_noise.focal_baseline;
  constexpr double kMiddleRow = 0;  // whose motion a host takes for the frame's
  const CameraStep step = camera_step.at_row(kMiddleRow);
  result_.camera = writing::result_of(step, step.covariance + camera_tracker_.scale_covariance(step));
  revised_.clear();
  for (const RevisedInterval& r : camera_tracker_.revised()) {
    CameraRevision& out = revised_.emplace_back();
    out.frame_id = r.frame_id;
    out.timestamp = r.timestamp;
    out.T_cur_prev = r.step.T_cur_prev.row_major();
    writing::copy(r.step.covariance + camera_tracker_.scale_covariance(r.step), out.covariance);
  }
  result_.revised = {revised_.data(), revised_.size()};
  objects_.assign(dropped_.begin(), dropped_.end());
  dropped_.clear();
  for (const Track* t : tracks_.all())
    if (t->is_reported()) objects_.push_back(writing::result_of(*t));
  std::sort(objects_.begin(), objects_.end(), [](const ObjectResult& l, const ObjectResult& r) { return l.id < r.id; });
  result_.labels = labeller_.labels().image().view();
  result_.ids = labeller_.ids().view();
  result_.objects = {objects_.data(), objects_.size()};
}

DOT_END_NAMESPACE
