// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
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
  const auto measured = [&](int u, int v) {
    if (mask.pixels(u, v) == 0 || !inverse_depth.contains(mask.x + u, mask.y + v)) return 0.0f;
    const float q = inverse_depth(mask.x + u, mask.y + v);
    return std::isfinite(q) && q > 0 ? q : 0.0f;
  };
  const auto refuse = [&out] {
    out.clear();
    return false;
  };

  auto& values = workspace.values;
  values.clear();
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u)
      if (const float q = measured(u, v); q > 0) values.push_back(q);
  if (values.size() < kMinTemplateDepth) return refuse();
  const auto percentile = [&values](double share) {
    const auto nth = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), nth, values.end());
    return static_cast<double>(*nth);
  };
  const double median = percentile(0.5);
  const double low = std::max(percentile(0.2), (1 - tolerance) * median) * (1 - tolerance);
  const double high = std::min(percentile(0.8), (1 + tolerance) * median) * (1 + tolerance);

  values.clear();
  workspace.sums.resize(width + 1, height + 1);
  workspace.counts.resize(width + 1, height + 1);
  std::fill_n(workspace.sums.row(0), width + 1, 0.0);
  std::fill_n(workspace.counts.row(0), width + 1, 0);
  for (int v = 0; v < height; ++v) {
    const double* sums_above = workspace.sums.row(v);
    const int* counts_above = workspace.counts.row(v);
    double* sums = workspace.sums.row(v + 1);
    int* counts = workspace.counts.row(v + 1);
    double sum = 0;
    int count = 0;
    sums[0] = 0;
    counts[0] = 0;
    for (int u = 0; u < width; ++u) {
      if (const float q = measured(u, v); q >= low && q <= high && q > 0) {
        values.push_back(q);
        sum += q;
        ++count;
      }
      sums[u + 1] = sums_above[u + 1] + sum;
      counts[u + 1] = counts_above[u + 1] + count;
    }
  }
  if (values.size() < kMinTemplateDepth) return refuse();
  out.median = percentile(0.5);
  out.measured = true;

  constexpr int first_radius = 2, min_count = 5;
  out.mask = mask;
  out.inverse_depth.resize(width, height);
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      float& q = out.inverse_depth(u, v);
      q = 0;
      if (mask.pixels(u, v) == 0) continue;
      for (int radius = first_radius; q == 0; radius *= 2) {
        const int x0 = std::max(u - radius, 0), x1 = std::min(u + radius + 1, width);
        const int y0 = std::max(v - radius, 0), y1 = std::min(v + radius + 1, height);
        const auto window = [&](const auto& integral) {
          return integral(x1, y1) - integral(x0, y1) - integral(x1, y0) + integral(x0, y0);
        };
        // The whole crop holds kMinTemplateDepth values or more, so the window finds enough at last.
        if (const int count = window(workspace.counts); count >= min_count)
          q = static_cast<float>(window(workspace.sums) / count);
      }
    }
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
