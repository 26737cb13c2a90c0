// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "dot/abi.hpp"
#include "dot/frame/depth_measurements.hpp"
#include "dot/image/pyramid.hpp"
#include "dot/kernel/portable_kernels.hpp"
#include "dot/points/overlaid_pixels.hpp"
#include "dot/points/plane_fit.hpp"
#include "dot/points/point_set.hpp"
#include "dot/points/settings.hpp"

DOT_BEGIN_NAMESPACE

/// A rectangle of the image, in pixels.
struct Box {
  int x = 0;       ///< first column
  int y = 0;       ///< first row
  int width = 0;   ///< columns
  int height = 0;  ///< rows
};

/// The region to select points from, and their number. The images have the box's size.
struct SelectionRegion {
  Box box;                             ///< of the image
  ImageView<const std::uint8_t> mask;  ///< non-zero = the pixel may be a point; empty: all may
  ImageView<const float> surface;      ///< inverse depth that planes may use, 0 = none
  int budget = 0;                      ///< approximate number of points
  int radius = 5;                      ///< pixels: half size of the window whose plane gives a point its depth
  double min_gradient = 0;             ///< grey values per pixel
  double least_share = 0.25;           ///< of the window's pixels, whose depth must be on the plane
  const PlaneFit* shared = nullptr;    ///< one plane for all points instead (distant object), also where depth is not
  ///< measured; about the pixel (width / 2, height / 2) of the box
};

/// Memory of the selection, kept from frame to frame.
struct SelectionWorkspace {
  std::vector<int> keys;                 ///< of a strip's columns
  std::vector<std::uint8_t> everywhere;  ///< a row of 255, for regions without a mask
  std::vector<kernel::PlaneSeed> seeds;  ///< pixels of the box
  std::vector<PlaneFit> planes;          ///< one for each seed
  std::vector<float> values;             ///< of an object's depths, 1/m
  std::vector<float> row;                ///< scratch
  Image<std::uint8_t> mask;              ///< pixels of an object's box that may be points
  Image<std::uint8_t> outside;           ///< pixels of the box outside the object, with a rim
  Image<std::uint8_t> outside_rows;      ///< scratch
  Image<float> surface;                  ///< 1/m, an object's surface in its box
  Image<float> nearer;                   ///< 1/m, nearest surface around each pixel of the box
  Image<float> nearer_rows;              ///< scratch
};

/// Semi-dense selection, as in direct odometry. In each cell of a grid over a box it takes the admitted pixel of
/// strongest gradient (in a large cell, of every few rows), with the depth of the plane that fits the pixel's
/// surroundings.
///
/// A raw depth pixel has its own noise and, near an edge, the depth of another surface. The plane has neither.
template <typename Camera, typename Noise>
struct Selector {
  static constexpr int kMostRows = 16;  ///< rows of a cell that are searched; the best of so many is strong enough

  const Camera& camera;                                 ///< of level 0
  const Noise& noise;                                   ///< of the depth
  const Pyramid& pyramid;                               ///< of the image
  ImageView<const float> inverse_depth;                 ///< 1/m, of the image's size, 0 = none
  const SelectionSettings& settings;                    ///< distances, gradients and window
  SelectionWorkspace& workspace;                        ///< memory
  const kernel::Kernels& kernels = portable_kernels();  ///< for the gradients and planes
  const OverlaidPixels* overlaid = nullptr;             ///< that give an object no points
  const DepthMeasurements* measurements = nullptr;      ///< of sparse depth, if they are far apart

  /// Whether each measurement of the depth stands for the pixels about it.
  bool far_apart() const { return measurements && measurements->far_apart(); }

  /// Appends points, in the order of the cells.
  void operator()(const SelectionRegion& region, PointSet& points) const {
    const Box& box = region.box;
    const int border = 4;  // radius of the samplers and of the blur
    const int x0 = std::max(box.x, border), x1 = std::min(box.x + box.width, inverse_depth.width - border);
    const int y0 = std::max(box.y, border), y1 = std::min(box.y + box.height, inverse_depth.height - border);
    if (x1 <= x0 || y1 <= y0) return;
    const Image<std::uint8_t>& grey = pyramid.levels[0];
    kernel::GradientStrip strip;
    strip.grey_stride = grey.view().stride;
    strip.width = x1 - x0;
    ImageView<const std::uint8_t> mask = region.mask;
    if (!mask.data) {
      workspace.everywhere.assign(static_cast<std::size_t>(box.width), 255);
      mask = {workspace.everywhere.data(), box.width, box.height, 0};
    }
    strip.mask_stride = mask.stride;
    strip.q_stride = region.surface.stride;
    const int cell = cell_size(region, mask, x0 - box.x, y0 - box.y, x1 - box.x, y1 - box.y);
    // The square of twice the gradient, because the central differences are without the factor 1/2.
    const int threshold = static_cast<int>(4 * region.min_gradient * region.min_gradient);
    std::vector<int>& keys = workspace.keys;
    keys.resize(static_cast<std::size_t>(strip.width));
    workspace.seeds.clear();
    strip.row_step = (cell + kMostRows - 1) / kMostRows;
    for (int y = y0; y < y1; y += cell) {
      strip.rows = (std::min(cell, y1 - y) + strip.row_step - 1) / strip.row_step;
      strip.grey = grey.row(y) + x0;
      strip.mask = mask.row(y - box.y) + (x0 - box.x);
      strip.q = region.shared ? nullptr : region.surface.row(y - box.y) + (x0 - box.x);
      kernels.strongest_gradients(strip, threshold, keys.data());
      for (int begin = 0; begin < strip.width; begin += cell) {
        int best = keys[static_cast<std::size_t>(begin)], column = begin;
        for (int x = begin + 1; x < std::min(begin + cell, strip.width); ++x) {
          const int key = keys[static_cast<std::size_t>(x)];
          column = key > best ? x : column;
          best = std::max(best, key);
        }
        if (strip.gradient_of(best) <= threshold) continue;
        const int u = x0 - box.x + column, v = y - box.y + strip.row_step * strip.row_of(best);
        const float measured = region.surface(u, v), sigma = pixel_sigma(region, measured);
        workspace.seeds.push_back({u, v, measured, 5 * sigma});
      }
    }
    fit_and_add(region, points);
  }

  /// Samples the reference intensities of all points on each level.
  void sample_intensities(PointSet& points) const {
    points.levels = std::min(pyramid.size(), PointSet::kMaxLevels);
    for (int l = 0; l < points.levels; ++l) {
      const Image<std::uint8_t>& image = pyramid.levels[static_cast<std::size_t>(l)];
      const auto k = static_cast<std::size_t>(l);
      for (auto* a : {&points.intensity[k], &points.gu[k], &points.gv[k]}) {
        a->reserve(points.u.capacity());  // the number varies from frame to frame
        a->resize(points.u.size());
      }
      kernels.sample({image.row(0), image.width(), image.height(), image.width()}, 1.f / static_cast<float>(1 << l),
                     points.u.data(), points.v.data(), points.size(),
                     {points.intensity[k].data(), points.gu[k].data(), points.gv[k].data()});
    }
  }

 private:
  float pixel_sigma(const SelectionRegion& region, float measured) const {
    return static_cast<float>(noise.pixel_sigma(measured > 0 ? measured : region.shared->q));
  }

  /// Cell size of the grid. The budget is spread over the area that may have points.
  int cell_size(const SelectionRegion& region, ImageView<const std::uint8_t> mask, int x0, int y0, int x1,
                int y1) const {
    constexpr double kSamples = 30000;  // are enough; a small region is counted
    const double size = 1.0 * (x1 - x0) * (y1 - y0);
    const int step = size > 20000 ? std::max(4, static_cast<int>(std::sqrt(size / kSamples))) : 1;
    int area = 0;
    for (int y = y0; y < y1; y += step)
      for (int x = x0; x < x1; x += step) area += mask(x, y) != 0 && (region.shared || region.surface(x, y) > 0);
    area *= step * step;
    const int cell = static_cast<int>(std::lround(std::sqrt(area / std::max(1.0, 1.0 * region.budget))));
    return std::clamp(cell, 1, kernel::kMaxStripRows);
  }

  /// Fits planes to the seeds and adds those whose plane gives a depth.
  void fit_and_add(const SelectionRegion& region, PointSet& points) const {
    const std::vector<kernel::PlaneSeed>& seeds = workspace.seeds;
    std::vector<PlaneFit>& planes = workspace.planes;
    planes.resize(seeds.size());
    if (!region.shared) {
      const int side = 2 * region.radius + 1, least = static_cast<int>(region.least_share * side * side);
      kernels.fit_planes(kernel_view(region.surface), plane_window(region.radius, least), seeds.data(),
                         static_cast<int>(seeds.size()), planes.data());
    }
    for (std::size_t i = 0; i < seeds.size(); ++i) {
      const kernel::PlaneSeed& seed = seeds[i];
      const float sigma = seed.gate / 5;
      PlaneFit fit = planes[i];
      if (region.shared) {
        fit = *region.shared;
        const int du = seed.u - region.box.width / 2, dv = seed.v - region.box.height / 2;
        fit.q += fit.du * static_cast<float>(du) + fit.dv * static_cast<float>(dv);
        if (!(fit.q > 0) || (seed.q > 0 && std::abs(seed.q - fit.q) > seed.gate)) continue;
      } else if (fit.inliers == 0 || fit.variance > 6.25f * sigma * sigma) {
        continue;
      }
      const float independent = std::max(1.f, static_cast<float>(fit.inliers) / static_cast<float>(kCorrelatedArea));
      const float sigma_q = std::max(std::sqrt(fit.variance), 0.25f * sigma) / std::sqrt(independent);
      const float u = static_cast<float>(region.box.x + seed.u), v = static_cast<float>(region.box.y + seed.v);
      const auto ray = camera.template unproject<float>(Eigen::Matrix<float, 2, 1>(u, v));
      points.push(u, v, ray.x(), ray.y(), fit.q, sigma_q);
    }
  }
};

DOT_END_NAMESPACE
