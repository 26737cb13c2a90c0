// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "dot/camera/concept.hpp"
#include "dot/labels/segmented_frame.hpp"

DOT_BEGIN_NAMESPACE

/// Buffers of `grow`.
struct GrowWorkspace {
  /// A pixel of the object from which it grows.
  struct Pixel {
    int x;    ///< column
    int y;    ///< row
    float q;  ///< 1/m, its own; its neighbour's if not measured
  };
  std::vector<Pixel> front;       ///< pixels whose neighbours were not looked at yet
  std::vector<std::uint8_t> rim;  ///< of a row: 1 = a pixel of the object beside a free one
};

/// Sets `rim` for the pixels x0 to x1, end excluded, of a row. @return how many of them have the id.
inline int find_rim(const Image<std::uint32_t>& ids, std::uint32_t id, int y, int x0, int x1,
                    std::vector<std::uint8_t>& rim) {
  if (x0 >= x1) return 0;
  rim.resize(static_cast<std::size_t>(x1 - x0));
  const std::uint32_t* row = ids.row(y);
  // Outside of the image nothing is free. The pixel itself takes that place, because those that count are not free.
  const std::uint32_t *above = ids.row(std::max(y - 1, 0)), *below = ids.row(std::min(y + 1, ids.height() - 1));
  std::uint8_t* __restrict out = rim.data();
  int count = 0;
  const auto mark = [=, &count](int x, int before, int after) {
    const bool is_own = row[x] == id;
    const bool is_beside = (row[before] == 0) | (row[after] == 0) | (above[x] == 0) | (below[x] == 0);
    out[x - x0] = is_own & is_beside;
    count += is_own;
  };
  const int begin = std::max(x0, 1), end = std::min(x1, ids.width() - 1);
  if (x0 < begin) mark(0, 0, std::min(1, ids.width() - 1));
  for (int x = begin; x < end; ++x) mark(x, x - 1, x + 1);
  if (end < x1 && end >= begin) mark(end, end - 1, end);
  return count;
}

/// Grows an object's pixels in `ids` into parts of it that the last segmentation could not see. Such parts have since
/// entered over the image border or come out from behind something.
///
/// A free pixel (id 0) beside the object, or beside something narrow in front of it, joins the object if
/// - its inverse depth continues the neighbour's,
/// - assuming that it moved with the object, it was outside the image or hidden in the segmented frame. If it was
///   visible there, the segmentation has already decided that it is not part of the object;
/// - assuming that it is static, it was not there: the segmented frame shows something farther, or the object. So the
///   ground, walls and all else in that frame stay out. Static objects do not grow: both motions are the same.
/// @param T_seg_object motion of the object's points from the current camera to the segmented frame's
/// @param T_seg_static the camera's motion alone
/// @param tolerance    of an inverse depth q, relative: tolerance(q)
/// @param box          x, y, width, height of the object's pixels; grows with them
/// @return pixels gained.
template <typename Camera, typename Tolerance>
int grow(const SegmentedFrame& segmented, const SE3d& T_seg_object, const SE3d& T_seg_static, const Camera& camera,
         ImageView<const float> inverse_depth, std::uint32_t id, Tolerance&& tolerance, GrowWorkspace& workspace,
         Image<std::uint32_t>& ids, std::array<int, 4>& box) {
  static_assert(is_camera_v<Camera>, DOT_CAMERA_MESSAGE);
  const SE3f T_object = T_seg_object.template cast<float>(), T_static = T_seg_static.template cast<float>();
  constexpr std::array<std::array<int, 2>, 4> sides{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};
  const auto measured = [&](int x, int y) {
    const float q = inverse_depth(x, y);
    return std::isfinite(q) && q > 0 ? q : 0.0f;
  };

  auto& front = workspace.front;
  front.clear();
  int area = 0;
  for (int y = box[1]; y < box[1] + box[3]; ++y) {
    area += find_rim(ids, id, y, box[0], box[0] + box[2], workspace.rim);
    for (int i = 0; i < box[2]; ++i) {
      if (!workspace.rim[static_cast<std::size_t>(i)]) continue;
      const float q = measured(box[0] + i, y);
      if (q > 0) front.push_back({box[0] + i, y, q});
    }
  }
  const int narrow = static_cast<int>(0.25 * std::sqrt(static_cast<double>(area)));
  int gained = 0;
  int left = box[0], top = box[1], right = box[0] + box[2], bottom = box[1] + box[3];
  while (!front.empty()) {
    const GrowWorkspace::Pixel from = front.back();
    front.pop_back();
    const float nearer = from.q * (1 + static_cast<float>(tolerance(from.q)));
    for (const auto& [dx, dy] : sides) {
      int x = from.x + dx, y = from.y + dy;
      for (int i = 0; i < narrow && ids.contains(x, y) && measured(x, y) > nearer; ++i) x += dx, y += dy;
      if (!ids.contains(x, y) || ids(x, y) != 0) continue;
      const float own = measured(x, y), q = own > 0 ? own : from.q;
      const float limit = static_cast<float>(tolerance(q));
      if (std::abs(q - from.q) > limit * from.q) continue;
      const Vector3<float> ray = camera.unproject(Vector2<float>(static_cast<float>(x), static_cast<float>(y)));
      const auto moved = classify_in_segmented_frame(segmented, T_object, camera, ray, q, limit, id, own > 0);
      if (moved == InSegmentedFrame::Empty || moved == InSegmentedFrame::Other) continue;
      const auto stood = classify_in_segmented_frame(segmented, T_static, camera, ray, q, limit, id, own > 0);
      if (stood != InSegmentedFrame::Empty && stood != InSegmentedFrame::Object) continue;
      ids(x, y) = id;
      ++gained;
      left = std::min(left, x), right = std::max(right, x + 1);
      top = std::min(top, y), bottom = std::max(bottom, y + 1);
      front.push_back({x, y, q});
    }
  }
  box = {left, top, right - left, bottom - top};
  return gained;
}

DOT_END_NAMESPACE
