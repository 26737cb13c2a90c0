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

DOT_BEGIN_NAMESPACE

/// An object's outline and surface in one frame: what the warper carries into other frames.
struct MaskTemplate {
  Mask mask;
  Image<float> inverse_depth;  ///< 1/m, crop of `mask`; smooth and without holes inside the mask, 0 outside
  double median = 0;           ///< 1/m, of the measured values that were used
  bool measured = false;       ///< false: the inverse depth is a guess, against which nothing can be trimmed

  void clear() {
    mask.clear();
    inverse_depth.resize(0, 0);
    median = 0;
    measured = false;
  }
};

/// Buffers of make_template.
struct TemplateWorkspace {
  std::vector<float> values;
  Image<double> sums;  ///< integral image of the accepted inverse depths, one row and column of zeros first
  Image<int> counts;   ///< of their number
};

/// Masks with fewer measured pixels of the object get no template.
inline constexpr int kMinTemplateDepth = 10;

/// Takes an object's inverse depth under a mask whose border is ragged and shows what is behind or before the object.
///
/// Accepted are measured values between the 20th and the 80th percentile under the mask, widened by `tolerance`
/// (relative); percentiles farther from the median than `tolerance` belong to something else and are first moved there.
/// All pixels of the mask, also those refused or without measurement, then get the mean of the accepted values in the
/// smallest window around them (5x5, 9x9, 17x17, ...) that has some.
/// @param inverse_depth 1/m, of the frame, <= 0 or not finite = no measurement.
/// @param mask may be `out.mask`.
/// @return false when there are fewer than kMinTemplateDepth values; `out` is then empty.
inline bool make_template(const Mask& mask, ImageView<const float> inverse_depth, double tolerance,
                          TemplateWorkspace& workspace, MaskTemplate& out) {
  const int width = mask.width(), height = mask.height();
  const auto refuse = [&out] {
    out.clear();
    return false;
  };

  // What was measured under the mask, 0 where nothing was: first in the place of the result.
  out.inverse_depth.resize(width, height);
  auto& values = workspace.values;
  values.resize(static_cast<std::size_t>(mask.area) + 1);
  float* end = values.data();
  const int u0 = std::clamp(-mask.x, 0, width), u1 = std::clamp(inverse_depth.width - mask.x, u0, width);
  for (int v = 0; v < height; ++v) {
    const std::uint8_t* set = mask.pixels.row(v);
    float* measured = out.inverse_depth.row(v);
    std::fill_n(measured, width, 0.0f);
    if (mask.y + v < 0 || mask.y + v >= inverse_depth.height) continue;
    const float* q = inverse_depth.row(mask.y + v) + mask.x;
    for (int u = u0; u < u1; ++u) {
      const bool ok = (set[u] != 0) & (q[u] > 0) & (q[u] <= std::numeric_limits<float>::max());
      measured[u] = ok ? q[u] : 0;
    }
    for (int u = u0; u < u1; ++u) {  // without branches: holes are everywhere
      *end = measured[u];
      end += measured[u] > 0;
    }
  }
  const std::ptrdiff_t count = end - values.data();
  if (count < kMinTemplateDepth) return refuse();

  float* const begin = values.data();
  const auto rank = [](double share, std::ptrdiff_t n) {
    return static_cast<std::ptrdiff_t>(share * static_cast<double>(n - 1));
  };
  const auto nth = [&](std::ptrdiff_t n, float* first, float* last) {
    std::nth_element(first, begin + n, last);
    return static_cast<double>(begin[n]);
  };
  float* const middle = begin + rank(0.5, count);
  const double median = nth(rank(0.5, count), begin, end);
  const double low = std::max(nth(rank(0.2, count), begin, middle + 1), (1 - tolerance) * median) * (1 - tolerance);
  const double high = std::min(nth(rank(0.8, count), middle, end), (1 + tolerance) * median) * (1 + tolerance);

  const auto below = std::count_if(begin, end, [low](float q) { return static_cast<double>(q) < low; });
  std::ptrdiff_t accepted = 0;
  workspace.sums.resize(width + 1, height + 1);
  workspace.counts.resize(width + 1, height + 1);
  std::fill_n(workspace.sums.row(0), width + 1, 0.0);
  std::fill_n(workspace.counts.row(0), width + 1, 0);
  for (int v = 0; v < height; ++v) {
    const float* measured = out.inverse_depth.row(v);
    const double* sums_above = workspace.sums.row(v);
    const int* counts_above = workspace.counts.row(v);
    double* sums = workspace.sums.row(v + 1);
    int* counts = workspace.counts.row(v + 1);
    double sum = 0;
    int n = 0;
    sums[0] = 0;
    counts[0] = 0;
    for (int u = 0; u < width; ++u) {
      const double q = static_cast<double>(measured[u]);
      const bool ok = (q >= low) & (q <= high) & (q > 0);
      sum += ok ? q : 0;
      n += ok;
      sums[u + 1] = sums_above[u + 1] + sum;
      counts[u + 1] = counts_above[u + 1] + n;
    }
    accepted += n;
  }
  if (accepted < kMinTemplateDepth) return refuse();
  out.median = nth(below + rank(0.5, accepted), begin, end);
  out.measured = true;

  constexpr int first_radius = 2, min_count = 5;
  if (&mask != &out.mask) out.mask = mask;
  for (int v = 0; v < height; ++v) {
    const std::uint8_t* set = out.mask.pixels.row(v);
    float* q = out.inverse_depth.row(v);
    const auto mean = [&](int u, int radius) {
      const int x0 = std::max(u - radius, 0), x1 = std::min(u + radius + 1, width);
      const int y0 = std::max(v - radius, 0), y1 = std::min(v + radius + 1, height);
      const auto window = [&](const auto& integral) {
        return integral(x1, y1) - integral(x0, y1) - integral(x1, y0) + integral(x0, y0);
      };
      const int n = window(workspace.counts);
      return n >= min_count ? static_cast<float>(window(workspace.sums) / n) : 0.0f;
    };
    // The smallest window of most pixels, in a loop without branches.
    const int y0 = std::max(v - first_radius, 0), y1 = std::min(v + first_radius + 1, height);
    const double *sums0 = workspace.sums.row(y0), *sums1 = workspace.sums.row(y1);
    const int *counts0 = workspace.counts.row(y0), *counts1 = workspace.counts.row(y1);
    std::fill_n(q, width, 0.0f);
    for (int u = first_radius; u < width - first_radius; ++u) {
      const int x0 = u - first_radius, x1 = u + first_radius + 1;
      const int n = counts1[x1] - counts1[x0] - counts0[x1] + counts0[x0];
      const double sum = sums1[x1] - sums1[x0] - sums0[x1] + sums0[x0];
      q[u] = (set[u] != 0) & (n >= min_count) ? static_cast<float>(sum / n) : 0.0f;
    }
    for (int u = 0; u < width; ++u)
      // The whole crop holds kMinTemplateDepth values or more, so the window finds enough at last.
      for (int radius = first_radius; set[u] != 0 && q[u] == 0; radius *= 2) q[u] = mean(u, radius);
  }
  return true;
}

/// An outline of one inverse depth, for a mask without measurements: at a distance it is only turned with the camera.
inline void make_flat_template(const Mask& mask, double inverse_depth, MaskTemplate& out) {
  out.mask = mask;
  out.median = inverse_depth;
  out.measured = false;
  out.inverse_depth.resize(mask.width(), mask.height());
  for (int v = 0; v < mask.height(); ++v)
    for (int u = 0; u < mask.width(); ++u)
      out.inverse_depth(u, v) = mask.pixels(u, v) ? static_cast<float>(inverse_depth) : 0.0f;
}

/// make_template with buffers of its own.
inline bool make_template(const Mask& mask, ImageView<const float> inverse_depth, double tolerance, MaskTemplate& out) {
  TemplateWorkspace workspace;
  return make_template(mask, inverse_depth, tolerance, workspace, out);
}

DOT_END_NAMESPACE
