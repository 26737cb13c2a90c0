// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "dot/camera_motion/camera_step.hpp"
#include "dot/frame/frame_data.hpp"
#include "dot/labels/grow.hpp"
#include "dot/labels/reveal.hpp"
#include "dot/mask/painted_image.hpp"
#include "dot/tracks/track.hpp"

DOT_BEGIN_NAMESPACE

/// Makes the label and id images of each frame. Adds the parts of objects that the last segmentation could not see. For
/// this it keeps the last segmented frame.
template <typename Camera, typename Noise>
class Labeller {
 public:
  using List = std::vector<Track*>;  ///< tracks, borrowed

  /// Labels the current frame by the masks of these tracks. Reduces the tracks' masks to their visible parts.
  /// @param far_to_near the last one is on top. @param camera_step led to the frame. @param segmented there are masks
  /// of a network for it.
  void label(const List& far_to_near, const FramePtr& cur, const CameraStep& camera_step, bool segmented,
             const Camera& camera, const Noise& noise, const MaskSettings& settings);

  /// The State of each pixel, valid until the next `label`.
  const PaintedImage<std::uint8_t>& labels() const { return labels_; }
  /// The track id of each pixel, 0 = background, valid until the next `label`.
  const Image<std::uint32_t>& ids() const { return ids_.image(); }

  /// Makes a past frame the last segmented one, with the masks of these tracks.
  /// @param camera_since motion since then. @param known whether that motion was measured.
  void set_segmented(const List& far_to_near, const FramePtr& frame, const CameraSince& camera_since, bool known);

  /// Forgets the last segmentation.
  void forget() noexcept {
    segmented_.reset();
    newly_segmented_.reset();
    known_ = false;
    labels_.forget(), ids_.forget(), segmented_ids_.forget();
  }

 private:
  static void paint(const List& far_to_near, int width, int height, PaintedImage<std::uint32_t>& ids);
  void advance(const List& tracks, const FramePtr& cur, const CameraStep& camera_step, bool segmented);
  void show_new_parts(const Track& t, const FrameData& cur, const Camera& camera, const Noise& noise,
                      const MaskSettings& settings, std::array<int, 4>& box);

  PaintedImage<std::uint8_t> labels_;
  PaintedImage<std::uint32_t> ids_;

  FramePtr segmented_;  ///< the last frame that was segmented before the newest one
  PaintedImage<std::uint32_t> segmented_ids_;
  SE3d T_now_segmented_;      ///< camera motion since
  bool known_ = false;        ///< there is such a frame, and that motion is known
  FramePtr newly_segmented_;  ///< the newest frame, if it was segmented; becomes `segmented_` at the next frame

  GrowWorkspace grow_workspace_;
  WarpWorkspace warp_workspace_;
  WarpedMask moved_, expected_;  ///< a hidden part in the current frame: on its level, and on level 0
};

DOT_END_NAMESPACE

#include "dot/labels/impl/labeller.hpp"
