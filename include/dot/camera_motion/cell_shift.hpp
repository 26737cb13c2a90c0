// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "dot/camera/concept.hpp"
#include "dot/camera_motion/standing_edges.hpp"
#include "dot/kernel/lanes.hpp"
#include "dot/lie/se3.hpp"

DOT_BEGIN_NAMESPACE

/// Tells from where in the last frame that counted a cell of StandingEdges has come, if it shows something that stands.
template <typename Camera>
class CellShift {
 public:
  /// The images and the camera are borrowed. @param T_cur_last the camera's motion since that frame.
  /// @param inverse_depth of the edges' level, 1/m.
  CellShift(const StandingEdges& edges, const SE3d& T_cur_last, const Image<float>& inverse_depth, const Camera& camera)
      : edges_(edges),
        inverse_depth_(inverse_depth),
        camera_(camera),
        R_(T_cur_last.inverse().R.cast<float>()),
        t_(T_cur_last.inverse().t.cast<float>()) {}

  /// Inverse depth of the nearest pixel in the middle of a cell, 1/m; 0: it has none.
  float nearest(int column, int row) const {
    const int u = column * kCell + kCell / 2, v = row * kCell + kCell / 2;
    const Image<float>& q = inverse_depth_;
    return std::max(std::max(q(u, v), q(u + 1, v)), std::max(q(u, v + 1), q(u + 1, v + 1)));
  }

  /// Inverse depth of the farthest pixel in a cell and beside it, 1/m; 0: none has depth.
  float farthest(int column, int row) const {
    using V = PortableLanes;
    constexpr int kPixels = kCell + 2;
    constexpr float kNone = 1e9f;
    V::F least = V::set(kNone);
    for (int v = row * kCell; v < row * kCell + kPixels; ++v)
      for (const int first : {0, kPixels - kCell})
        for (int u = first; u < first + kCell; u += V::W) {
          const V::F q = V::load(&inverse_depth_(column * kCell + u, v));
          // What has no depth is beyond all others.
          least = V::min(least, V::add(q, V::keep(V::not_less(V::set(0), q), V::set(kNone))));
        }
    float lanes[V::W];
    V::store(lanes, least);
    const float farthest = *std::min_element(lanes, lanes + V::W);
    return farthest < kNone ? farthest : 0;
  }

  /// @param q inverse depth of the cell, 1/m. @param[out] shift to the place in the last frame, pixels of the level.
  /// @return whether it is known.
  bool operator()(int column, int row, float q, Vector2<float>& shift) const {
    constexpr float kNearest = 1e-3f;  // of the depth, to be in front of the camera
    constexpr float kSize = kCell, kMiddle = 1 + 0.5f * kSize;
    const auto pixel = static_cast<float>(1 << edges_.level());
    const Vector2<float> place(pixel * (kSize * static_cast<float>(column) + kMiddle) - 0.5f,
                               pixel * (kSize * static_cast<float>(row) + kMiddle) - 0.5f);
    const Vector3<float> X = R_ * camera_.template unproject<float>(place) + q * t_;
    if (!(q > 0 && X.z() >= kNearest)) return false;
    shift = (camera_.template project<float>(X) - place) / pixel;
    return true;
  }

 private:
  static constexpr int kCell = StandingEdges::kCell;

  const StandingEdges& edges_;
  const Image<float>& inverse_depth_;
  const Camera& camera_;
  Matrix3<float> R_;  ///< from the current frame to the last
  Vector3<float> t_;  ///< metres
};

DOT_END_NAMESPACE
