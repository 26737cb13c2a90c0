// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "dot/abi.hpp"
#include "dot/image/image.hpp"
#include "dot/image/morphology.hpp"
#include "dot/mask/mask.hpp"
#include "dot/mask/painted_image.hpp"

DOT_BEGIN_NAMESPACE

/// The pixels that no object covers, with a margin for ragged outlines. The work is done in the objects' boxes alone.
struct BackgroundMask {
  static constexpr int kMargin = 4;  ///< pixels

  Image<std::uint8_t> pixels;  ///< 255: background, 0: at most `kMargin` rows and columns from an object

  /// @param labels non-zero where objects are. @param others boxes (x, y, width, height) inside the image that are not
  /// background either.
  void set(const PaintedImage<std::uint8_t>& labels, const std::vector<std::array<int, 4>>& others = {}) {
    cover_objects(labels);
    for (const auto& [left, top, width, height] : others)
      for (int v = top; v < top + height; ++v) std::fill_n(pixels.row(v) + left, width, std::uint8_t{0});
  }

 private:
  void cover_objects(const PaintedImage<std::uint8_t>& labels) {
    const ImageView<const std::uint8_t> image = labels.image().view();
    pixels.resize(image.width, image.height);
    pixels.fill(255);
    double area = 0;
    for (const auto& box : labels.boxes()) area += 1.0 * box[2] * box[3];
    if (area > 1.0 * image.width * image.height) return cover({0, 0, image.width, image.height}, image);
    for (const auto& box : labels.boxes()) cover(box, image);
  }

  /// Takes a box and its margin out of the background.
  void cover(const std::array<int, 4>& box, ImageView<const std::uint8_t> image) {
    const auto [left, top, width, height] = clip_box(
        {box[0] - kMargin, box[1] - kMargin, box[2] + 2 * kMargin, box[3] + 2 * kMargin}, image.width, image.height);
    covered_.resize(width, height);
    dilate<kMargin>(ImageView<const std::uint8_t>{image.row(top) + left, width, height, image.stride}, rows_,
                    covered_.view());
    for (int v = 0; v < height; ++v) {
      const std::uint8_t* covered = covered_.row(v);
      std::uint8_t* __restrict out = pixels.row(top + v) + left;
      for (int u = 0; u < width; ++u) out[u] = covered[u] ? 0 : out[u];
    }
  }

  Image<std::uint8_t> covered_;  ///< a box and its margin: non-zero where objects are, with the margin
  Image<std::uint8_t> rows_;     ///< scratch of the dilation
};

DOT_END_NAMESPACE
