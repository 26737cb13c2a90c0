// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "dot/abi.hpp"
#include "dot/image/image.hpp"
#include "dot/image/view.hpp"
#include "dot/mask/mask.hpp"
#include "dot/statistics/median.hpp"
#include "dot/statistics/nth.hpp"

DOT_BEGIN_NAMESPACE

/// An object's outline and surface in one frame. `warp` moves it into other frames.
struct MaskTemplate {
  int level = 0;               ///< of the image pyramid, whose pixels all below is in
  Mask mask;                   ///< its pixels in the frame
  Image<float> inverse_depth;  ///< 1/m, crop of `mask`; smooth and without holes inside the mask, 0 outside
  double median = 0;           ///< 1/m, of the measured values that were used
  bool measured = false;       ///< false: the inverse depth is a guess, so the mask cannot be trimmed by depth

  /// Makes it empty. Keeps the memory.
  void clear() {
    level = 0;
    mask.clear();
    inverse_depth.resize(0, 0);
    median = 0;
    measured = false;
  }
};

/// Buffers of make_template.
struct TemplateWorkspace {
  std::vector<float> values;  ///< measured inverse depths, 1/m
  Image<double> sums;         ///< integral image of the accepted inverse depths, one row and column of zeros first
  Image<int> counts;          ///< integral image of their number
  std::vector<int> open;      ///< pixels of a row, x, without enough values so far
};

/// Masks with fewer measured pixels of the object get no template.
inline constexpr int kMinTemplateDepth = 10;

namespace templates {

/// Collects the measurements under a mask, 1/m: as an image of the mask's size, 0 where not measured, and as a list in
/// the first elements of `values`. @return their number.
inline std::ptrdiff_t measure(const Mask& mask, ImageView<const float> inverse_depth, Image<float>& measured,
                              std::vector<float>& values) {
  const int width = mask.width(), height = mask.height();
  measured.resize(width, height);
  const std::size_t most = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) + 1;
  if (values.size() < most) values.resize(most);
  float* end = values.data();
  const int begin_u = std::clamp(-mask.x, 0, width);
  const int end_u = std::clamp(inverse_depth.width - mask.x, begin_u, width);
  for (int v = 0; v < height; ++v) {
    const std::uint8_t* set = mask.pixels.row(v);
    float* out = measured.row(v);
    std::fill_n(out, width, 0.0f);
    if (mask.y + v < 0 || mask.y + v >= inverse_depth.height) continue;
    const float* q = inverse_depth.row(mask.y + v) + mask.x;
    for (int u = begin_u; u < end_u; ++u) {
      const bool ok = (set[u] != 0) & (q[u] > 0) & (q[u] <= std::numeric_limits<float>::max());
      out[u] = ok ? q[u] : 0;
    }
    for (int u = begin_u; u < end_u; ++u) {  // without branches, because holes are frequent
      *end = out[u];
      end += out[u] > 0;
    }
  }
  return end - values.data();
}

/// Integral images of the measured values from low to high; the others become 0. @return their number.
inline std::ptrdiff_t integrate(double low, double high, Image<float>& measured, TemplateWorkspace& workspace) {
  const int width = measured.width(), height = measured.height();
  workspace.sums.resize(width + 1, height + 1);
  workspace.counts.resize(width + 1, height + 1);
  std::fill_n(workspace.sums.row(0), width + 1, 0.0);
  std::fill_n(workspace.counts.row(0), width + 1, 0);
  std::ptrdiff_t accepted = 0;
  for (int v = 0; v < height; ++v) {
    float* row = measured.row(v);
    for (int u = 0; u < width; ++u) {
      const double q = static_cast<double>(row[u]);
      row[u] = ((q >= low) & (q <= high)) ? row[u] : 0;
    }
    const double* sums_above = workspace.sums.row(v);
    const int* counts_above = workspace.counts.row(v);
    double* sums = workspace.sums.row(v + 1);
    int* counts = workspace.counts.row(v + 1);
    double sum = 0;
    int count = 0;
    sums[0] = 0;
    counts[0] = 0;
    for (int u = 0; u < width; ++u) {
      sum += static_cast<double>(row[u]);
      count += row[u] > 0;
      sums[u + 1] = sums_above[u + 1] + sum;
      counts[u + 1] = counts_above[u + 1] + count;
    }
    accepted += count;
  }
  return accepted;
}

/// Gives each pixel of the mask the mean of the integrated values in the smallest window around it that has enough of
/// them. The whole mask must have enough. @param first_radius of that window, pixels.
inline void average(const Mask& mask, int first_radius, TemplateWorkspace& workspace, Image<float>& out) {
  constexpr int min_count = 5;
  static_assert(min_count <= kMinTemplateDepth);
  const int width = mask.width(), height = mask.height();
  auto& open = workspace.open;
  open.resize(static_cast<std::size_t>(width));
  for (int v = 0; v < height; ++v) {
    const std::uint8_t* set = mask.pixels.row(v);
    float* q = out.row(v);
    std::fill_n(q, width, 0.0f);
    std::size_t left = 0;
    for (int u = 0; u < width; ++u) {
      open[left] = u;
      left += set[u] != 0;
    }
    for (int radius = first_radius; left > 0; radius *= 2) {
      const int y0 = std::max(v - radius, 0), y1 = std::min(v + radius + 1, height);
      const double *sums0 = workspace.sums.row(y0), *sums1 = workspace.sums.row(y1);
      const int *counts0 = workspace.counts.row(y0), *counts1 = workspace.counts.row(y1);
      std::size_t kept = 0;
      for (std::size_t i = 0; i < left; ++i) {
        const int u = open[i];
        const int x0 = std::max(u - radius, 0), x1 = std::min(u + radius + 1, width);
        const int count = counts1[x1] - counts1[x0] - counts0[x1] + counts0[x0];
        if (count >= min_count)
          q[u] = static_cast<float>((sums1[x1] - sums1[x0] - sums0[x1] + sums0[x0]) / count);
        else
          open[kept++] = u;
      }
      left = kept;
    }
  }
}

}  // namespace templates

/// Makes a template with an object's inverse depth under its mask. The mask's ragged border may contain depths of
/// surfaces behind or in front of the object.
///
/// Measured values between the 20th and the 80th percentile under the mask, widened by `tolerance` (relative), are
/// accepted. Percentiles farther from the median than `tolerance` belong to another surface and are first moved to that
/// distance. All pixels of the mask, also those refused or not measured, then get the mean of the accepted values in
/// the smallest window around them (5x5, 9x9, 17x17, ...) that has enough of them.
/// @param inverse_depth 1/m, of the frame, <= 0 or not finite = no measurement.
/// @param mask may be `out.mask`. @param first_radius of the window, pixels.
/// @return false if there are fewer than kMinTemplateDepth values; `out` is then empty.
inline bool make_template(const Mask& mask, ImageView<const float> inverse_depth, double tolerance,
                          TemplateWorkspace& workspace, MaskTemplate& out, int first_radius = 2) {
  const std::ptrdiff_t count = templates::measure(mask, inverse_depth, out.inverse_depth, workspace.values);
  if (count < kMinTemplateDepth) return out.clear(), false;

  float* const begin = workspace.values.data();
  float* const end = begin + count;
  const Spread<float> measured = spread(begin, end);
  const double median = static_cast<double>(measured.middle);
  const double low = std::max(static_cast<double>(measured.low), (1 - tolerance) * median) * (1 - tolerance);
  const double high = std::min(static_cast<double>(measured.high), (1 + tolerance) * median) * (1 + tolerance);
  const std::ptrdiff_t accepted = templates::integrate(low, high, out.inverse_depth, workspace);
  if (accepted < kMinTemplateDepth) return out.clear(), false;
  const auto below = std::count_if(begin, end, [low](float q) { return static_cast<double>(q) < low; });
  float *const middle = begin + (count - 1) / 2, *const half = begin + below + (accepted - 1) / 2;
  sort_nth(half < middle ? begin : middle, half,
           half < middle ? middle : end);  // partly sorted already by `spread`
  out.level = 0;
  out.median = static_cast<double>(*half);
  out.measured = true;
  if (&mask != &out.mask) out.mask = mask;
  templates::average(out.mask, first_radius, workspace, out.inverse_depth);
  return true;
}

/// Makes an outline of constant inverse depth, for a mask without measurements. A far outline only follows the camera's
/// rotation.
inline void make_flat_template(const Mask& mask, double inverse_depth, MaskTemplate& out) {
  out.level = 0;
  out.mask = mask;
  out.median = inverse_depth;
  out.measured = false;
  out.inverse_depth.resize(mask.width(), mask.height());
  for (int v = 0; v < mask.height(); ++v)
    for (int u = 0; u < mask.width(); ++u)
      out.inverse_depth(u, v) = mask.pixels(u, v) ? static_cast<float>(inverse_depth) : 0.0f;
}

/// make_template with its own buffers.
inline bool make_template(const Mask& mask, ImageView<const float> inverse_depth, double tolerance, MaskTemplate& out) {
  TemplateWorkspace workspace;
  return make_template(mask, inverse_depth, tolerance, workspace, out);
}

DOT_END_NAMESPACE
