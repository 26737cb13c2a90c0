// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "dot/abi.hpp"
#include "dot/image/image.hpp"
#include "dot/mask/mask.hpp"

DOT_BEGIN_NAMESPACE

/// An image of zeros on which masks are painted. It remembers the painted boxes, so that it can be cleared without a
/// pass over the whole image.
template <typename T>
class PaintedImage {
 public:
  using Box = std::array<int, 4>;  ///< x, y, width, height; inside the image

  /// Makes all pixels zero.
  void clear(int width, int height) {
    if (is_unknown_ || width != image_.width() || height != image_.height()) {
      is_unknown_ = true;
      image_.resize(width, height);
      image_.fill(0);
      is_unknown_ = false;
    } else {
      for (const auto& [x, y, columns, rows] : boxes_)
        for (int v = y; v < y + rows; ++v) std::fill_n(image_.row(v) + x, columns, T{0});
    }
    boxes_.clear();
  }

  /// If the image has another size, gives it this size and clears it. Takes the memory for so many boxes.
  void reserve(int width, int height, std::size_t boxes) {
    boxes_.reserve(boxes);
    if (width != image_.width() || height != image_.height()) clear(width, height);
  }

  /// Sets the pixels of a mask, which is inside the image.
  void paint(const Mask& mask, T value) {
    if (mask.empty()) return;
    add(mask.box());
    mask.write(value, image_);
  }

  /// Allows pixels of this box to be changed in `image`.
  void add(const Box& box) { boxes_.push_back(box); }

  /// The next `clear` clears every pixel. For an image whose painting was interrupted.
  void forget() noexcept { is_unknown_ = true; }

  /// The pixels. Those outside of `boxes` are zero and must stay so.
  Image<T>& image() { return image_; }
  /// The pixels. Those outside of `boxes` are zero.
  const Image<T>& image() const { return image_; }
  /// Share of the pixels that are not zero, 0 to 1.
  double share() const {
    const T* first = image_.row(0);
    const auto size = static_cast<std::ptrdiff_t>(image_.width()) * image_.height();
    return size > 0 ? 1 - static_cast<double>(std::count(first, first + size, T{0})) / static_cast<double>(size) : 0;
  }
  /// The boxes of all that was painted. They may overlap.
  const std::vector<Box>& boxes() const { return boxes_; }

 private:
  Image<T> image_;
  std::vector<Box> boxes_;
  bool is_unknown_ = false;
};

DOT_END_NAMESPACE
