// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <tuple>
#include <vector>

#include "dot/abi.hpp"
#include "dot/image/view.hpp"
#include "dot/mask/mask.hpp"

DOT_BEGIN_NAMESPACE

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

inline constexpr int kCacheLine = 64;  ///< bytes

/// End of the run of equal pixels that starts at `begin`. Most of an image is such runs, and the image is new to the
/// caches: what comes is fetched ahead.
template <typename T>
int end_of_run(const T* row, int begin, int width) {
  constexpr int step = sizeof(std::uint64_t) / sizeof(T);  // pixels that are compared at once
  const std::uint64_t same = row[begin] * (~std::uint64_t{0} / std::numeric_limits<T>::max());
  const auto differs = [row, same](int from) {
    std::uint64_t next = 0;
    std::memcpy(&next, row + from, sizeof next);
    return next ^ same;
  };
  constexpr int kAtOnce = 128, kAhead = 2048;  // bytes
  constexpr int block = kAtOnce / sizeof(T);
  int end = begin + 1;
  for (; end + block <= width; end += block) {
#if defined(__GNUC__)
    for (int k = 0; k < kAtOnce; k += kCacheLine)
      __builtin_prefetch(reinterpret_cast<const char*>(row + end) + kAhead + k);
#endif
    T any = 0;
    for (int k = 0; k < block; ++k) any = static_cast<T>(any | (row[end + k] ^ row[begin]));
    if (any) break;
  }
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

DOT_END_NAMESPACE
