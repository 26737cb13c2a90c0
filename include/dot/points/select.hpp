// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "dot/abi.hpp"
#include "dot/image/pyramid.hpp"
#include "dot/points/plane_fit.hpp"
#include "dot/points/point_set.hpp"
#include "dot/points/settings.hpp"

DOT_BEGIN_NAMESPACE

/// A rectangle of the image, in pixels.
struct Box {
  int x = 0, y = 0, width = 0, height = 0;
};

/// Semi-dense selection: a grid over `box`, in each cell the accepted pixel of strongest gradient, with the depth of
/// the plane that fits its surroundings (semi-dense, as in direct odometry).
///
/// A raw depth pixel carries its own noise, and near an edge the depth of something else; the plane has neither. The
/// error of n pixels averages like that of n / kCorrelatedArea independent ones, as stereo and interpolated depth are
/// smooth.
template <typename Camera, typename Noise>
struct Selector {
  static constexpr float kCorrelatedArea = 45;  ///< px

  const Camera& camera;
  const Noise& noise;
  const Pyramid& pyramid;
  ImageView<const float> inverse_depth;
  const SelectionSettings& settings;

  /// Appends up to about `budget` points.
  /// @param accept (x, y) -> bool, may the pixel be a point; @param support whose depth its plane may use.
  /// @param min_gradient grey values per pixel.
  /// @param shared a plane for all points (distant object), also those whose depth was not measured; or null.
  template <typename Accept>
  void operator()(const Box& box, int budget, int radius, double min_gradient, Accept&& accept,
                  const DepthSupport& support, const PlaneFit* shared, int shared_u, int shared_v,
                  PointSet& points) const {
    const int border = 4;  // the samplers' and the blur's reach
    const int x0 = std::max(box.x, border), x1 = std::min(box.x + box.width, inverse_depth.width - border);
    const int y0 = std::max(box.y, border), y1 = std::min(box.y + box.height, inverse_depth.height - border);
    if (x1 <= x0 || y1 <= y0) return;
    const Image<std::uint8_t>& grey = pyramid.levels[0];
    // The budget is for the area that may have points at all.
    const int step = (x1 - x0) * (y1 - y0) > 20000 ? 4 : 1;
    int area = 0;
    for (int y = y0; y < y1; y += step)
      for (int x = x0; x < x1; x += step) area += (shared || inverse_depth(x, y) > 0) && accept(x, y);
    area *= step * step;
    const int cell = std::max(1, static_cast<int>(std::lround(std::sqrt(area / std::max(1.0, 1.0 * budget)))));
    // Twice the gradient, squared: central differences without their half.
    const int threshold = static_cast<int>(4 * min_gradient * min_gradient);
    struct Strongest {
      int gradient, x, y;
    };
    std::vector<Strongest> cells(static_cast<std::size_t>((x1 - x0 + cell - 1) / cell));
    std::vector<int> gradients(static_cast<std::size_t>(x1 - x0));
    for (int cy = y0; cy < y1; cy += cell) {
      std::fill(cells.begin(), cells.end(), Strongest{threshold, -1, -1});
      for (int y = cy; y < std::min(cy + cell, y1); ++y) {
        squared_gradients(grey, x0, x1, y, gradients.data());
        for (std::size_t c = 0; c < cells.size(); ++c) {
          const int begin = x0 + static_cast<int>(c) * cell;
          for (int x = begin; x < std::min(begin + cell, x1); ++x) {
            const int g = gradients[static_cast<std::size_t>(x - x0)];
            if (g > cells[c].gradient && (shared || inverse_depth(x, y) > 0) && accept(x, y)) cells[c] = {g, x, y};
          }
        }
      }
      for (const Strongest& s : cells)
        if (s.x >= 0) add(s.x, s.y, radius, support, shared, shared_u, shared_v, points);
    }
  }

  /// Reference intensities of all points, each level.
  void sample_intensities(PointSet& points) const {
    points.levels = std::min(pyramid.size(), PointSet::kMaxLevels);
    for (int l = 0; l < points.levels; ++l) {
      const Image<std::uint8_t>& image = pyramid.levels[static_cast<std::size_t>(l)];
      const float scale = 1.f / static_cast<float>(1 << l);
      const auto k = static_cast<std::size_t>(l);
      for (auto* a : {&points.intensity[k], &points.gu[k], &points.gv[k]}) a->resize(points.u.size());
      for (std::size_t i = 0; i < points.u.size(); ++i) {
        const float u = std::clamp((points.u[i] + 0.5f) * scale - 0.5f, 1.f, static_cast<float>(image.width()) - 2.01f);
        const float v =
            std::clamp((points.v[i] + 0.5f) * scale - 0.5f, 1.f, static_cast<float>(image.height()) - 2.01f);
        const Sample s = sample(image, u, v);
        points.intensity[k][i] = s.value, points.gu[k][i] = s.gx, points.gv[k][i] = s.gy;
      }
    }
  }

 private:
  /// (2 |grad I|)^2 of the pixels x0 <= x < x1 of a row.
  static void squared_gradients(const Image<std::uint8_t>& grey, int x0, int x1, int y, int* out) {
    const std::uint8_t* row = grey.row(y);
    const std::uint8_t* above = grey.row(y - 1);
    const std::uint8_t* below = grey.row(y + 1);
    for (int x = x0; x < x1; ++x) {
      const int gx = row[x + 1] - row[x - 1], gy = below[x] - above[x];
      out[x - x0] = gx * gx + gy * gy;
    }
  }

  void add(int x, int y, int radius, const DepthSupport& support, const PlaneFit* shared, int shared_u, int shared_v,
           PointSet& points) const {
    const float measured = inverse_depth(x, y);
    const float sigma = static_cast<float>(noise.pixel(measured > 0 ? measured : shared->q));
    PlaneFit fit;
    float q;
    if (shared) {
      fit = *shared;
      q = fit.q + fit.du * static_cast<float>(x - shared_u) + fit.dv * static_cast<float>(y - shared_v);
      if (measured > 0 && std::abs(measured - q) > 5 * sigma) return;
    } else {
      const int area = (2 * radius + 1) * (2 * radius + 1);
      if (!fit_plane(inverse_depth, x, y, radius, measured, 5 * sigma, area / 4, support, fit)) return;
      if (fit.rms > 2.5f * sigma) return;
      q = fit.q;
    }
    if (!(q > 0)) return;
    const float independent = std::max(1.f, static_cast<float>(fit.inliers) / kCorrelatedArea);
    const float sigma_q = std::max(fit.rms, 0.25f * sigma) / std::sqrt(independent);
    using Vector2f = Eigen::Matrix<float, 2, 1>;
    const auto ray = camera.template unproject<float>(Vector2f(static_cast<float>(x), static_cast<float>(y)));
    points.push(static_cast<float>(x), static_cast<float>(y), ray.x(), ray.y(), q, sigma_q);
  }
};

DOT_END_NAMESPACE
