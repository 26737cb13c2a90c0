// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "dot/camera/intrinsics.hpp"
#include "dot/labels/segmented_frame.hpp"
#include "dot/lie/se3.hpp"
#include "dot/mask/warp.hpp"

/// Boxes before a wall, seen by one camera: what a segmented frame and a later one look like.
namespace box_scene {

inline constexpr int kWidth = 80, kHeight = 60;
inline constexpr std::uint32_t kId = 5, kOther = 7;
inline constexpr float kNear = 0.5f, kObject = 0.2f, kFar = 0.05f;  // 1/m
inline const dot::Intrinsics kIntrinsics{100, 100, 40, 30, kWidth, kHeight, 0};

/// Of the depth.
struct Noise {
  double sigma = 1e-3;
  double pixel_sigma(double) const { return sigma; }
};

/// Columns [x0, x1) and rows [y0, y1) of one inverse depth; may reach out of the image.
struct Box {
  int x0, x1, y0, y1;
  float q;
  std::uint32_t id;
};

/// A frame, and the objects that it shows.
struct Rendered {
  dot::Image<float> inverse_depth;
  dot::Image<std::uint32_t> ids;
  operator dot::SegmentedFrame() const { return {inverse_depth, ids}; }
};

/// Boxes before a wall, later ones over earlier ones.
inline Rendered render(const std::vector<Box>& boxes) {
  Rendered out;
  out.inverse_depth.resize(kWidth, kHeight);
  out.inverse_depth.fill(kFar);
  out.ids.resize(kWidth, kHeight);
  out.ids.fill(0);
  for (const Box& box : boxes)
    for (int y = box.y0; y < box.y1; ++y)
      for (int x = box.x0; x < box.x1; ++x) {
        if (!out.ids.contains(x, y)) continue;
        out.inverse_depth(x, y) = box.q;
        out.ids(x, y) = box.id;
      }
  return out;
}

/// An outline of the object's depth that fills x, y, width, height.
inline dot::WarpedMask outline(const std::array<int, 4>& box) {
  dot::WarpedMask out;
  dot::fill_mask(
      box, [](int, int) { return true; }, out.mask);
  out.inverse_depth.resize(box[2], box[3]);
  out.inverse_depth.fill(kObject);
  return out;
}

/// Motion to the segmented frame of what, at the object's depth, has come `pixels` to the right since.
inline dot::SE3d back(int pixels) {
  dot::SE3d T;
  T.t.x() = -pixels / (100.0 * kObject);
  return T;
}

}  // namespace box_scene
