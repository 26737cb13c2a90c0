// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "dot/camera/concept.hpp"
#include "dot/image/image.hpp"
#include "dot/image/view.hpp"
#include "dot/lie/se3.hpp"
#include "dot/mask/mask.hpp"

DOT_BEGIN_NAMESPACE

/// What the last segmentation saw: against it later pixels are told to be new.
struct SegmentedFrame {
  bool known = false;          ///< there was one, and the camera's motion since is known
  Image<float> inverse_depth;  ///< 1/m, <= 0 or not finite = no measurement
  Image<std::uint32_t> ids;    ///< of the objects shown there, 0 = background
};

/// Buffers of `grow`.
struct GrowWorkspace {
  struct Pixel {
    int x, y;
    float q;  ///< 1/m, its own or, without measurement, its neighbour's
  };
  std::vector<Pixel> front;
};

namespace growing {

/// What the segmented frame says of a point, given where it would have been.
enum class Then : std::uint8_t {
  Unseen,  ///< out of the image, or behind something: it may be new
  Object,  ///< there was the object's surface
  Empty,   ///< one looked through there: the point was elsewhere
  Other    ///< there was a surface that is not the object's
};

/// Whether the measurement that is closest in the row, to the left or to the right, is nearer than q, 1/m: where stereo
/// found nothing, at the image's border or beside an edge, what stands there may hide what is behind.
inline bool beside_nearer(const Image<float>& inverse_depth, int x, int y, float q) {
  const int reach = inverse_depth.width() / 40;
  const float* row = inverse_depth.row(y);
  for (const int step : {-1, 1})
    for (int u = x + step; std::abs(u - x) <= reach && u >= 0 && u < inverse_depth.width(); u += step)
      if (row[u] > 0 && std::isfinite(row[u])) {
        if (row[u] > q) return true;
        break;
      }
  return false;
}

/// @param tolerance of inverse depths, relative; @param measured_now whether q was: two guesses are no evidence
template <typename Camera>
Then then(const SegmentedFrame& frame, const SE3f& T_then_cur, const Camera& camera, const Vector3<float>& ray, float q,
          float tolerance, std::uint32_t id, bool measured_now) {
  const Vector3<float> X = T_then_cur.R * ray + T_then_cur.t * q;
  if (!(X.z() > 1e-3f)) return Then::Unseen;
  const Vector2<float> p = camera.project(X);
  if (!(p.x() > -0.5f && p.y() > -0.5f && p.x() < static_cast<float>(camera.width()) - 0.5f &&
        p.y() < static_cast<float>(camera.height()) - 0.5f))
    return Then::Unseen;
  const int x = static_cast<int>(p.x() + 0.5f), y = static_cast<int>(p.y() + 0.5f);
  const std::uint32_t label = frame.ids(x, y);
  const Then surface = label == id ? Then::Object : Then::Other;
  const float expected = q / X.z(), measured = frame.inverse_depth(x, y);
  if (!(measured > 0) || !std::isfinite(measured)) {
    const bool free =
        label == 0 && !(measured_now && beside_nearer(frame.inverse_depth, x, y, expected * (1 + tolerance)));
    return free || label == id ? surface : Then::Unseen;
  }
  if (measured > expected * (1 + tolerance)) return Then::Unseen;
  return measured < expected * (1 - tolerance) ? Then::Empty : surface;
}

}  // namespace growing

/// Grows an object's pixels in `ids` into parts of it that the last segmentation could not see: what has come in over
/// the image border since, or out from behind something.
///
/// A free pixel (id 0) beside the object, or beside something narrow that stands before it, joins it when
/// - its inverse depth continues the neighbour's,
/// - it was unseen in the segmented frame if it moved with the object, out of the image or hidden. Where it would have
///   been visible the segmentation has already said that it is not the object's;
/// - it was not there if it stands: one looked through, or at the object. So the ground, walls and whatever else the
///   segmented frame shows stays out, and standing objects, for which both motions are the same, do not grow.
/// @param T_seg_object motion of the object's points from the current camera to the segmented frame's
/// @param T_seg_static the camera's alone
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
  for (int y = box[1]; y < box[1] + box[3]; ++y)
    for (int x = box[0]; x < box[0] + box[2]; ++x) {
      if (ids(x, y) != id) continue;
      ++area;
      const float q = measured(x, y);
      if (!(q > 0)) continue;
      bool border = false;
      for (const auto& [dx, dy] : sides) border |= ids.contains(x + dx, y + dy) && ids(x + dx, y + dy) == 0;
      if (border) front.push_back({x, y, q});
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
      const auto moved = growing::then(segmented, T_object, camera, ray, q, limit, id, own > 0);
      if (moved == growing::Then::Empty || moved == growing::Then::Other) continue;
      const auto stood = growing::then(segmented, T_static, camera, ray, q, limit, id, own > 0);
      if (stood != growing::Then::Empty && stood != growing::Then::Object) continue;
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
