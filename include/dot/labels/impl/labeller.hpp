// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

/// @file
/// Definitions of labels/labeller.hpp, which includes this file.

DOT_BEGIN_NAMESPACE

template <typename Camera, typename Noise>
void Labeller<Camera, Noise>::label(const List& far_to_near, const FramePtr& cur, const CameraStep& camera_step,
                                    bool segmented, const Camera& camera, const Noise& noise,
                                    const MaskSettings& settings) {
  advance(far_to_near, cur, camera_step, segmented);
  labels_.clear(camera.width(), camera.height());
  for (Track* t : far_to_near) {
    TrackedOutline& outline = t->outline;
    if (!outline.visible) outline.mask.clear();
    if (!t->observed && t->belief.state != State::Static && outline.warped.is_mostly_occluded())
      drop_unmeasured(cur->inverse_depth().view(), outline.mask);
  }
  paint(far_to_near, camera.width(), camera.height(), ids_);
  // Near to far, so that the nearer objects grow first.
  for (auto i = far_to_near.rbegin(); i != far_to_near.rend(); ++i) {
    Track& t = **i;
    Mask& mask = t.outline.mask;
    std::array<int, 4> box = mask.box();
    if (!t.observed && t.outline.is_newest && known_) show_new_parts(t, *cur, camera, noise, settings, box);
    ids_.add(box);
    crop_ids<std::uint32_t>(ids().view(), t.identity.id, box, mask);
    t.outline.visible = !mask.empty();
    if (!t.outline.visible && t.motion.step.fit.ok()) t.motion.step.fit.reason = Reason::Hidden;
    labels_.paint(mask, static_cast<std::uint8_t>(t.belief.state));
  }
  segmented_ids_.reserve(camera.width(), camera.height(), ids_.boxes().capacity());
  if (segmented) T_now_segmented_ = {};
}

/// A segmented frame becomes the frame to compare with at the next frame. Its ids are kept only if an object was not
/// observed in the next one. So no second image is written as long as all objects have masks.
template <typename Camera, typename Noise>
void Labeller<Camera, Noise>::advance(const List& tracks, const FramePtr& cur, const CameraStep& camera_step,
                                      bool segmented) {
  T_now_segmented_ = camera_step.T_cur_prev * T_now_segmented_;
  known_ = known_ && camera_step.known();
  const bool all_observed = std::all_of(tracks.begin(), tracks.end(), [](const Track* t) { return t->observed; });
  if (newly_segmented_) {
    if (!segmented || !all_observed) std::swap(segmented_ids_, ids_);
    segmented_ = std::move(newly_segmented_);
    known_ = camera_step.known();
  }
  newly_segmented_ = segmented ? cur : nullptr;
}

template <typename Camera, typename Noise>
void Labeller<Camera, Noise>::set_segmented(const List& far_to_near, const FramePtr& frame,
                                            const CameraSince& camera_since, bool known) {
  const Image<float>& size = frame->inverse_depth();
  paint(far_to_near, size.width(), size.height(), segmented_ids_);
  segmented_ = frame;
  T_now_segmented_ = camera_since.T_now_ref;
  known_ = known;
}

/// Paints the masks of these tracks into the id image.
template <typename Camera, typename Noise>
void Labeller<Camera, Noise>::paint(const List& far_to_near, int width, int height, PaintedImage<std::uint32_t>& ids) {
  ids.clear(width, height);
  for (const Track* t : far_to_near) ids.paint(t->outline.mask, t->identity.id);
}

/// Adds to an object's pixels the parts that the last segmentation could not see: parts that earlier ones showed, and,
/// if its motion is known, parts that none has shown.
/// @param box x, y, width, height of its pixels; grows with them
template <typename Camera, typename Noise>
void Labeller<Camera, Noise>::show_new_parts(const Track& t, const FrameData& cur, const Camera& camera,
                                             const Noise& noise, const MaskSettings& settings,
                                             std::array<int, 4>& box) {
  const SE3d T_seg_object = t.outline.T_now_shape.inverse(), T_seg_static = T_now_segmented_.inverse();
  const ImageView<const float> inverse_depth = cur.inverse_depth().view();
  const SegmentedFrame segmented{segmented_->inverse_depth(), segmented_ids_.image()};
  // Tolerance, relative, of the inverse depths of one surface that are measured in two frames: three sigmas.
  const auto tolerance = [&](double q) {
    const auto squared = [](double pixel, double shared) { return pixel * pixel + shared * shared; };
    const double variance = std::max(squared(noise.pixel_sigma(q), noise.shared_sigma(q)),
                                     squared(noise.prior_pixel_sigma(q), noise.prior_shared_sigma(q)));
    return std::min(3 * std::sqrt(2 * variance) / q, settings.depth_tolerance);
  };
  if (const MaskTemplate& hidden = t.outline.hidden_part; !hidden.mask.empty()) {
    warp_on_level(hidden, t.outline.T_now_shape, camera, nullptr, 0, warp_workspace_, moved_);
    enlarge_surface(moved_, hidden.level, expected_);
    reveal(expected_, segmented, T_seg_object, T_seg_static, camera, inverse_depth, t.identity.id, tolerance,
           ids_.image(), box);
  }
  if (t.motion.step.fit.ok() || t.belief.dead_reckoning_is_reliable(t.motion.size, cur.timestamp))
    grow(segmented, T_seg_object, T_seg_static, camera, inverse_depth, t.identity.id, tolerance, grow_workspace_,
         ids_.image(), box);
}

DOT_END_NAMESPACE
