// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <utility>

#include "dot/frame/frame_data.hpp"
#include "dot/mask/coarse_outline.hpp"
#include "dot/mask/fine_outline.hpp"
#include "dot/mask/hidden_part.hpp"
#include "dot/mask/settings.hpp"
#include "dot/mask/template.hpp"
#include "dot/mask/warp.hpp"
#include "dot/motion/place.hpp"

DOT_BEGIN_NAMESPACE

/// Buffers of a thread that moves outlines.
struct OutlineWorkspace {
  WarpWorkspace warp;       ///< of `warp`
  FineOutline fine;         ///< of large objects
  WarpedMask moved;         ///< on the template's level
  HiddenPart hidden_part;   ///< of the mask that is taken
  TemplateWorkspace shape;  ///< of `make_template`
  MaskTemplate found;       ///< of `find_depth`
};

/// An object's outline over time: its last observed mask, and where that is now. `now` is the newest frame that the
/// object was followed to.
///
/// Of a large object a coarse outline is made first. It predicts where the next mask is to be expected. The exact one
/// is made when the next frame has no mask of the object. Its surface needs the frame of the last mask.
struct TrackedOutline {
  MaskTemplate shape;        ///< the last observed mask, at full resolution; without depth if it is large
  MaskTemplate coarse;       ///< the same on a coarse level, if it is large
  MaskTemplate surface;      ///< the same for the depth of the exact outline, if it is large; see `shape_frame`
  MaskTemplate hidden_part;  ///< the part that something nearer hid then, on any level
  FramePtr shape_frame;      ///< the frame of the mask, as long as there is no `surface` of it yet
  SE3d T_now_shape;          ///< composed motion of the object's points since then
  bool is_newest = false;    ///< the shape is of the last segmented frame, and the camera's motion since is known

  WarpedMask warped;       ///< the shape in the current frame
  bool is_coarse = false;  ///< `warped` is a prediction on a coarse level, with inverse depths on request
  SE3d T_frame_shape;      ///< the motion of that warp

  Mask mask;                  ///< the part shown in the current frame
  bool visible = false;       ///< whether `mask` shows anything
  bool contradicted = false;  ///< the last segmentation did not show it although it should be visible
  double last_seen = 0;       ///< timestamp

  /// Sets `warped` to the shape after a motion.
  template <typename Camera>
  void warp_by(const SE3d& T, const Image<float>& inverse_depth, const Camera& camera, const MaskSettings& settings,
               OutlineWorkspace& workspace) {
    complete(settings, workspace);
    const ImageView<const float> trim_by = shape.measured ? inverse_depth.view() : ImageView<const float>{};
    const MaskTemplate& source = coarse.level > 0 ? surface : shape;
    if (source.level > 0)
      workspace.fine.warp(shape.mask, source, T, camera, trim_by, settings.depth_tolerance, workspace.warp, warped);
    else
      warp(source, T, camera, trim_by, settings.depth_tolerance, workspace.warp, warped);
    is_coarse = false;
    T_frame_shape = T;
  }

  /// The same on a coarse level, if the shape is large. @param with_depth whether the inverse depths are wanted.
  template <typename Camera>
  void predict_by(const SE3d& T, const DepthPyramid& depth, const Camera& camera, const MaskSettings& settings,
                  OutlineWorkspace& workspace, bool with_depth = false) {
    if (coarse.level == 0) return warp_by(T, depth.levels[0], camera, settings, workspace);
    warp_on_level(coarse, T, camera, &depth, settings.depth_tolerance, workspace.warp, workspace.moved);
    if (with_depth)
      enlarge_surface(workspace.moved, coarse.level, warped);
    else
      enlarge(workspace.moved, coarse.level, warped);
    is_coarse = true;
    T_frame_shape = T;
  }

  /// Makes an observed mask the new shape.
  /// @param T_frame_old motion of the object's points from the old shape to the mask's frame. @param frame the mask's.
  /// @param far 1/m, assumed where no depth was ever measured.
  template <typename Camera>
  void set_shape(const Mask& observed, const SE3d& T_frame_old, const FramePtr& frame, double far, const Camera& camera,
                 const MaskSettings& settings, OutlineWorkspace& workspace) {
    remember_hidden_part(observed, T_frame_old, frame->depth, camera, settings, workspace);
    const double q = shape.median > 0 ? shape.median : far;
    contradicted = false;
    if (make_coarse_template(observed, frame->depth, settings.depth_tolerance, workspace.shape, coarse)) {
      shape.mask = observed;
      shape.median = coarse.median;
      shape.measured = true;
      shape.inverse_depth.resize(0, 0);
      shape_frame = frame;
      return;
    }
    shape_frame.reset();
    if (!make_template(observed, frame->inverse_depth().view(), settings.depth_tolerance, workspace.shape, shape))
      make_flat_template(observed, q, shape);
  }

  /// Gives a shape that was taken in a frame without depth that of the current frame, at its place there. Otherwise an
  /// object whose masks all come with such frames would have none.
  void find_depth(const Image<float>& inverse_depth, const MaskSettings& settings, OutlineWorkspace& workspace) {
    constexpr int kLeastShare = 4;  // one pixel in so many must be measured: the few of a ragged border are not its own
    if (shape_frame || shape.measured || coarse.level > 0 || is_coarse || warped.mask.empty()) return;
    int measured = 0;
    for (int y = 0; y < warped.mask.height(); ++y)
      for (int x = 0; x < warped.mask.width(); ++x)
        measured += warped.mask.pixels(x, y) != 0 && inverse_depth(warped.mask.x + x, warped.mask.y + y) > 0;
    if (measured * kLeastShare < warped.mask.area) return;
    if (!make_template(warped.mask, inverse_depth.view(), settings.depth_tolerance, workspace.shape, workspace.found))
      return;
    std::swap(shape, workspace.found);
    T_now_shape = T_frame_shape = {};
    is_newest = false;    // the shape is not of the segmented frame any more,
    hidden_part.clear();  // and this part is relative to the old one
  }

  /// Makes the surface of a large object, if that was put off.
  void complete(const MaskSettings& settings, OutlineWorkspace& workspace) {
    // One pixel more or less at the outline matters less the larger the object is.
    constexpr int kFromCoarse = 2, kLevel = 1;
    if (!shape_frame) return;
    const double tolerance = settings.depth_tolerance;
    const DepthPyramid& depth = shape_frame->depth;
    const bool found = coarse.level < kFromCoarse
                           ? make_template(shape.mask, depth.levels[0].view(), tolerance, workspace.shape, surface)
                           : make_surface_template(kLevel, shape.mask, depth, tolerance, workspace.shape, surface);
    if (!found) surface = coarse;
    shape_frame.reset();
  }

  /// For an outline that is not needed any more: its memory is kept for another one, the frame must not be.
  void release_frame() noexcept { shape_frame.reset(); }

 private:
  /// Remembers the part of the outline that is hidden while a mask shows the rest. It is recognised when it comes out.
  template <typename Camera>
  void remember_hidden_part(const Mask& observed, const SE3d& T_frame_old, const DepthPyramid& depth,
                            const Camera& camera, const MaskSettings& settings, OutlineWorkspace& workspace) {
    workspace.hidden_part.clear();
    const MaskTemplate& old = coarse.level > 0 ? coarse : shape;
    for (const MaskTemplate* part : {&old, static_cast<const MaskTemplate*>(&hidden_part)}) {
      if (!part->measured) continue;
      if (part == &old && warped.occluded_area < settings.min_pixels) continue;
      warp_on_level(*part, T_frame_old, camera, nullptr, 0, workspace.warp, workspace.moved);
      workspace.hidden_part.add(workspace.moved, depth.levels[static_cast<std::size_t>(part->level)].view(),
                                settings.depth_tolerance, observed, part->level);
    }
    workspace.hidden_part.make_template(hidden_part);
  }
};

DOT_END_NAMESPACE
