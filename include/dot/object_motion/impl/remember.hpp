// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

/// @file
/// Definitions of object_motion/object_tracker.hpp, which includes this file.

DOT_BEGIN_NAMESPACE

template <typename Camera, typename Noise, typename Aligner>
Reason ObjectTracker<Camera, Noise, Aligner>::make_reference(const FrameData& frame, const Mask& mask,
                                                             const Vector3<double>& centre,
                                                             const ExpectedDepth& expected, Workspace& workspace,
                                                             ObjectReference& r) const {
  if (mask.area < selection.min_object_pixels) return Reason::TooFewPixels;
  const Selector<Camera, Noise> select{
      camera,  noise,     frame.pyramid,  frame.inverse_depth().view(), selection, workspace.selection,
      kernels, &overlaid, &frame.measured};
  const ObjectPoints found =
      select_object(select, {mask.x, mask.y, mask.width(), mask.height()}, mask.pixels.view(), mask.area, r.points);
  // Beyond its range or in the dark a stereo matcher finds little. The few depths that it gives there may be wrong. A
  // lidar looks from another place than the camera, so a few of its points under a mask can belong to a neighbour.
  const bool few = found.pixels_with_depth < selection.min_depth_share * mask.area;
  if (few && (depth_source != DepthSource::Lidar || expected.excludes(centre.z()))) return Reason::TooLittleDepth;
  if (r.points.size() < estimator.settings.min_points)
    return found.shape_known ? Reason::TooLittleTexture : Reason::TooLittleDepth;
  r.points.bias = frame.bias;
  r.set_centroid();
  r.anchor = centre;
  r.area = found.pixels_with_depth;
  r.slope_variance = found.slope_variance;
  return Reason::None;
}

template <typename Camera, typename Noise, typename Aligner>
ExpectedDepth ObjectTracker<Camera, Noise, Aligner>::expected_depth(const ObjectMotion& motion, const SE3d& T_then_now,
                                                                    double timestamp) const {
  if (depth_source != DepthSource::Lidar || motion.references.empty()) return {};
  constexpr double kSigmas = 3;
  const ObjectReference& newest = motion.references.front();
  const double z = (T_then_now * newest.T_obj_now_ref * newest.anchor).z();
  if (newest.anchor.z() <= 0 || z <= 0) return {};
  const double sigma = z * z * std::hypot(noise.prior_pixel_sigma(1 / z), noise.prior_shared_sigma(1 / z));
  const double moved = estimator.settings.max_speed * std::abs(timestamp - newest.timestamp);
  return {z, moved + motion.size + kSigmas * sigma};
}

template <typename Camera, typename Noise, typename Aligner>
void ObjectTracker<Camera, Noise, Aligner>::remember(const FrameData& cur, const Mask* mask, Workspace& workspace,
                                                     ObjectMotion& motion) const {
  thin_newest(motion.references, estimator.settings.reference_seconds);
  if (!mask) {
    motion.no_reference = Reason::Hidden;
    return;
  }
  const Vector3<double> centre = centre_of(*mask, cur.inverse_depth(), camera, workspace.selection.values);
  const ExpectedDepth expected = expected_depth(motion, {}, cur.timestamp);
  ObjectReference& r = motion.references.push_front();
  r.restart(cur.timestamp);
  const Reason reason = make_reference(cur, *mask, centre, expected, workspace, r);
  const bool is_of_another = reason == Reason::TooLittleDepth && expected.excludes(centre.z());
  if (centre.z() > 0 && !is_of_another) {
    // The centre of the visible part of a half hidden object is not its middle. Its middle is then predicted by motion.
    constexpr double kWhole = 0.7;  // of the object's size
    const double size = std::sqrt(1.0 * mask->area) * centre.z() / camera.intrinsics().fx;
    if (size > kWhole * motion.size || !motion.position_now.is_ahead()) motion.position_now = {centre, true};
    motion.size = std::max(motion.size, size);
  }
  if (reason == Reason::None) return;
  motion.references.pop_front();
  motion.no_reference = reason;
}

DOT_END_NAMESPACE
