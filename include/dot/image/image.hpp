// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "dot/image/buffer.hpp"
#include "dot/image/view.hpp"

namespace dot {

#ifdef _GLIBCXX_DEBUG
inline namespace debug_containers {  // a vector has another layout there, so the symbols must be others
#endif

/// An image that owns its pixels, with rows without padding. `resize` keeps the memory if it is large enough.
template <typename T>
class Image {
 public:
  Image() = default;
  /// All zero.
  Image(int width, int height) {
    resize(width, height);
    fill(T{});
  }

  /// Sets the size. The contents are unspecified afterwards.
  void resize(int width, int height) {
    pixels_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    width_ = width;  // set after the call that may throw, so that the size is always correct
    height_ = height;
  }
  /// Sets all pixels.
  void fill(T value) { std::fill(pixels_.begin(), pixels_.end(), value); }

  /// Columns.
  int width() const { return width_; }
  /// Rows.
  int height() const { return height_; }
  /// Whether it has no pixels.
  bool empty() const { return pixels_.empty(); }
  /// Whether column x, row y is inside.
  bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }
  /// The pixel in column x, row y, which must be inside.
  T& operator()(int x, int y) { return row(y)[x]; }
  /// The pixel in column x, row y, which must be inside.
  const T& operator()(int x, int y) const { return row(y)[x]; }
  /// The first pixel of row y.
  T* row(int y) { return pixels_.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width_); }
  /// The first pixel of row y.
  const T* row(int y) const { return pixels_.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width_); }
  /// A view of all pixels, valid until the size changes.
  ImageView<T> view() { return {pixels_.data(), width_, height_, width_ * static_cast<std::ptrdiff_t>(sizeof(T))}; }
  /// A view of all pixels, valid until the size changes.
  ImageView<const T> view() const {
    return {pixels_.data(), width_, height_, width_ * static_cast<std::ptrdiff_t>(sizeof(T))};
  }

 private:
  int width_ = 0;
  int height_ = 0;
  Buffer<T> pixels_;
};

#ifdef _GLIBCXX_DEBUG
}  // namespace debug_containers
#endif

}  // namespace dot
