// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

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

/// The runs of an id image, in the order of ids.
struct IdRuns {
  /// Neighbouring pixels of one row with the same id.
  struct Run {
    std::uint32_t id;  ///< as in the image
    int y;             ///< row
    int begin;         ///< first column
    int end;           ///< column after the last
  };
  /// Runs [first, last) of one id, and the columns [left, right) that they lie in.
  struct Instance {
    std::size_t first;  ///< first run
    std::size_t last;   ///< run after the last
    int left;           ///< first column
    int right;          ///< column after the last
  };
  std::vector<Run> runs;            ///< sorted by id, then from top to bottom
  std::vector<Instance> instances;  ///< one for each id
  double box_area = 0;              ///< pixels, sum over the ids: memory of their masks
};

namespace id_runs {

/// End of the run of equal pixels that starts at `begin`.
template <typename T>
int end_of_run(const T* row, int begin, int width) {
  constexpr int step = sizeof(std::uint64_t) / sizeof(T);  // pixels that are compared at once
  const std::uint64_t same = row[begin] * (~std::uint64_t{0} / std::numeric_limits<T>::max());
  const auto differs = [row, same](int from) {
    std::uint64_t next = 0;
    std::memcpy(&next, row + from, sizeof next);
    return next ^ same;
  };
  int end = begin + 1;
  while (end + 4 * step <= width &&
         !(differs(end) | differs(end + step) | differs(end + 2 * step) | differs(end + 3 * step)))
    end += 4 * step;
  while (end + step <= width && !differs(end)) end += step;
  while (end < width && row[end] == row[begin]) ++end;
  return end;
}

template <typename T>
void collect(const ImageRef& ids, std::vector<IdRuns::Run>& runs) {
  const ImageView<const T> view{static_cast<const T*>(ids.data), ids.width, ids.height, ids.stride};
  for (int y = 0; y < view.height; ++y) {
    const T* row = view.row(y);
    for (int begin = 0, end = 0; begin < view.width; begin = end) {
      end = end_of_run(row, begin, view.width);
      if (row[begin] != 0) runs.push_back({static_cast<std::uint32_t>(row[begin]), y, begin, end});
    }
  }
}

}  // namespace id_runs

/// Reads an id image in one pass. Id 0 is left out.
/// @throws std::invalid_argument unless the format is Id8, Id16 or Id32.
inline void find_runs(const ImageRef& ids, IdRuns& out) {
  auto& runs = out.runs;
  runs.clear();
  switch (ids.format) {
    case PixelFormat::Id8: id_runs::collect<std::uint8_t>(ids, runs); break;
    case PixelFormat::Id16: id_runs::collect<std::uint16_t>(ids, runs); break;
    case PixelFormat::Id32: id_runs::collect<std::uint32_t>(ids, runs); break;
    default: throw std::invalid_argument("masks.ids.format must be Id8, Id16 or Id32");
  }
  std::sort(runs.begin(), runs.end(), [](const IdRuns::Run& a, const IdRuns::Run& b) {
    return std::tie(a.id, a.y, a.begin) < std::tie(b.id, b.y, b.begin);
  });
  out.instances.clear();
  out.box_area = 0;
  for (std::size_t first = 0, last = 0; first < runs.size(); first = last) {
    int left = runs[first].begin, right = runs[first].end;
    for (; last < runs.size() && runs[last].id == runs[first].id; ++last)
      left = std::min(left, runs[last].begin), right = std::max(right, runs[last].end);
    out.instances.push_back({first, last, left, right});
    out.box_area += 1.0 * (right - left) * (runs[last - 1].y - runs[first].y + 1);
  }
}

/// The masks of all instances of an id image, ids ascending.
/// @param add (id) -> Mask&, to be filled in
template <typename Add>
void split_ids(const IdRuns& ids, Add&& add) {
  for (const auto& [first, last, left, right] : ids.instances) {
    const int top = ids.runs[first].y;
    Mask& mask = add(ids.runs[first].id);
    mask.x = left;
    mask.y = top;
    mask.area = 0;
    mask.pixels.resize(right - left, ids.runs[last - 1].y - top + 1);
    mask.pixels.fill(0);
    for (std::size_t i = first; i < last; ++i) {
      const IdRuns::Run& run = ids.runs[i];
      std::uint8_t* row = mask.pixels.row(run.y - top);
      std::fill(row + (run.begin - left), row + (run.end - left), std::uint8_t{255});
      mask.area += run.end - run.begin;
    }
  }
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
