// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <utility>

#include "dot/abi.hpp"
#include "dot/image/image.hpp"
#include "dot/image/view.hpp"

DOT_BEGIN_NAMESPACE

/// A set of pixels of a frame, stored as a crop with values 0 or 255. (x, y) is the frame's pixel of its top left
/// corner.
///
/// The functions below make the crop tight: it has no empty border rows or columns, and no pixels at all if none is
/// set.
struct Mask {
  int x = 0;                   ///< column of the crop's left border in the frame
  int y = 0;                   ///< row of the crop's upper border in the frame
  Image<std::uint8_t> pixels;  ///< the crop: 255 = set, 0 = not
  int area = 0;                ///< set pixels

  /// Columns of the crop.
  int width() const { return pixels.width(); }
  /// Rows of the crop.
  int height() const { return pixels.height(); }
  /// Whether no pixel is set.
  bool empty() const { return area == 0; }
  /// Makes it empty. Keeps the memory.
  void clear() {
    x = y = area = 0;
    pixels.resize(0, 0);
  }
  std::array<int, 4> box() const { return {x, y, width(), height()}; }  ///< x, y, width, height

  /// Whether the frame's pixel (u, v) is set; false outside the crop.
  bool at(int u, int v) const {
    return u >= x && v >= y && u < x + width() && v < y + height() && pixels(u - x, v - y) != 0;
  }

  /// Writes `value` to the frame's pixels that are set. @param frame contains the crop.
  template <typename T>
  void write(T value, Image<T>& frame) const {
    for (int v = 0; v < height(); ++v) {
      const std::uint8_t* set = pixels.row(v);
      T* __restrict row = frame.row(y + v) + x;
      for (int u = 0, end = width(); u < end; ++u) {  // compilers make SIMD code from this form
        const T old = row[u];
        row[u] = set[u] != 0 ? value : old;
      }
    }
  }
};

/// The box of the pixels in `box` (x, y, width, height) that `row` selects; its height is 0 if there are none.
/// @param row (v) -> predicate for the pixels of the frame's row v, row(v)(u) -> bool.
template <typename Row>
std::array<int, 4> crop_by_rows(const std::array<int, 4>& box, Row&& row) {
  const int begin = box[0], end = box[0] + box[2];
  const auto has_any = [&](int v) {
    const auto set = row(v);
    for (int u = begin; u < end; ++u)
      if (set(u)) return true;
    return false;
  };
  int top = box[1], bottom = box[1] + box[3];
  while (top < bottom && !has_any(top)) ++top;
  while (top < bottom && !has_any(bottom - 1)) --bottom;
  if (top == bottom) return {begin, top, 0, 0};
  int left = end, right = begin;
  for (int v = top; v < bottom; ++v) {
    const auto set = row(v);
    int u = begin;
    while (u < left && !set(u)) ++u;
    left = u;
    for (u = end; u > right && !set(u - 1);) --u;
    right = u;
  }
  return {left, top, right - left, bottom - top};
}

/// Fills `out` with the pixels of `box` (x, y, width, height) that `row` selects, cropped to them. row(v) returns a
/// predicate for the pixels of the frame's row v, row(v)(u) -> bool. Both may be called repeatedly and must not read
/// `out`.
template <typename Row>
void fill_mask_by_rows(const std::array<int, 4>& box, Row&& row, Mask& out) {
  const auto [left, top, width, height] = crop_by_rows(box, row);
  if (height == 0) return out.clear();
  const int right = left + width, bottom = top + height;
  out.x = left;
  out.y = top;
  out.pixels.resize(width, height);
  out.area = 0;
  for (int v = top; v < bottom; ++v) {
    const auto set = row(v);
    std::uint8_t* pixels = out.pixels.row(v - top);
    int count = 0;
    for (int i = 0; i < right - left; ++i) {
      const bool is_set = set(left + i);
      pixels[i] = is_set ? 255 : 0;
      count += is_set;
    }
    out.area += count;
  }
}

/// The same for pixels that `set(u, v)` selects.
template <typename Predicate>
void fill_mask(const std::array<int, 4>& box, Predicate&& set, Mask& out) {
  fill_mask_by_rows(
      box, [&set](int v) { return [&set, v](int u) { return set(u, v); }; }, out);
}

/// The part of `box` (x, y, width, height) inside a frame. Width or height is 0 if there is none.
inline std::array<int, 4> clip_box(const std::array<int, 4>& box, int frame_width, int frame_height) {
  const auto clip = [](int begin, int length, int size) {
    const std::int64_t first = std::clamp<std::int64_t>(begin, 0, size);
    const std::int64_t last = std::clamp<std::int64_t>(std::int64_t{begin} + length, first, size);
    return std::pair<int, int>(static_cast<int>(first), static_cast<int>(last - first));
  };
  const auto [x, width] = clip(box[0], box[2], frame_width);
  const auto [y, height] = clip(box[1], box[3], frame_height);
  return {x, y, width, height};
}

/// Fills `out` with the pixels of `box` that have this id.
template <typename T>
void crop_ids(ImageView<const T> ids, std::uint32_t id, const std::array<int, 4>& box, Mask& out) {
  fill_mask_by_rows(
      clip_box(box, ids.width, ids.height),
      [&ids, id](int v) { return [row = ids.row(v), id](int u) { return row[u] == id; }; }, out);
}

/// The pixels of a separate image whose top left corner is at (x, y) of the frame: row(v)(u) of the frame -> whether
/// the image is not zero there. It borrows the pixels.
inline auto rows_at(const ImageRef& image, int x, int y) {
  const ImageView<const std::uint8_t> view{static_cast<const std::uint8_t*>(image.data), image.width, image.height,
                                           image.stride};
  return [view, x, y](int v) { return [row = view.row(v - y), x](int u) { return row[u - x] != 0; }; };
}

/// Fills `out` with the pixels of a separate image (Grey8 or Id8, non-zero = object) whose top left corner is at (x, y)
/// of the frame, clipped to the frame.
/// @throws std::invalid_argument for another format.
inline void mask_of(const ImageRef& image, int x, int y, int frame_width, int frame_height, Mask& out) {
  if (image.empty()) return out.clear();
  if (image.format != PixelFormat::Grey8 && image.format != PixelFormat::Id8)
    throw std::invalid_argument("instance.mask.format must be Grey8 or Id8");
  fill_mask_by_rows(clip_box({x, y, image.width, image.height}, frame_width, frame_height), rows_at(image, x, y), out);
}

/// Pixels of the box that `mask_of` gives, which must be known before memory is taken for it. @pre Grey8 or Id8.
inline double box_area_of(const ImageRef& image, int x, int y, int frame_width, int frame_height) {
  const std::array<int, 4> box =
      crop_by_rows(clip_box({x, y, image.width, image.height}, frame_width, frame_height), rows_at(image, x, y));
  return static_cast<double>(box[2]) * box[3];
}

/// Clears the pixels of a mask that are set in another one. The crop stays as it is.
inline void take_out(const Mask& other, Mask& from) {
  const int left = std::max(other.x, from.x), right = std::min(other.x + other.width(), from.x + from.width());
  const int top = std::max(other.y, from.y), bottom = std::min(other.y + other.height(), from.y + from.height());
  for (int v = top; v < bottom; ++v)
    for (int u = left; u < right; ++u) {
      std::uint8_t& pixel = from.pixels(u - from.x, v - from.y);
      if (pixel == 0 || other.pixels(u - other.x, v - other.y) == 0) continue;
      pixel = 0;
      --from.area;
    }
}

/// Number of pixels that are set in both masks.
inline int overlap(const Mask& a, const Mask& b) {
  const int left = std::max(a.x, b.x), right = std::min(a.x + a.width(), b.x + b.width());
  const int top = std::max(a.y, b.y), bottom = std::min(a.y + a.height(), b.y + b.height());
  if (right <= left) return 0;
  int count = 0;
  for (int v = top; v < bottom; ++v) {
    const std::uint8_t* pa = a.pixels.row(v - a.y) + (left - a.x);
    const std::uint8_t* pb = b.pixels.row(v - b.y) + (left - b.x);
    for (int u = 0; u < right - left; ++u) count += (pa[u] & pb[u]) != 0;
  }
  return count;
}

/// Intersection over the smaller of the two areas; 0 if one is empty.
inline double containment(const Mask& a, const Mask& b) {
  const int both = overlap(a, b);
  return both > 0 ? static_cast<double>(both) / std::min(a.area, b.area) : 0;
}

DOT_END_NAMESPACE
