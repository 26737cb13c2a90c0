// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "dot/camera/concept.hpp"
#include "dot/labels/segmented_frame.hpp"
#include "dot/mask/warp.hpp"

DOT_BEGIN_NAMESPACE

/// Adds to an object in `ids` the parts that have come out again: earlier segmentations showed them, but the last one
/// could not see them.
///
/// An expected pixel that is free (id 0) joins the object under three conditions. Its measured depth is the expected
/// one. Assuming that it moved with the object, it was unseen in the segmented frame. Assuming that it is static, that
/// frame shows no other surface there. Unlike in `grow`, it may have been hidden under both assumptions, because it is
/// known to be the object's.
/// @param expected     the hidden part in this frame, not trimmed
/// @param T_seg_object motion of the object's points from the current camera to the segmented frame's
/// @param T_seg_static the camera's motion alone
/// @param tolerance    of an inverse depth q, relative: tolerance(q)
/// @param box          x, y, width, height of the object's pixels; grows with them
/// @return pixels gained.
template <typename Camera, typename Tolerance>
int reveal(const WarpedMask& expected, const SegmentedFrame& segmented, const SE3d& T_seg_object,
           const SE3d& T_seg_static, const Camera& camera, ImageView<const float> inverse_depth, std::uint32_t id,
           Tolerance&& tolerance, Image<std::uint32_t>& ids, std::array<int, 4>& box) {
  static_assert(is_camera_v<Camera>, DOT_CAMERA_MESSAGE);
  const SE3f T_object = T_seg_object.template cast<float>(), T_static = T_seg_static.template cast<float>();
  const Mask& mask = expected.mask;
  int gained = 0;
  int left = box[0], top = box[1], right = box[0] + box[2], bottom = box[1] + box[3];
  for (int v = 0; v < mask.height(); ++v)
    for (int u = 0; u < mask.width(); ++u) {
      const int x = mask.x + u, y = mask.y + v;
      if (!mask.pixels(u, v) || ids(x, y) != 0) continue;
      const float q = inverse_depth(x, y), q_expected = expected.inverse_depth(u, v);
      if (!(q > 0) || !std::isfinite(q)) continue;
      const float limit = static_cast<float>(tolerance(q));
      if (std::abs(q - q_expected) > limit * q_expected) continue;
      const Vector3<float> ray = camera.unproject(Vector2<float>(static_cast<float>(x), static_cast<float>(y)));
      const auto moved = classify_in_segmented_frame(segmented, T_object, camera, ray, q, limit, id, true);
      if (moved != InSegmentedFrame::Unseen) continue;
      const auto stood = classify_in_segmented_frame(segmented, T_static, camera, ray, q, limit, id, true);
      if (stood == InSegmentedFrame::Other) continue;
      ids(x, y) = id;
      ++gained;
      left = std::min(left, x), right = std::max(right, x + 1);
      top = std::min(top, y), bottom = std::max(bottom, y + 1);
    }
  box = {left, top, right - left, bottom - top};
  return gained;
}

DOT_END_NAMESPACE
