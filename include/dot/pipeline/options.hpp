// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/align/settings.hpp"
#include "dot/camera/settings.hpp"
#include "dot/mask/settings.hpp"
#include "dot/motion/settings.hpp"
#include "dot/points/settings.hpp"

namespace dot {

/// All settings of the pipeline, by room. Defaults suit street scenes and rooms alike; times are in seconds, so the
/// frame rate does not matter.
struct Options {
  SelectionSettings selection;
  AlignSettings align;
  CameraSettings camera;
  DepthNoiseSettings depth_noise;
  ObjectSettings object;
  MotionPriorSettings motion_prior;
  ClassifierKind classifier = ClassifierKind::Velocity;  ///< of dot::Tracker; `Dot<...>` takes it as a type
  VelocitySettings velocity;
  EntropySettings entropy;
  MaskSettings mask;
  double max_gap = 1.0;  ///< seconds between frames from which the references are dropped
  int threads = 1;       ///< of OpenCV's pool or the host's that `track` uses at most; the results do not depend on it
  bool discover_unknown = false;  ///< look in the background for moving things that no mask shows
};

/// Calls `visit(name, value)` for each numeric setting, name as in "velocity.v0", value a reference to double, int or
/// bool. Serves configuration files and range checks.
template <typename AnyOptions, typename Visitor>
void for_each_option(AnyOptions& o, Visitor&& visit) {
#define DOT_OPTION(path) visit(#path, o.path)
  DOT_OPTION(selection.background_points);
  DOT_OPTION(selection.object_points);
  DOT_OPTION(selection.min_object_pixels);
  DOT_OPTION(selection.min_depth_share);
  DOT_OPTION(selection.min_gradient);
  DOT_OPTION(selection.object_gradient);
  DOT_OPTION(selection.max_depth);
  DOT_OPTION(selection.window_radius);
  DOT_OPTION(align.max_levels);
  DOT_OPTION(align.max_iterations);
  DOT_OPTION(align.huber);
  DOT_OPTION(align.tukey);
  DOT_OPTION(align.gradient_noise);
  DOT_OPTION(align.min_intensity_sigma);
  DOT_OPTION(align.outlier);
  DOT_OPTION(camera.min_points);
  DOT_OPTION(camera.min_phi);
  DOT_OPTION(camera.min_phi_unexpected);
  DOT_OPTION(camera.min_margin);
  DOT_OPTION(camera.min_inliers);
  DOT_OPTION(camera.search_speed);
  DOT_OPTION(camera.search_turn);
  DOT_OPTION(camera.restart_margin);
  DOT_OPTION(camera.restart_shift);
  DOT_OPTION(camera.covariance_scale);
  DOT_OPTION(depth_noise.stereo_sigma_px);
  DOT_OPTION(depth_noise.stereo_common_px);
  DOT_OPTION(depth_noise.stereo_bias_px);
  DOT_OPTION(depth_noise.rgbd_sigma);
  DOT_OPTION(depth_noise.rgbd_common);
  DOT_OPTION(depth_noise.lidar_sigma);
  DOT_OPTION(depth_noise.lidar_relative);
  DOT_OPTION(depth_noise.lidar_common);
  DOT_OPTION(depth_noise.unknown_relative);
  DOT_OPTION(object.min_points);
  DOT_OPTION(object.min_visible);
  DOT_OPTION(object.min_phi);
  DOT_OPTION(object.min_phi_expected);
  DOT_OPTION(object.min_inliers);
  DOT_OPTION(object.min_inlier_share);
  DOT_OPTION(object.min_depth_agreement);
  DOT_OPTION(object.max_speed);
  DOT_OPTION(object.max_acceleration);
  DOT_OPTION(object.search_speed);
  DOT_OPTION(object.reference_seconds);
  DOT_OPTION(motion_prior.rotation);
  DOT_OPTION(motion_prior.velocity);
  DOT_OPTION(motion_prior.gain);
  DOT_OPTION(motion_prior.offset);
  DOT_OPTION(motion_prior.ground_vehicle);
  DOT_OPTION(motion_prior.up_x);
  DOT_OPTION(motion_prior.up_y);
  DOT_OPTION(motion_prior.up_z);
  DOT_OPTION(velocity.v0);
  DOT_OPTION(velocity.v0_per_metre);
  DOT_OPTION(velocity.photometric_scale);
  DOT_OPTION(velocity.floor);
  DOT_OPTION(velocity.decide);
  DOT_OPTION(velocity.keep);
  DOT_OPTION(velocity.switch_rate);
  DOT_OPTION(velocity.prior_speed);
  DOT_OPTION(velocity.acceleration);
  DOT_OPTION(velocity.tail_share);
  DOT_OPTION(velocity.tail_variance);
  DOT_OPTION(velocity.outliers);
  DOT_OPTION(velocity.max_evidence_rate);
  DOT_OPTION(velocity.max_evidence);
  DOT_OPTION(velocity.max_log_odds);
  DOT_OPTION(entropy.max_entropy);
  DOT_OPTION(entropy.min_entropy);
  DOT_OPTION(entropy.min_disparity);
  DOT_OPTION(entropy.noise_factor);
  DOT_OPTION(mask.min_iou);
  DOT_OPTION(mask.min_containment);
  DOT_OPTION(mask.keep_seconds);
  DOT_OPTION(mask.late_seconds);
  DOT_OPTION(mask.depth_tolerance);
  DOT_OPTION(mask.min_pixels);
  DOT_OPTION(max_gap);
  DOT_OPTION(threads);
  DOT_OPTION(discover_unknown);
#undef DOT_OPTION
}

}  // namespace dot
