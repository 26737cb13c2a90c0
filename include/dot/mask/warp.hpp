// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "dot/camera/concept.hpp"
#include "dot/image/image.hpp"
#include "dot/image/view.hpp"
#include "dot/lie/se3.hpp"
#include "dot/mask/mask.hpp"
#include "dot/mask/template.hpp"

DOT_BEGIN_NAMESPACE

/// A template as seen in another frame.
struct WarpedMask {
  Mask mask;                   ///< its pixels in the other frame
  Image<float> inverse_depth;  ///< 1/m, predicted; same crop, 0 outside the mask
  int inside_area = 0;         ///< pixels inside the image, before trimming
  int confirmed_area = 0;      ///< of these, pixels where the predicted depth was measured
  int occluded_area = 0;       ///< of these, pixels where something nearer was measured

  /// Makes it empty. Keeps the memory.
  void clear() {
    mask.clear();
    inverse_depth.resize(0, 0);
    inside_area = confirmed_area = occluded_area = 0;
  }

  /// Whether something nearer mostly covers its place. Then its pixels without measurement are likely covered, too.
  bool is_mostly_occluded() const { return 2 * confirmed_area < occluded_area; }
};

/// Buffers of `warp`.
struct WarpWorkspace {
  /// The template's pixels in the current frame, with a border of one pixel. All are 0 where the template has no pixel.
  Image<float> u, v;     ///< pixels
  Image<float> q;        ///< 1/m
  Image<float> scale;    ///< magnification, q over the template's
  Image<float> surface;  ///< 1/m, nearest predicted surface in a box of the image, 0 = none
  Image<float> row;      ///< three rows of scratch
  Image<int> cell;       ///< drawn cell of each pixel of a row: x0, y0, x1, y1, ends excluded
};

namespace warping {

/// Pixels that one template pixel may cover to each side. Bounds the work for an object close to the camera.
inline constexpr float kMaxReach = 8;

/// A box of image pixels, ends excluded.
struct Box {
  int x0;  ///< first column
  int y0;  ///< first row
  int x1;  ///< column after the last
  int y1;  ///< row after the last
};

/// Projects the pixels (x + i, y), i < n, of inverse depths q[i] to pixels (u, v). z is the depth there over the depth
/// here. The results are valid only if q[i] > 0; (u, v) also needs z > 0, in front of the camera. The loop has no
/// branches, so that compilers generate SIMD code from it for simple cameras.
template <typename Camera>
void map_row(const SE3f& T, const Camera& camera, int x, int y, int n, const float* q, float* u, float* v, float* z) {
  const Matrix3<float> R = T.R;
  const Vector3<float> t = T.t;
  int begin = 0;
  while (begin < n && !(q[begin] > 0)) ++begin;
  while (n > begin && !(q[n - 1] > 0)) --n;
  for (int i = begin; i < n; ++i) {
    const Vector2<float> pixel(static_cast<float>(x + i), static_cast<float>(y));
    const Vector3<float> ray = camera.unproject(pixel);
    const Vector3<float> X(R(0, 0) * ray.x() + R(0, 1) * ray.y() + R(0, 2) * ray.z() + t.x() * q[i],
                           R(1, 0) * ray.x() + R(1, 1) * ray.y() + R(1, 2) * ray.z() + t.y() * q[i],
                           R(2, 0) * ray.x() + R(2, 1) * ray.y() + R(2, 2) * ray.z() + t.z() * q[i]);
    const Vector2<float> p = camera.project(X);
    u[i] = p.x();
    v[i] = p.y();
    z[i] = X.z();
  }
}

/// Projects the template's pixels into `w`. Returns the part of the image that they may cover.
template <typename Camera>
Box move_template(const MaskTemplate& source, const SE3f& T, const Camera& camera, WarpWorkspace& w) {
  const int width = source.mask.width(), height = source.mask.height();
  const auto right = static_cast<float>(camera.width() - 1), bottom = static_cast<float>(camera.height() - 1);
  float u0 = right + kMaxReach, u1 = -kMaxReach, v0 = bottom + kMaxReach, v1 = -kMaxReach;
  for (Image<float>* image : {&w.u, &w.v, &w.q, &w.scale}) {
    image->resize(width + 2, height + 2);
    for (const int y : {0, height + 1}) std::fill_n(image->row(y), width + 2, 0.0f);
    for (int y = 1; y <= height; ++y) image->row(y)[0] = image->row(y)[width + 1] = 0;
  }
  w.row.resize(std::max(width + 2, camera.width()), 3);
  for (int y = 0; y < height; ++y) {
    const float* inverse_depth = source.inverse_depth.row(y);
    float *u = w.u.row(y + 1) + 1, *v = w.v.row(y + 1) + 1;
    float *q = w.q.row(y + 1) + 1, *scale = w.scale.row(y + 1) + 1, *z = w.row.row(0);
    map_row(T, camera, source.mask.x, source.mask.y + y, width, inverse_depth, u, v, z);
    for (int x = 0; x < width; ++x) {
      // A point nearer than a thousandth of its former depth counts as behind the camera.
      if (!(inverse_depth[x] > 0) || !(z[x] > 1e-3f) || !std::isfinite(u[x]) || !std::isfinite(v[x])) {
        u[x] = v[x] = q[x] = scale[x] = 0;
        continue;
      }
      if (u[x] < -kMaxReach || v[x] < -kMaxReach || u[x] > right + kMaxReach || v[x] > bottom + kMaxReach) {
        u[x] = v[x] = q[x] = scale[x] = 0;
        continue;
      }
      scale[x] = 1 / z[x];
      q[x] = inverse_depth[x] * scale[x];
      u0 = std::min(u0, u[x]);
      u1 = std::max(u1, u[x]);
      v0 = std::min(v0, v[x]);
      v1 = std::max(v1, v[x]);
    }
  }
  const auto begin = [](float p) { return std::max(static_cast<int>(std::floor(p - kMaxReach)), 0); };
  const auto end = [](float p, int size) { return std::min(static_cast<int>(std::ceil(p + kMaxReach)) + 1, size); };
  return {begin(u0), begin(v0), end(u1, camera.width()), end(v1, camera.height())};
}

/// Adds half the larger of the distances from each moved pixel of a row to its two neighbours, `step` elements before
/// and after. `a` is the coordinate along which they lie in the template. A neighbour whose depth differs much is on
/// another surface and is not used. Without neighbours the magnification gives the size of the cell.
inline void add_reach(const float* a, const float* b, const float* q, const float* scale, int step, int width,
                      float* __restrict reach_a, float* __restrict reach_b) {
  const float *a0 = a - step, *b0 = b - step, *q0 = q - step;
  const float *a1 = a + step, *b1 = b + step, *q1 = q + step;
  for (int x = 1; x < width - 1; ++x) {
    const float before = std::abs(q0[x] - q[x]) < 0.2f * q[x] ? 1.0f : 0.0f;
    const float after = std::abs(q1[x] - q[x]) < 0.2f * q[x] ? 1.0f : 0.0f;
    const float da0 = before * std::abs(a0[x] - a[x]), da1 = after * std::abs(a1[x] - a[x]);
    const float db0 = before * std::abs(b0[x] - b[x]), db1 = after * std::abs(b1[x] - b[x]);
    reach_a[x] += ((da0 > da1 ? da0 : da1) + (1 - before) * (1 - after) * scale[x]) / 2;
    reach_b[x] += (db0 > db1 ? db0 : db1) / 2;
  }
}

/// Draws the moved pixels. Each is drawn as the bounding box of the cell that reaches half way to its neighbours, so
/// that there are no cracks. The nearest surface is kept.
inline void draw_surface(WarpWorkspace& w, const Box& box) {
  constexpr float margin = 0.02f;  // against rounding errors where cells only touch
  // Makes coordinates positive, so that casts round down.
  constexpr int offset = 2 * static_cast<int>(kMaxReach) + 1;
  w.surface.resize(box.x1 - box.x0, box.y1 - box.y0);
  w.surface.fill(0);
  const int width = w.q.width();
  w.cell.resize(width, 4);
  int *x0 = w.cell.row(0), *y0 = w.cell.row(1), *x1 = w.cell.row(2), *y1 = w.cell.row(3);
  const auto first = [](float p) { return static_cast<int>(p + offset) - offset + 1; };
  for (int y = 1; y + 1 < w.q.height(); ++y) {
    const float *u = w.u.row(y), *v = w.v.row(y), *q = w.q.row(y), *scale = w.scale.row(y);
    float *reach_u = w.row.row(0), *reach_v = w.row.row(1);
    std::fill_n(reach_u, width, margin);
    std::fill_n(reach_v, width, margin);
    add_reach(u, v, q, scale, 1, width, reach_u, reach_v);
    add_reach(v, u, q, scale, width, width, reach_v, reach_u);
    for (int x = 1; x < width - 1; ++x) {
      const float du = reach_u[x] < kMaxReach ? reach_u[x] : kMaxReach;
      const float dv = reach_v[x] < kMaxReach ? reach_v[x] : kMaxReach;
      x0[x] = std::max(first(u[x] - du), box.x0) - box.x0;
      y0[x] = std::max(first(v[x] - dv), box.y0) - box.y0;
      x1[x] = std::min(first(u[x] + du), box.x1) - box.x0;
      y1[x] = std::min(first(v[x] + dv), box.y1) - box.y0;
    }
    for (int x = 1; x < width - 1; ++x) {
      if (!(q[x] > 0)) continue;
      for (int j = y0[x]; j < y1[x]; ++j) {
        float* line = w.surface.row(j);
        for (int i = x0[x]; i < x1[x]; ++i)
          if (line[i] < q[x]) line[i] = q[x];
      }
    }
  }
}

/// Counts the pixels of a row of a moved surface, and trims those where something else was measured.
/// @param line predicted inverse depth, 1/m, 0 = none. @param measured 1/m, or null. @param tolerance relative.
inline void trim_row(float* line, int width, const float* measured, float tolerance, WarpedMask& out) {
  int inside = 0, confirmed = 0, occluded = 0;
  if (!measured) {
    for (int i = 0; i < width; ++i) inside += line[i] > 0;
  } else {
    for (int i = 0; i < width; ++i) {  // without branches, so that it becomes SIMD code
      const float q = line[i], d = measured[i] - q, limit = tolerance * q;
      const bool is_set = q > 0;
      const bool is_known = is_set & (measured[i] > 0) & (measured[i] <= std::numeric_limits<float>::max());
      const bool is_nearer = is_known & (d > limit), is_farther = is_known & (-d > limit);
      inside += is_set;
      occluded += is_nearer;
      confirmed += is_known & !is_nearer & !is_farther;
      line[i] = (is_nearer | is_farther) ? 0 : q;
    }
  }
  out.inside_area += inside, out.confirmed_area += confirmed, out.occluded_area += occluded;
}

/// Sets the mask and its inverse depth to the pixels with depth. @param pixels 1/m, 0 = none; pixel (x, y) of the frame
/// comes first.
inline void take_pixels(const Image<float>& pixels, int x, int y, WarpedMask& out) {
  const auto drawn = [&](int v) { return [row = pixels.row(v - y), x](int u) { return row[u - x] > 0; }; };
  fill_mask_by_rows({x, y, pixels.width(), pixels.height()}, drawn, out.mask);
  out.inverse_depth.resize(out.mask.width(), out.mask.height());
  for (int v = 0; v < out.mask.height(); ++v)
    std::copy_n(pixels.row(out.mask.y + v - y) + (out.mask.x - x), out.mask.width(), out.inverse_depth.row(v));
}

/// Whether the mask, interpolated bilinearly at (u, v) of its crop, is at least one half.
inline bool covers(const Image<std::uint8_t>& mask, float u, float v) {
  if (!(u > -1 && v > -1 && u < static_cast<float>(mask.width()) && v < static_cast<float>(mask.height())))
    return false;
  const int x = static_cast<int>(u + 1) - 1, y = static_cast<int>(v + 1) - 1;
  if (x >= 0 && y >= 0 && x + 1 < mask.width() &&
      y + 1 < mask.height()) {  // the usual case; fast away from the outline
    const std::uint8_t *upper = mask.row(y) + x, *lower = mask.row(y + 1) + x;
    if ((upper[0] & upper[1] & lower[0] & lower[1]) == 255) return true;
    if ((upper[0] | upper[1] | lower[0] | lower[1]) == 0) return false;
  }
  const auto at = [&mask](int i, int j) { return mask.contains(i, j) ? static_cast<float>(mask(i, j)) : 0.0f; };
  const float a = u - static_cast<float>(x), b = v - static_cast<float>(y);
  const float top = at(x, y) + a * (at(x + 1, y) - at(x, y));
  const float bottom = at(x, y + 1) + a * (at(x + 1, y + 1) - at(x, y + 1));
  return top + b * (bottom - top) >= 127.5f;
}

}  // namespace warping

/// Warps a template into the current frame, given the motion of its points.
///
/// First the surface is drawn forwards, X = R ray + q t, q' = q / X.z, at the projection of X, where the nearest
/// surface is kept. Then each drawn pixel is moved back by the inverse motion, with its q'. It belongs to the object if
/// the template's mask covers that place. So there are no cracks, and the outline is as sharp as the template's. Last,
/// pixels whose measured inverse depth differs from q' by more than `tolerance` q' are trimmed, because something
/// nearer hides the object there, or the background is visible. Pixels without measurement are kept.
///
/// Template points behind the camera are left out. The mask is empty if nothing is left.
/// @param T_cur_template motion of the object's points from the template's camera to this one, T_c T_o composed.
/// @param inverse_depth_cur 1/m, of the camera's size, <= 0 or not finite = no measurement; empty: nothing is trimmed.
/// @throws std::invalid_argument if `inverse_depth_cur` has another size.
template <typename Camera>
void warp(const MaskTemplate& source, const SE3d& T_cur_template, const Camera& camera,
          ImageView<const float> inverse_depth_cur, double tolerance, WarpWorkspace& workspace, WarpedMask& out) {
  static_assert(is_camera_v<Camera>, DOT_CAMERA_MESSAGE);
  const bool trim = !inverse_depth_cur.empty();
  if (trim && (inverse_depth_cur.width != camera.width() || inverse_depth_cur.height != camera.height()))
    throw std::invalid_argument("inverse_depth_cur must have the camera's size");

  out.clear();
  const SE3f T = T_cur_template.template cast<float>();
  const warping::Box box = warping::move_template(source, T, camera, workspace);
  if (box.x0 >= box.x1 || box.y0 >= box.y1) return;
  warping::draw_surface(workspace, box);
  Image<float>& surface = workspace.surface;
  const SE3f T_template_cur = T.inverse();
  const Mask& mask = source.mask;
  const auto mask_x = static_cast<float>(mask.x), mask_y = static_cast<float>(mask.y);
  const float *pu = workspace.row.row(0), *pv = workspace.row.row(1), *pz = workspace.row.row(2);
  for (int v = box.y0; v < box.y1; ++v) {
    float* line = surface.row(v - box.y0);
    warping::map_row(T_template_cur, camera, box.x0, v, surface.width(), line, workspace.row.row(0),
                     workspace.row.row(1), workspace.row.row(2));
    for (int i = 0; i < surface.width(); ++i)
      if (line[i] > 0 && !(pz[i] > 0 && warping::covers(mask.pixels, pu[i] - mask_x, pv[i] - mask_y))) line[i] = 0;
    warping::trim_row(line, surface.width(), trim ? inverse_depth_cur.row(v) + box.x0 : nullptr,
                      static_cast<float>(tolerance), out);
  }
  warping::take_pixels(surface, box.x0, box.y0, out);
}

/// Removes the pixels without measurement from a mask, which lies inside the frame. Its crop may then be wider than the
/// remaining pixels.
/// @param inverse_depth 1/m, of the frame, <= 0 or not finite = no measurement.
inline void drop_unmeasured(ImageView<const float> inverse_depth, Mask& mask) {
  mask.area = 0;
  for (int v = 0; v < mask.height(); ++v) {
    const float* measured = inverse_depth.row(mask.y + v) + mask.x;
    std::uint8_t* set = mask.pixels.row(v);
    for (int u = 0; u < mask.width(); ++u) {
      if (!(measured[u] > 0 && std::isfinite(measured[u]))) set[u] = 0;
      mask.area += set[u] != 0;
    }
  }
}

DOT_END_NAMESPACE
