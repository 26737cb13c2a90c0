// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/align/settings.hpp"
#include "dot/camera/settings.hpp"
#include "dot/camera_motion/settings.hpp"
#include "dot/mask/settings.hpp"
#include "dot/motion/settings.hpp"
#include "dot/object_motion/settings.hpp"
#include "dot/points/settings.hpp"

namespace dot {

/// All settings of the pipeline, by module. The defaults suit both street scenes and rooms. Times are in seconds, so
/// they hold at any frame rate.
struct Options {
  SelectionSettings selection;                           ///< which pixels become points
  AlignSettings align;                                   ///< the alignment of points to images
  CameraSettings camera;                                 ///< when a camera motion is accepted
  DepthNoiseSettings depth_noise;                        ///< the form and size of the depth's noise
  ObjectSettings object;                                 ///< when an object's motion is accepted
  MotionPriorSettings motion_prior;                      ///< how objects move
  ClassifierKind classifier = ClassifierKind::Velocity;  ///< for dot::Tracker; `Dot<...>` takes it as a type
  VelocitySettings velocity;                             ///< for ClassifierKind::Velocity
  EntropySettings entropy;                               ///< for ClassifierKind::Entropy and EntropyLiteral
  MaskSettings mask;                                     ///< association, propagation and labels
  double max_gap = 1.0;  ///< seconds; after a longer gap between frames the references are dropped
  int threads = 1;  ///< most threads that `track` uses, of OpenCV's pool or the host's; results do not depend on it
  bool discover_unknown = false;  ///< search the background for moving objects without a mask
};

/// Values that a setting may have, both ends included, except of velocity.decide, which must be inside.
struct OptionRange {
  double low;   ///< smallest value
  double high;  ///< largest value
};

/// Calls `visit(name, value, range)` for each numeric setting, name as in "velocity.v0", value a reference to double,
/// int or bool. Outside its range a setting has no meaning, such as a share above 1, a variance of zero or an
/// impossible speed.
template <typename AnyOptions, typename Visitor>
void for_each_option_range(AnyOptions& o, Visitor&& visit) {
/// @cond
#define DOT_OPTION(path, low, high) visit(#path, o.path, OptionRange{low, high})
  /// @endcond
  DOT_OPTION(selection.background_points, 1, 1e6);
  DOT_OPTION(selection.object_points, 1, 1e5);
  DOT_OPTION(selection.min_object_pixels, 0, 1e9);
  DOT_OPTION(selection.min_depth_share, 0, 1);
  DOT_OPTION(selection.min_gradient, 0, 255);
  DOT_OPTION(selection.object_gradient, 0, 255);
  DOT_OPTION(selection.max_depth, 0.01, 1e5);
  DOT_OPTION(selection.window_radius, 1, 50);
  DOT_OPTION(align.max_levels, 1, 16);
  DOT_OPTION(align.max_iterations, 1, 1000);
  DOT_OPTION(align.huber, 0.01, 1e3);
  DOT_OPTION(align.tukey, 0.1, 1e3);
  DOT_OPTION(align.gradient_noise, 0, 10);
  DOT_OPTION(align.min_intensity_sigma, 1e-3, 255);
  DOT_OPTION(align.outlier, 0.1, 1e3);
  DOT_OPTION(camera.min_points, 10, 1e6);
  DOT_OPTION(camera.min_phi, 0, 1);
  DOT_OPTION(camera.min_phi_unexpected, 0, 1);
  DOT_OPTION(camera.min_margin, 0, 1);
  DOT_OPTION(camera.min_inliers, 0, 1);
  DOT_OPTION(camera.search_speed, 0, 1e3);
  DOT_OPTION(camera.max_acceleration, 0, 1e4);
  DOT_OPTION(camera.search_turn, 0, 20);
  DOT_OPTION(camera.multistart_margin, 0, 1);
  DOT_OPTION(camera.multistart_shift, 0, 100);
  DOT_OPTION(camera.covariance_scale, 0.01, 1e3);
  DOT_OPTION(depth_noise.stereo_sigma_px, 1e-3, 100);
  DOT_OPTION(depth_noise.stereo_shared_px, 0, 100);
  DOT_OPTION(depth_noise.stereo_bias_px, 0, 100);
  DOT_OPTION(depth_noise.rgbd_sigma, 1e-6, 1);
  DOT_OPTION(depth_noise.rgbd_shared, 0, 1);
  DOT_OPTION(depth_noise.lidar_sigma, 1e-4, 10);
  DOT_OPTION(depth_noise.lidar_relative, 0, 1);
  DOT_OPTION(depth_noise.lidar_shared, 0, 10);
  DOT_OPTION(depth_noise.unknown_relative, 1e-5, 1);
  DOT_OPTION(object.min_points, 1, 1e5);
  DOT_OPTION(object.min_visible, 0, 1);
  DOT_OPTION(object.min_phi, 0, 1);
  DOT_OPTION(object.min_phi_expected, 0, 1);
  DOT_OPTION(object.min_inliers, 0, 1e5);
  DOT_OPTION(object.min_inlier_share, 0, 1);
  DOT_OPTION(object.min_depth_agreement, 0, 1);
  DOT_OPTION(object.max_speed, 0.01, 1e4);
  DOT_OPTION(object.max_acceleration, 0.01, 1e4);
  DOT_OPTION(object.search_speed, 0, 1e3);
  DOT_OPTION(object.reference_seconds, 0, 10);
  DOT_OPTION(object.max_fitted, 1, 1e4);
  DOT_OPTION(motion_prior.rotation, 1e-3, 100);
  DOT_OPTION(motion_prior.velocity, 0.01, 1e4);
  DOT_OPTION(motion_prior.gain, 1e-4, 10);
  DOT_OPTION(motion_prior.offset, 1e-3, 255);
  DOT_OPTION(motion_prior.ground_vehicle, 0, 1);
  DOT_OPTION(motion_prior.up_x, -1e3, 1e3);
  DOT_OPTION(motion_prior.up_y, -1e3, 1e3);
  DOT_OPTION(motion_prior.up_z, -1e3, 1e3);
  DOT_OPTION(velocity.v0, 1e-3, 100);
  DOT_OPTION(velocity.v0_per_square_metre, 0, 100);
  DOT_OPTION(velocity.photometric_scale, 0.01, 1e3);
  DOT_OPTION(velocity.rotation_scale, 0.01, 1e3);
  DOT_OPTION(velocity.floor, 1e-4, 10);
  DOT_OPTION(velocity.floor_per_square_metre, 1e-6, 100);
  DOT_OPTION(velocity.decide, 0.5, 1);
  DOT_OPTION(velocity.keep, 0.5, 1);
  DOT_OPTION(velocity.switch_rate, 0, 100);
  DOT_OPTION(velocity.prior_speed, 0.01, 1e3);
  DOT_OPTION(velocity.prior_speed_per_metre, 1e-3, 1e3);
  DOT_OPTION(velocity.prior_turn, 1e-3, 100);
  DOT_OPTION(velocity.most_turning, 0, 1);
  DOT_OPTION(velocity.acceleration, 0, 1e3);
  DOT_OPTION(velocity.acceleration_per_metre, 0, 1e3);
  DOT_OPTION(velocity.tail_share, 0, 1);
  DOT_OPTION(velocity.tail_variance, 1, 1e4);
  DOT_OPTION(velocity.outliers, 0, 1);
  DOT_OPTION(velocity.max_evidence_rate, 0, 1e4);
  DOT_OPTION(velocity.max_evidence, 0, 100);
  DOT_OPTION(velocity.max_log_odds, 0, 30);
  DOT_OPTION(entropy.max_entropy, -1e3, 1e3);
  DOT_OPTION(entropy.min_entropy, -1e3, 1e3);
  DOT_OPTION(entropy.min_disparity, 0, 1e3);
  DOT_OPTION(entropy.noise_factor, 0, 1e3);
  DOT_OPTION(mask.min_iou, 0, 1);
  DOT_OPTION(mask.min_containment, 0, 1);
  DOT_OPTION(mask.keep_seconds, 0, 60);
  DOT_OPTION(mask.late_seconds, 0, 60);
  DOT_OPTION(mask.late_frames, 1, 1000);
  DOT_OPTION(mask.depth_tolerance, 0.01, 1);
  DOT_OPTION(mask.min_pixels, 0, 1e9);
  DOT_OPTION(mask.max_instances, 1, 65535);
  DOT_OPTION(max_gap, 1e-3, 3600);
  DOT_OPTION(threads, 1, 256);
  DOT_OPTION(discover_unknown, 0, 1);
#undef DOT_OPTION
}

/// The same as `visit(name, value)`, without the range. For configuration files.
template <typename AnyOptions, typename Visitor>
void for_each_option(AnyOptions& o, Visitor&& visit) {
  for_each_option_range(o, [&visit](const char* name, auto& value, OptionRange) { visit(name, value); });
}

}  // namespace dot
