// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "dot/image/morphology.hpp"
#include "dot/mask/centre.hpp"
#include "dot/points/select.hpp"
#include "dot/statistics/median.hpp"

DOT_BEGIN_NAMESPACE

/// What became of the selection of an object's points.
struct ObjectPoints {
  int pixels_with_depth = 0;  ///< of the mask, on the object's surface
  float median_q = 0;         ///< 1/m
  bool shape_known = false;   ///< by these pixels; else there are no points
};

namespace selecting {

constexpr double kLevelRelief = 0.15;  ///< share of its distance: half an object's size, where a level may stand for it

/// Which pixels of an object's box may be points, into work.mask: of its eroded mask, where its surface (work.surface)
/// was measured, nothing nearer beside it that is not the object's.
/// @param level 1/m, of what was not measured; 0: that may not.
inline void admit(ImageView<const float> frame, const Box& box, ImageView<const std::uint8_t> mask, int area,
                  float level, float slack, SelectionWorkspace& work) {
  constexpr int kErosion = 2, kReach = 4;
  const int width = box.width, height = box.height;
  // What is not the object, with a rim.
  work.outside.resize(width + 2 * kErosion, height + 2 * kErosion);
  work.outside.fill(255);
  work.nearer.resize(width + 2 * kReach, height + 2 * kReach);
  work.nearer.fill(0);
  for (int y = -kReach; y < height + kReach; ++y) {
    if (box.y + y < 0 || box.y + y >= frame.height) continue;
    const int begin = std::max(-kReach, -box.x), end = std::min(width + kReach, frame.width - box.x);
    const float* depth = frame.row(box.y + y) + box.x;
    float* out = work.nearer.row(y + kReach) + kReach;
    std::copy(depth + begin, depth + end, out + begin);
    if (y < 0 || y >= height) continue;
    const std::uint8_t* inside = mask.row(y);
    std::uint8_t* outside = work.outside.row(y + kErosion) + kErosion;
    for (int x = 0; x < width; ++x) outside[x] = inside[x] ? 0 : 255;
    for (int x = 0; x < width; ++x) out[x] = inside[x] ? 0 : out[x];
  }
  if (area > 2500)
    dilate<2>(std::as_const(work.outside).view(), work.outside_rows, work.outside.view());
  else
    dilate<1>(std::as_const(work.outside).view(), work.outside_rows, work.outside.view());
  dilate<kReach>(std::as_const(work.nearer).view(), work.nearer_rows, work.nearer.view());
  work.mask.resize(width, height);
  for (int y = 0; y < height; ++y) {
    const float* depth = frame.row(box.y + y) + box.x;
    const float* surface = work.surface.row(y);
    const float* nearer = work.nearer.row(y + kReach) + kReach;
    const std::uint8_t* outside = work.outside.row(y + kErosion) + kErosion;
    std::uint8_t* may = work.mask.row(y);
    for (int x = 0; x < width; ++x) {
      const float q = surface[x] > 0 ? surface[x] : depth[x] > 0 ? 0 : level;
      const bool admitted = (outside[x] == 0) & (q > 0) & (nearer[x] <= 1.15f * q + slack);
      may[x] = admitted ? 255 : 0;
    }
  }
}

}  // namespace selecting

/// Points of one object: inside its eroded mask, within the object's own range of depth, away from what occludes it.
///
/// Masks are ragged and leak: of the mask's depths only those count that lie between its 20th and 80th percentile,
/// widened by what an object of this range and relief may extend. An object so far that its relief drowns in the depth
/// noise shares one plane, and so does one that has depth in less than a quarter of its pixels; the plane then serves
/// where nothing was measured too. For one so near that its relief is a good part of its distance no plane serves.
/// @param box of the mask in the frame; @param mask of the box's size, non-zero = object; @param area its pixels.
template <typename Camera, typename Noise>
ObjectPoints select_object(const Selector<Camera, Noise>& select, const Box& box, ImageView<const std::uint8_t> mask,
                           int area, PointSet& points) {
  points.clear();
  ObjectPoints out;
  SelectionWorkspace& work = select.workspace;
  const ImageView<const float> frame = select.inverse_depth;
  const ImageView<const float> depth{frame.row(box.y) + box.x, box.width, box.height, frame.stride};
  std::vector<float>& values = work.values;
  values.clear();
  const int step = sampling_step(area);
  for (int y = 0; y < box.height; y += step)
    for (int x = 0; x < box.width; x += step)
      if (mask(x, y) && depth(x, y) > 0) values.push_back(depth(x, y));
  if (values.size() < 10) return out;
  const auto [far, median_q, near] = spread(values.begin(), values.end());
  out.median_q = median_q;
  const float z = 1 / out.median_q;
  const float widen = std::min(3.5f, 0.25f * z + (1 / far - 1 / near));
  const float sigma = static_cast<float>(select.noise.pixel_sigma(out.median_q)), slack = 4 * sigma;
  const float q_min = 1 / (1 / far + widen) - slack;
  const float z_near = 1 / near - widen;
  const float q_max = (z_near > 0 ? 1 / z_near : 1e6f) + slack;
  for (const float q : values) out.pixels_with_depth += q >= q_min && q <= q_max;
  out.pixels_with_depth *= step * step;
  cut_surface(depth, mask, q_min, q_max, work.surface);

  const double focal = 0.5 * (select.camera.intrinsics().fx + select.camera.intrinsics().fy);
  const double size = std::sqrt(static_cast<double>(area)) / focal * static_cast<double>(z);                 // metres
  const double relief = 0.5 * size * static_cast<double>(out.median_q) * static_cast<double>(out.median_q);  // in q
  PlaneFit plane;
  bool flat = false;
  if (relief < 1.2 * static_cast<double>(sigma)) {
    const kernel::PlaneSeed middle{box.width / 2, box.height / 2, out.median_q, 5 * sigma};
    select.kernels.fit_planes(
        kernel_view(work.surface.view()),
        plane_window(std::max(box.width, box.height) / 2 + 1, std::max(1, out.pixels_with_depth / 3)), &middle, 1,
        &plane);
    flat = plane.inliers > 0;
  }
  if (4 * out.pixels_with_depth < area) {  // too few depths for planes of its own: all that is known is where it is
    if (relief > selecting::kLevelRelief * static_cast<double>(out.median_q)) return out;
    flat = true;
    plane.variance = static_cast<float>(relief * relief);
    plane.inliers = 1;
  }
  out.shape_known = true;
  if (flat) {
    // A tilt that the noise does not support would turn into spurious radial motion: keep the level.
    plane.du = plane.dv = 0;
    plane.q = out.median_q;
  }
  selecting::admit(frame, box, mask, area, flat ? out.median_q : 0, slack, work);

  SelectionRegion region;
  region.box = box;
  region.mask = work.mask.view();
  region.surface = work.surface.view();
  region.budget = select.settings.object_points;
  region.radius = std::clamp(static_cast<int>(std::sqrt(static_cast<double>(area)) / 8), 3, 6);
  region.shared = flat ? &plane : nullptr;
  // Strong gradients carry the information; weak ones only where there are few of them.
  for (const double share : {1.0, 0.5}) {
    points.clear();
    region.min_gradient = share * select.settings.object_gradient;
    select(region, points);
    if (points.size() >= 60) break;
  }
  select.sample_intensities(points);
  return out;
}

DOT_END_NAMESPACE
