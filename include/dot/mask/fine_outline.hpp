// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "dot/image/buffer.hpp"
#include "dot/image/image.hpp"
#include "dot/image/morphology.hpp"
#include "dot/lie/se3.hpp"
#include "dot/mask/mask.hpp"
#include "dot/mask/template.hpp"
#include "dot/mask/warp.hpp"

DOT_BEGIN_NAMESPACE

/// Warps the outline of a large object at full resolution, with the surface of a coarse template. The surface is
/// smooth, so that its inverse depth on the coarse level is enough; only the outline is needed to the pixel. Work of
/// some cost for each pixel is done along the outline alone: a block of pixels of the level that comes from inside of
/// the mask needs none. Keeps its buffers.
class FineOutline {
 public:
  /// As `warp` with a template of level 0 made of `mask`. @param mask pixels of level 0. @param coarse the template of
  /// the same mask on a coarser level. @pre inverse_depth_cur has the camera's size or is empty.
  template <typename Camera>
  void warp(const Mask& mask, const MaskTemplate& coarse, const SE3d& T_cur_template, const Camera& camera,
            ImageView<const float> inverse_depth_cur, double tolerance, WarpWorkspace& workspace, WarpedMask& out) {
    const int side = 1 << coarse.level;
    const Camera blocks = camera.at_level(coarse.level);
    const SE3f T = T_cur_template.template cast<float>(), T_template_cur = T.inverse();
    const warping::Box box = warping::move_template(coarse, T, blocks, workspace);
    out.clear();
    if (box.x0 >= box.x1 || box.y0 >= box.y1) return;
    warping::draw_surface(workspace, box);
    extend(workspace.surface);
    find_inside(mask, coarse.level);

    const warping::Box fine{box.x0 * side, box.y0 * side, end_of(box.x1, blocks.width(), side, camera.width()),
                            end_of(box.y1, blocks.height(), side, camera.height())};
    pixels_.resize(fine.x1 - fine.x0, fine.y1 - fine.y0);
    workspace.row.resize(std::max(workspace.row.width(), pixels_.width()), 3);
    const bool trim = !inverse_depth_cur.empty();
    const auto limit = static_cast<float>(tolerance);
    for (int block = box.y0; block < box.y1; ++block) {
      classify(T_template_cur, blocks, box.x0, block, extended_.row(block - box.y0), workspace);
      const int end = block + 1 == box.y1 ? fine.y1 : (block + 1) * side;
      for (int v = block * side; v < end; ++v) {
        float* line = pixels_.row(v - fine.y0);
        draw(mask, T_template_cur, camera, coarse.level, fine.x0, v, extended_.row(block - box.y0), workspace, line);
        warping::trim_row(line, pixels_.width(), trim ? inverse_depth_cur.row(v) + fine.x0 : nullptr, limit, out);
      }
    }
    warping::take_pixels(pixels_, fine.x0, fine.y0, out);
  }

 private:
  enum Place : std::uint8_t { kOutside, kAtOutline, kInside };
  static constexpr int kBorder = 1;            ///< blocks about those of the mask
  static constexpr float kLeastScale = 0.75f;  ///< from this magnification on a block comes from 3x3 of the mask's

  /// End of the pixels of the blocks up to `end`. The last block of the image has its last pixels, too.
  static int end_of(int end, int blocks, int side, int pixels) { return end == blocks ? pixels : end * side; }

  /// Extends the surface by one block, because the mask may reach beyond the template's blocks.
  void extend(const Image<float>& surface) {
    extended_.resize(surface.width(), surface.height());
    dilate<1>(surface.view(), rows_of_surface_, extended_.view());
    const std::ptrdiff_t size = static_cast<std::ptrdiff_t>(surface.width()) * surface.height();
    std::transform(surface.row(0), surface.row(0) + size, extended_.row(0), extended_.row(0),
                   [](float own, float about) { return own > 0 ? own : about; });
  }

  /// Finds the blocks whose 3x3 blocks are all in the mask, and those of whose 3x3 any pixel is.
  void find_inside(const Mask& mask, int level) {
    const int side = 1 << level, width = mask.width();
    x_ = (mask.x >> level) - kBorder, y_ = (mask.y >> level) - kBorder;
    const int columns = ((mask.x + width - 1) >> level) + kBorder - x_ + 1;
    const int rows = ((mask.y + mask.height() - 1) >> level) + kBorder - y_ + 1;
    for (Image<std::uint8_t>* image : {&inside_, &near_}) {
      image->resize(columns, rows);
      image->fill(0);
    }
    least_.resize(static_cast<std::size_t>(width)), most_.resize(static_cast<std::size_t>(width));
    for (int row = kBorder; row < rows - kBorder; ++row) {
      const int begin = std::max((y_ + row) * side - mask.y, 0);
      const int end = std::min((y_ + row + 1) * side - mask.y, mask.height());
      std::copy_n(mask.pixels.row(begin), width, least_.data());
      std::copy_n(mask.pixels.row(begin), width, most_.data());
      for (int y = begin + 1; y < end; ++y) {
        const std::uint8_t* set = mask.pixels.row(y);
        for (int x = 0; x < width; ++x) {
          const auto i = static_cast<std::size_t>(x);
          least_[i] = std::min(least_[i], set[x]), most_[i] = std::max(most_[i], set[x]);
        }
      }
      for (int column = kBorder; column < columns - kBorder; ++column) {
        const int left = std::max((x_ + column) * side - mask.x, 0);
        const int right = std::min((x_ + column + 1) * side - mask.x, width);
        inside_(column, row) = *std::min_element(least_.begin() + left, least_.begin() + right);
        near_(column, row) = *std::max_element(most_.begin() + left, most_.begin() + right);
      }
    }
    erode<1>(std::as_const(inside_).view(), rows_, inside_.view());
    dilate<1>(std::as_const(near_).view(), rows_, near_.view());
  }

  /// Sets places_ for a row of blocks from column x on. @param q 1/m, of each.
  template <typename Camera>
  void classify(const SE3f& T_template_cur, const Camera& blocks, int x, int row, const float* q,
                WarpWorkspace& workspace) {
    const int count = extended_.width();
    places_.resize(static_cast<std::size_t>(count));
    float *u = workspace.row.row(0), *v = workspace.row.row(1), *z = workspace.row.row(2);
    warping::map_row(T_template_cur, blocks, x, row, count, q, u, v, z);
    for (int i = 0; i < count; ++i) {
      Place& place = places_[static_cast<std::size_t>(i)];
      place = kOutside;
      if (!(q[i] > 0) || !(z[i] > 0)) continue;
      const float left = u[i] + 0.5f - static_cast<float>(x_), top = v[i] + 0.5f - static_cast<float>(y_);
      const bool is_about =
          left >= 0 && top >= 0 && left < static_cast<float>(near_.width()) && top < static_cast<float>(near_.height());
      const int column = is_about ? static_cast<int>(left) : 0, line = is_about ? static_cast<int>(top) : 0;
      if (z[i] < kLeastScale)
        place = kAtOutline;
      else if (is_about && near_(column, line))
        place = inside_(column, line) ? kInside : kAtOutline;
    }
  }

  /// Draws the inverse depth of the object's pixels of one row, 0 elsewhere. @param q 1/m, of the blocks.
  template <typename Camera>
  void draw(const Mask& mask, const SE3f& T_template_cur, const Camera& camera, int level, int left, int v,
            const float* q, WarpWorkspace& workspace, float* line) const {
    const auto mask_x = static_cast<float>(mask.x), mask_y = static_cast<float>(mask.y);
    const int count = static_cast<int>(places_.size());
    const auto end_of_block = [&](int i) { return i + 1 == count ? pixels_.width() : (i + 1) << level; };
    float *pu = workspace.row.row(0), *pv = workspace.row.row(1), *pz = workspace.row.row(2);
    for (int i = 0; i < count;) {
      const Place place = places_[static_cast<std::size_t>(i)];
      const int begin = i << level;
      for (; i < count && places_[static_cast<std::size_t>(i)] == place; ++i)
        std::fill(line + (i << level), line + end_of_block(i), place == kOutside ? 0.0f : q[i]);
      if (place != kAtOutline) continue;
      const int end = end_of_block(i - 1);
      warping::map_row(T_template_cur, camera, left + begin, v, end - begin, line + begin, pu, pv, pz);
      for (int k = 0; k < end - begin; ++k)
        if (!(pz[k] > 0) || !warping::covers(mask.pixels, pu[k] - mask_x, pv[k] - mask_y)) line[begin + k] = 0;
    }
  }

  Image<float> extended_;              ///< 1/m, of the blocks: the surface and the blocks about it
  Image<float> pixels_;                ///< 1/m, of the object's pixels, 0 elsewhere
  int x_ = 0, y_ = 0;                  ///< first block of the two that follow
  Image<std::uint8_t> inside_, near_;  ///< non-zero: all 3x3 blocks are in the mask; any pixel of these is
  std::vector<Place> places_;          ///< of the blocks of a row
  Buffer<std::uint8_t> least_, most_;  ///< of the mask's columns, in the rows of a block
  Image<std::uint8_t> rows_;           ///< scratch
  Image<float> rows_of_surface_;       ///< scratch
};

DOT_END_NAMESPACE
