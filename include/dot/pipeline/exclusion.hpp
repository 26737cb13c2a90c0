// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "dot/image/view.hpp"
#include "dot/pipeline/result.hpp"

namespace dot {

/// Which objects the caller excludes by the mask.
struct ExclusionPolicy {
  bool exclude_not_observable = true;  ///< objects that were never decided; for others the last decision counts
  bool exclude_static = false;         ///< objects that are known to stand still, too
  int dilation = 2;                    ///< pixels
};

namespace exclusion {

/// Whether objects of this state are excluded. For an object that is not observable now its last decided state counts:
/// pass ObjectResult::last_decided.
inline bool excludes(const ExclusionPolicy& policy, State state) {
  switch (state) {
    case State::Moving: return true;
    case State::Static: return policy.exclude_static;
    case State::NotObservable: return policy.exclude_not_observable;
    case State::Background: break;
  }
  return false;
}

/// Sets all pixels at most `radius` columns and rows from one that is 255; the others must be 0.
inline void dilate(ImageView<std::uint8_t> mask, int radius) {
  constexpr std::uint8_t set = 255, spread = 1;  // kept distinct until the direction is done
  const auto visit = [&](std::uint8_t& pixel, int& reach) {
    if (pixel == set) {
      reach = radius;
    } else if (reach > 0) {
      --reach;
      pixel = spread;
    }
  };
  const auto finish = [&] {
    for (int y = 0; y < mask.height; ++y)
      std::transform(mask.row(y), mask.row(y) + mask.width, mask.row(y),
                     [](std::uint8_t value) { return value != 0 ? set : value; });
  };
  for (int y = 0; y < mask.height; ++y) {
    std::uint8_t* row = mask.row(y);
    int reach = 0;
    for (int x = 0; x < mask.width; ++x) visit(row[x], reach);
    reach = 0;
    for (int x = mask.width - 1; x >= 0; --x) visit(row[x], reach);
  }
  finish();
  std::vector<int> reach(static_cast<std::size_t>(mask.width), 0);
  const auto sweep = [&](int y) {
    std::uint8_t* row = mask.row(y);
    for (std::size_t x = 0; x < reach.size(); ++x) visit(row[x], reach[x]);
  };
  for (int y = 0; y < mask.height; ++y) sweep(y);
  std::fill(reach.begin(), reach.end(), 0);
  for (int y = mask.height - 1; y >= 0; --y) sweep(y);
  finish();
}

}  // namespace exclusion

/// Writes the mask that a feature extractor needs: 255 = do not use this pixel, 0 = use it. OpenCV's feature detectors
/// need the opposite, see `feature_mask`.
///
/// Moving objects are excluded and, by policy, objects that were never decided. For an object that is not observable
/// now its last decided state counts. The excluded area is widened by `policy.dilation` pixels (square).
/// @param out of the size of `result.labels`.
/// @throws std::invalid_argument if `out` has another size or the dilation is negative; `out` is then unchanged.
inline void exclusion_mask(const Result& result, const ExclusionPolicy& policy, ImageView<std::uint8_t> out) {
  const ImageView<const std::uint8_t>& labels = result.labels;
  if (out.width != labels.width || out.height != labels.height || (out.data == nullptr && !labels.empty()))
    throw std::invalid_argument("out must have the size of result.labels");
  if (policy.dilation < 0) throw std::invalid_argument("policy.dilation must be >= 0");

  const auto excluded = [&policy](State state) { return exclusion::excludes(policy, state); };
  // Neighbouring pixels are mostly of one object, so the object is looked up only when the id changes.
  std::uint32_t id = 0;
  bool undecided_excluded = excluded(State::NotObservable);
  for (int y = 0; y < out.height; ++y) {
    const std::uint8_t* label = labels.row(y);
    const std::uint32_t* ids = result.ids.empty() ? nullptr : result.ids.row(y);
    std::uint8_t* row = out.row(y);
    for (int x = 0; x < out.width; ++x) {
      const auto state = static_cast<State>(label[x]);
      bool exclude = excluded(state);
      if (state == State::NotObservable && ids != nullptr) {
        if (ids[x] != id) {
          id = ids[x];
          const ObjectResult* object = result.find(id);
          undecided_excluded = excluded(object != nullptr ? object->last_decided : state);
        }
        exclude = undecided_excluded;
      }
      row[x] = exclude ? 255 : 0;
    }
  }
  if (policy.dilation > 0) exclusion::dilate(out, policy.dilation);
}

/// The same in the polarity of OpenCV's feature detectors: 0 = do not use this pixel, 255 = use it.
inline void feature_mask(const Result& result, const ExclusionPolicy& policy, ImageView<std::uint8_t> out) {
  exclusion_mask(result, policy, out);
  for (int y = 0; y < out.height; ++y)
    std::transform(out.row(y), out.row(y) + out.width, out.row(y),
                   [](std::uint8_t value) { return static_cast<std::uint8_t>(255 - value); });
}

/// Share of the image that `policy` excludes, 0 to 1, without the dilation. It warns a host that too few features are
/// left. Its cost grows with the number of objects, not of pixels.
inline double masked_share(const Result& result, const ExclusionPolicy& policy = {}) {
  if (result.labels.empty()) return 0;
  double pixels = 0;
  for (const ObjectResult& object : result.objects) {
    const State state = object.state == State::NotObservable ? object.last_decided : object.state;
    if (exclusion::excludes(policy, state)) pixels += object.area;
  }
  return pixels / (static_cast<double>(result.labels.width) * result.labels.height);
}

}  // namespace dot
