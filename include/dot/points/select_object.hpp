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

/// The outcome of selecting an object's points.
struct ObjectPoints {
  int pixels_with_depth = 0;  ///< pixels of the mask on the object's surface
  float median_q = 0;         ///< 1/m
  double slope_variance = 0;  ///< 1/m^2, of the depth at its border, that no point shows (`shrink_tilt`)
  bool shape_known = false;   ///< whether these pixels give its shape; if not, there are no points
};

namespace selecting {

inline constexpr int kLeastMeasured = 6;        ///< of an object's pixels, where measurements are far apart
inline constexpr int kLargeArea = 2500;         ///< pixels
inline constexpr double kShareOfDensity = 0.5;  ///< of an object's depths, those of a window that must be on a plane
inline constexpr double kDeepest = 2;           ///< depth of an object along the line of sight, over its size across it
inline constexpr int kLeastDepths = 12;         ///< the same, at least: neighbouring depths are not independent
inline constexpr double kFlatRelief = 0.15;     ///< half size of an object over its distance, up to which it is flat
// Inverse depth of a surface over that of one beside it that it hides. Objects have relief, so less is enough outside.
inline constexpr float kNearerOutside = 1.15f, kNearerInside = 1.28f;

/// Sets work.mask to the pixels of an object's box that may be points. They are in its eroded mask, its surface
/// (work.surface) is measured there, and no nearer surface is beside them: neither outside the mask, nor the object
/// itself, where a mask that is too large contains background. Such an edge moves with what is nearer.
/// @param assumed_q 1/m, assumed for pixels that are not measured; 0: these may not be points.
inline void admit(ImageView<const float> frame, const Box& box, ImageView<const std::uint8_t> mask, int area,
                  float assumed_q, float slack, SelectionWorkspace& work) {
  constexpr int kErosion = 2, kReach = 4;
  const int width = box.width, height = box.height;
  const bool is_large = area > kLargeArea;
  // The pixels outside the object, with a rim.
  work.outside.resize(width + 2 * kErosion, height + 2 * kErosion);
  work.outside.fill(255);
  for (int y = 0; y < height; ++y) {
    const std::uint8_t* inside = mask.row(y);
    std::uint8_t* outside = work.outside.row(y + kErosion) + kErosion;
    for (int x = 0; x < width; ++x) outside[x] = inside[x] ? 0 : 255;
  }
  if (is_large)
    dilate<2>(std::as_const(work.outside).view(), work.outside_rows, work.outside.view());
  else
    dilate<1>(std::as_const(work.outside).view(), work.outside_rows, work.outside.view());

  // The nearest surface within kReach pixels, of a large object in blocks of 2x2 pixels.
  const int shift = is_large ? 1 : 0, rim = width + 2 * kReach;
  work.nearer.resize((rim + shift) >> shift, (height + 2 * kReach + shift) >> shift);
  work.nearer.fill(0);
  const int row_length = rim + 2;
  work.row.resize(static_cast<std::size_t>(row_length));
  float* const row = work.row.data();
  std::fill_n(row, row_length, 0.0f);
  for (int y = -kReach; y < height + kReach; ++y) {
    if (box.y + y < 0 || box.y + y >= frame.height) continue;
    const int begin = std::max(-kReach, -box.x), end = std::min(width + kReach, frame.width - box.x);
    const float* depth = frame.row(box.y + y) + box.x;
    std::copy(depth + begin, depth + end, row + kReach + begin);
    if (y >= 0 && y < height) {
      const std::uint8_t* inside = mask.row(y);
      for (int x = 0; x < width; ++x) row[kReach + x] *= inside[x] ? kNearerOutside / kNearerInside : 1;
    }
    float* out = work.nearer.row((y + kReach) >> shift);
    if (!is_large) {
      std::copy_n(row, rim, out);
      continue;
    }
    for (int x = 0; x < work.nearer.width(); ++x) {
      const float a = row[2 * x], b = row[2 * x + 1], most = a > b ? a : b;
      out[x] = out[x] > most ? out[x] : most;
    }
  }
  if (is_large)
    dilate<kReach / 2>(std::as_const(work.nearer).view(), work.nearer_rows, work.nearer.view());
  else
    dilate<kReach>(std::as_const(work.nearer).view(), work.nearer_rows, work.nearer.view());

  work.mask.resize(width, height);
  for (int y = 0; y < height; ++y) {
    const float* depth = frame.row(box.y + y) + box.x;
    const float* surface = work.surface.row(y);
    const float* blocks = work.nearer.row((y + kReach) >> shift);
    if (is_large && y % 2 == 0)
      for (int x = 0; x < work.nearer.width(); ++x) row[2 * x] = row[2 * x + 1] = blocks[x];
    const float* nearer = (is_large ? row : blocks) + kReach;
    const std::uint8_t* outside = work.outside.row(y + kErosion) + kErosion;
    std::uint8_t* __restrict may = work.mask.row(y);
    for (int x = 0; x < width; ++x) {
      const float other = depth[x] > 0 ? 0.0f : assumed_q, q = surface[x] > 0 ? surface[x] : other;
      const int admitted = (nearer[x] <= kNearerOutside * q + slack) & (q > 0) & (outside[x] == 0);
      may[x] = admitted ? 255 : 0;
    }
  }
}

/// Takes the share of the noise out of a plane's tilt, as a tilt within the noise would cause spurious radial motion.
/// With the variance T of the plane's inverse depth over the object, and its part N from the noise, what is left of the
/// tilt is 1 - N / T (James-Stein, positive part). The plane keeps the object's median at the middle of its pixels.
/// @param step of the pixels that are looked at. @param relief that an object of this size may have, 1/m.
/// @return variance, at the object's border, of the difference between the plane and a plane through its true surface,
/// 1/m^2; 0 where too few pixels have depth for a tilt. An object's size limits it.
inline double shrink_tilt(ImageView<const float> surface, int step, float median_q, double relief, PlaneFit& plane) {
  constexpr double kAtBorder = 3;        // square of a tilt at the border, over its mean square
  constexpr double kOfRelief = 1.0 / 3;  // a car's root mean square about its plane, over half of its size
  const int column = surface.width / 2, row = surface.height / 2;
  double n = 0, u = 0, v = 0, uu = 0, uv = 0, vv = 0;
  for (int y = 0; y < surface.height; y += step)
    for (int x = 0; x < surface.width; x += step) {
      if (!(surface(x, y) > 0)) continue;
      const double du = x - column, dv = y - row;
      n += 1, u += du, v += dv, uu += du * du, uv += du * dv, vv += dv * dv;
    }
  const double a = static_cast<double>(plane.du), b = static_cast<double>(plane.dv);
  const bool is_fitted = plane.inliers > kCorrelatedArea && n > 0;
  const double each = n > 0 ? 1 / n : 0, mean_u = u * each, mean_v = v * each;
  const double tilt = a * a * (uu * each - mean_u * mean_u) + 2 * a * b * (uv * each - mean_u * mean_v) +
                      b * b * (vv * each - mean_v * mean_v);
  const double of_slope = static_cast<double>(plane.variance) * kCorrelatedArea / std::max(1, plane.inliers);
  const double most = relief * relief;
  const double left = is_fitted && tilt > 0 ? std::max(0.0, 1 - 2 * of_slope / tilt) : 0;
  plane.du = static_cast<float>(left * a);
  plane.dv = static_cast<float>(left * b);
  plane.q = median_q - static_cast<float>(left * (a * mean_u + b * mean_v));
  return is_fitted ? std::min(kAtBorder * of_slope, most) + kOfRelief * kOfRelief * most : 0;
}

}  // namespace selecting

/// Selects the points of one object: inside its eroded mask, within the object's depth range, away from occluders.
///
/// Masks are ragged and include pixels of other surfaces. So only depths between the 20th and 80th percentile of the
/// mask count, widened by the possible extent of an object of this range and relief. If an object is so far that its
/// relief is below the depth noise, or if less than a quarter of its pixels have depth, its points share one plane,
/// which is then also used where depth is not measured. An object with few depths that is so near that its relief is a
/// large part of its distance gets planes from fewer depths if it is large, else no points. It gets none either if the
/// depths are those of more than one thing, as wrong ones of stereo are. Where measurements are far
/// apart, there are none without some of them in the mask: its depth may then be that of its neighbours.
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
  if (select.far_apart() && select.measurements->inside(box.x, box.y, mask) < selecting::kLeastMeasured) return out;
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
  SelectionRegion region;
  region.radius = std::clamp(static_cast<int>(std::sqrt(static_cast<double>(area)) / 8), 3, 6);
  if (const double density = static_cast<double>(out.pixels_with_depth) / area; density < region.least_share) {
    if (relief <= selecting::kFlatRelief * static_cast<double>(out.median_q)) {  // its distance is enough
      flat = true;
      plane.variance = static_cast<float>(relief * relief);
      plane.inliers = 1;
    } else {
      // The window of a large object still has enough for a plane, if they are depths of that object.
      const int side = 2 * region.radius + 1;
      const double deep = static_cast<double>(1 / far - 1 / near);  // metres
      region.least_share = selecting::kShareOfDensity * density;
      if (deep > selecting::kDeepest * size || region.least_share * side * side < selecting::kLeastDepths) return out;
    }
  }
  out.shape_known = true;
  if (flat) {
    out.slope_variance = selecting::shrink_tilt(work.surface.view(), step, out.median_q, relief, plane);
  }
  selecting::admit(frame, box, mask, area, flat ? out.median_q : 0, slack, work);
  if (select.overlaid) select.overlaid->cut(box.x, box.y, work.mask.view());

  region.box = box;
  region.mask = work.mask.view();
  region.surface = work.surface.view();
  region.budget = select.settings.object_points;
  region.shared = flat ? &plane : nullptr;
  // Strong gradients carry the information. Weak ones are used only if there are too few strong ones.
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
