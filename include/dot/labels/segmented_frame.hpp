// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "dot/camera/concept.hpp"
#include "dot/image/image.hpp"
#include "dot/image/view.hpp"
#include "dot/lie/se3.hpp"

DOT_BEGIN_NAMESPACE

/// The last segmented frame. Later pixels are compared with it to find the new ones. Borrowed.
struct SegmentedFrame {
  const Image<float>& inverse_depth;  ///< 1/m, <= 0 or not finite = no measurement
  const Image<std::uint32_t>& ids;    ///< of the objects shown there, 0 = background
};

/// The content of the segmented frame at the place where a point would have been.
enum class InSegmentedFrame : std::uint8_t {
  Unseen,  ///< outside the image, or behind something: the point may be new
  Object,  ///< the object's surface was there
  Empty,   ///< a farther surface is visible there: the point was elsewhere
  Other    ///< a surface that is not the object's was there
};

/// Whether the next measurement in the row, to the left or to the right, is nearer than q, 1/m. At the image border or
/// beside an edge, where stereo has no measurement, such a nearer surface may hide what is behind it.
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

/// Moves a point from the present frame to the segmented frame and compares it with the depth and the ids there.
/// @param T_then_cur from the present camera, or object, to the segmented frame. @param ray (x, y, 1) of the point.
/// @param q its inverse depth, 1/m. @param measured_now whether q was measured. A point without a measurement in either
/// frame is no evidence. @param tolerance of inverse depths, relative. @param id of the object.
template <typename Camera>
InSegmentedFrame classify_in_segmented_frame(const SegmentedFrame& frame, const SE3f& T_then_cur, const Camera& camera,
                                             const Vector3<float>& ray, float q, float tolerance, std::uint32_t id,
                                             bool measured_now) {
  const Vector3<float> X = T_then_cur.R * ray + T_then_cur.t * q;
  if (!(X.z() > 1e-3f)) return InSegmentedFrame::Unseen;
  const Vector2<float> p = camera.project(X);
  if (!(p.x() > -0.5f && p.y() > -0.5f && p.x() < static_cast<float>(camera.width()) - 0.5f &&
        p.y() < static_cast<float>(camera.height()) - 0.5f))
    return InSegmentedFrame::Unseen;
  const int x = static_cast<int>(p.x() + 0.5f), y = static_cast<int>(p.y() + 0.5f);
  const std::uint32_t label = frame.ids(x, y);
  const InSegmentedFrame surface = label == id ? InSegmentedFrame::Object : InSegmentedFrame::Other;
  const float expected = q / X.z(), measured = frame.inverse_depth(x, y);
  if (!(measured > 0) || !std::isfinite(measured)) {
    const bool free =
        label == 0 && !(measured_now && beside_nearer(frame.inverse_depth, x, y, expected * (1 + tolerance)));
    return free || label == id ? surface : InSegmentedFrame::Unseen;
  }
  if (measured > expected * (1 + tolerance)) return InSegmentedFrame::Unseen;
  return measured < expected * (1 - tolerance) ? InSegmentedFrame::Empty : surface;
}

DOT_END_NAMESPACE
