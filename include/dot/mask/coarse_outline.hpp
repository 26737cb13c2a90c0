// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "dot/image/depth_pyramid.hpp"
#include "dot/mask/mask.hpp"
#include "dot/mask/template.hpp"
#include "dot/mask/warp.hpp"

/// @file
/// Outlines of large objects on a coarse level of the image pyramid. There they cost as little as those of small
/// objects. They are exact to a few percent of the object's size, which is enough to tell which mask continues which
/// object, and what hides a part of it.

DOT_BEGIN_NAMESPACE

/// The coarsest level on which an outline of `area` pixels has about 30x30 of them. @param levels there are.
inline int coarse_level(int area, int levels) {
  constexpr int kEnough = 1000, kCoarsest = 3;
  int level = 0;
  while (level < std::min(kCoarsest, levels - 1) && (area >> (2 * level)) >= 2 * kEnough) ++level;
  return level;
}

/// Makes a template on a level above 0. @param block block(y)(x) -> bool: whether it has this pixel of the level.
/// @param depth 1/m, of the mask's frame. @param first_radius see make_template.
/// @return false if less than half of the template's pixels are measured; `out` is then empty.
template <typename Block>
bool make_template_on_level(int level, const Mask& mask, Block&& block, const DepthPyramid& depth, double tolerance,
                            int first_radius, TemplateWorkspace& workspace, MaskTemplate& out) {
  const Image<float>& inverse_depth = depth.levels[static_cast<std::size_t>(level)];
  const int left = mask.x >> level, top = mask.y >> level;
  const int right = std::min((mask.x + mask.width() - 1) >> level, inverse_depth.width() - 1);
  const int bottom = std::min((mask.y + mask.height() - 1) >> level, inverse_depth.height() - 1);
  fill_mask_by_rows({left, top, std::max(0, right - left + 1), std::max(0, bottom - top + 1)}, block, out.mask);
  // Pixels at the border may show what is beside an object without depth.
  int measured = 0;
  for (int y = 0; y < out.mask.height(); ++y)
    for (int x = 0; x < out.mask.width(); ++x)
      measured += out.mask.pixels(x, y) != 0 && inverse_depth(out.mask.x + x, out.mask.y + y) > 0;
  if (2 * measured < out.mask.area) return out.clear(), false;
  if (!make_template(out.mask, inverse_depth.view(), tolerance, workspace, out, first_radius)) return false;
  out.level = level;
  return true;
}

/// Makes a template on the level that suits the mask's area. It has the pixels whose middle is in the mask.
/// @return false if that is level 0, or as make_template_on_level; `out` is then empty.
inline bool make_coarse_template(const Mask& mask, const DepthPyramid& depth, double tolerance,
                                 TemplateWorkspace& workspace, MaskTemplate& out) {
  const int level = coarse_level(mask.area, static_cast<int>(depth.levels.size()));
  if (level == 0) return out.clear(), false;
  const int middle = 1 << (level - 1);
  const auto is_middle_inside = [&mask, level, middle](int y) {
    return [=, &mask](int x) { return mask.at((x << level) + middle, (y << level) + middle); };
  };
  return make_template_on_level(level, mask, is_middle_inside, depth, tolerance, 2, workspace, out);
}

/// Makes a template on a level, for FineOutline. It has all pixels that the mask touches.
/// @return false as make_template_on_level; `out` is then empty.
inline bool make_surface_template(int level, const Mask& mask, const DepthPyramid& depth, double tolerance,
                                  TemplateWorkspace& workspace, MaskTemplate& out) {
  const auto touches = [&mask, level](int y) {
    const int begin = std::max((y << level) - mask.y, 0), end = std::min(((y + 1) << level) - mask.y, mask.height());
    return [=, &mask](int x) {
      const int left = std::max((x << level) - mask.x, 0);
      const int right = std::min(((x + 1) << level) - mask.x, mask.width());
      for (int v = begin; v < end; ++v)
        for (int u = left; u < right; ++u)
          if (mask.pixels(u, v)) return true;
      return false;
    };
  };
  return make_template_on_level(level, mask, touches, depth, tolerance, 1, workspace, out);
}

/// `warp` for a template of any level. The result is in pixels of that level, too. @param depth 1/m, of the current
/// frame; null: nothing is trimmed.
template <typename Camera>
void warp_on_level(const MaskTemplate& source, const SE3d& T_cur_template, const Camera& camera,
                   const DepthPyramid* depth, double tolerance, WarpWorkspace& workspace, WarpedMask& out) {
  const ImageView<const float> trim_by =
      depth ? depth->levels[static_cast<std::size_t>(source.level)].view() : ImageView<const float>{};
  warp(source, T_cur_template, camera.at_level(source.level), trim_by, tolerance, workspace, out);
}

/// Enlarges a mask of a coarse level to level 0, each pixel to a square. The inverse depths are left out.
inline void enlarge(const WarpedMask& coarse, int level, WarpedMask& out) {
  const int side = 1 << level, pixels = side * side;
  const Mask& from = coarse.mask;
  Mask& to = out.mask;
  to.x = from.x * side;
  to.y = from.y * side;
  to.area = from.area * pixels;
  to.pixels.resize(from.width() * side, from.height() * side);
  out.inverse_depth.resize(0, 0);
  for (int y = 0; y < from.height(); ++y) {
    const std::uint8_t* set = from.pixels.row(y);
    std::uint8_t* first = to.pixels.row(y * side);
    for (int x = 0; x < from.width(); ++x) std::memset(first + x * side, set[x], static_cast<std::size_t>(side));
    for (int i = 1; i < side; ++i)
      std::memcpy(to.pixels.row(y * side + i), first, static_cast<std::size_t>(to.width()));
  }
  out.inside_area = coarse.inside_area * pixels;
  out.confirmed_area = coarse.confirmed_area * pixels;
  out.occluded_area = coarse.occluded_area * pixels;
}

/// The same, with the inverse depths.
inline void enlarge_surface(const WarpedMask& coarse, int level, WarpedMask& out) {
  enlarge(coarse, level, out);
  out.inverse_depth.resize(out.mask.width(), out.mask.height());
  for (int y = 0; y < out.mask.height(); ++y) {
    const float* from = coarse.inverse_depth.row(y >> level);
    float* to = out.inverse_depth.row(y);
    for (int x = 0; x < out.mask.width(); ++x) to[x] = from[x >> level];
  }
}

DOT_END_NAMESPACE
