// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/mask/hidden_part.hpp"
#include "dot/mask/settings.hpp"
#include "dot/mask/template.hpp"
#include "dot/mask/warp.hpp"
#include "dot/motion/place.hpp"

DOT_BEGIN_NAMESPACE

/// Buffers of a thread that carries outlines.
struct OutlineWorkspace {
  WarpWorkspace warp;
  WarpedMask moved;  ///< not trimmed
  HiddenPart hidden_part;
  TemplateWorkspace shape;
};

/// An object's outline over time: the last mask that was seen of it, and where that is. `now` is the newest frame that
/// the object was followed to.
struct TrackedOutline {
  MaskTemplate shape;        ///< the last mask that was seen
  MaskTemplate hidden_part;  ///< what something nearer hid of it then
  SE3d T_now_shape;          ///< composed motion of the object's points since then
  bool is_newest = false;    ///< it is of the last frame that was segmented, and the camera's motion since is known

  WarpedMask warped;   ///< the shape in the frame at hand
  SE3d T_frame_shape;  ///< the motion that it was warped by

  Mask mask;                  ///< what is shown in the frame at hand
  bool visible = false;       ///< that is anything
  bool contradicted = false;  ///< the last segmentation did not show it where it should be seen
  double last_seen = 0;       ///< timestamp

  /// Sets `warped` to the shape after a motion.
  template <typename Camera>
  void warp_by(const SE3d& T, const Image<float>& inverse_depth, const Camera& camera, const MaskSettings& settings,
               OutlineWorkspace& workspace) {
    const ImageView<const float> trim_by = shape.measured ? inverse_depth.view() : ImageView<const float>{};
    warp(shape, T, camera, trim_by, settings.depth_tolerance, workspace.warp, warped);
    T_frame_shape = T;
  }

  /// Makes an observed mask the shape that is carried on.
  /// @param T_frame_old motion of the object's points from the old shape to the mask's frame. @param inverse_depth of
  /// that frame. @param far 1/m, to be assumed where no depth was ever measured.
  template <typename Camera>
  void take(const Mask& observed, const SE3d& T_frame_old, const Image<float>& inverse_depth, double far,
            const Camera& camera, const MaskSettings& settings, OutlineWorkspace& workspace) {
    remember_hidden_part(observed, T_frame_old, inverse_depth, camera, settings, workspace);
    const double q = shape.median > 0 ? shape.median : far;
    if (!make_template(observed, inverse_depth.view(), settings.depth_tolerance, workspace.shape, shape))
      make_flat_template(observed, q, shape);
    contradicted = false;
  }

 private:
  /// Remembers what of the outline is behind something now that a mask shows the rest: to know it when it comes out.
  template <typename Camera>
  void remember_hidden_part(const Mask& observed, const SE3d& T_frame_old, const Image<float>& inverse_depth,
                            const Camera& camera, const MaskSettings& settings, OutlineWorkspace& workspace) {
    workspace.hidden_part.clear();
    for (const MaskTemplate* part : {&shape, &hidden_part}) {
      if (!part->measured) continue;
      if (part == &shape && warped.occluded_area < settings.min_pixels) continue;
      warp(*part, T_frame_old, camera, {}, 0, workspace.warp, workspace.moved);
      workspace.hidden_part.add(workspace.moved, inverse_depth.view(), settings.depth_tolerance, observed);
    }
    workspace.hidden_part.make_template(hidden_part);
  }
};

DOT_END_NAMESPACE
