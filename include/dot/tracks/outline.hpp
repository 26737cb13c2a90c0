// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/mask/hidden_part.hpp"
#include "dot/mask/settings.hpp"
#include "dot/mask/template.hpp"
#include "dot/mask/warp.hpp"
#include "dot/motion/place.hpp"

DOT_BEGIN_NAMESPACE

/// Buffers of a thread that moves outlines.
struct OutlineWorkspace {
  WarpWorkspace warp;       ///< of `warp`
  WarpedMask moved;         ///< not trimmed
  HiddenPart hidden_part;   ///< of the mask that is taken
  TemplateWorkspace shape;  ///< of `make_template`
};

/// An object's outline over time: its last observed mask, and where that is now. `now` is the newest frame that the
/// object was followed to.
struct TrackedOutline {
  MaskTemplate shape;        ///< the last observed mask
  MaskTemplate hidden_part;  ///< the part that something nearer hid then
  SE3d T_now_shape;          ///< composed motion of the object's points since then
  bool is_newest = false;    ///< the shape is of the last segmented frame, and the camera's motion since is known

  WarpedMask warped;   ///< the shape in the current frame
  SE3d T_frame_shape;  ///< the motion of that warp

  Mask mask;                  ///< the part shown in the current frame
  bool visible = false;       ///< whether `mask` shows anything
  bool contradicted = false;  ///< the last segmentation did not show it although it should be visible
  double last_seen = 0;       ///< timestamp

  /// Sets `warped` to the shape after a motion.
  template <typename Camera>
  void warp_by(const SE3d& T, const Image<float>& inverse_depth, const Camera& camera, const MaskSettings& settings,
               OutlineWorkspace& workspace) {
    const ImageView<const float> trim_by = shape.measured ? inverse_depth.view() : ImageView<const float>{};
    warp(shape, T, camera, trim_by, settings.depth_tolerance, workspace.warp, warped);
    T_frame_shape = T;
  }

  /// Makes an observed mask the new shape.
  /// @param T_frame_old motion of the object's points from the old shape to the mask's frame. @param inverse_depth of
  /// that frame. @param far 1/m, assumed where no depth was ever measured.
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
  /// Remembers the part of the outline that is hidden while a mask shows the rest. It is recognised when it comes out.
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
