// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "dot/abi.hpp"
#include "dot/mask/mask.hpp"
#include "dot/mask/settings.hpp"
#include "dot/mask/sparse_assignment.hpp"

DOT_BEGIN_NAMESPACE

/// An object's outline and its distance.
struct Outline {
  const Mask* mask = nullptr;  ///< borrowed
  double inverse_depth = 0;    ///< 1/m, median; 0 if unknown
  double size = 0;             ///< metres, of a predicted one; 0 if unknown
};

/// Whether something is farther from an object along the line of sight than the object is large. @param q its inverse
/// depth, 1/m. @param tolerance share of the depth that counts as no distance.
inline bool is_farther_than_its_size(const Outline& object, double q, double tolerance) {
  if (!(q > 0 && object.inverse_depth > 0 && object.size > 0)) return false;
  const double z = 1 / object.inverse_depth;
  return std::abs(1 / q - z) > std::max(tolerance * z, object.size);
}

/// Finds the predicted outline that each observed one continues. The assignment minimises the sum of 1 - IoU. Allowed
/// are pairs with IoU >= min_iou, and pairs with IoU >= min_iou / 2 where min_containment of the smaller mask is
/// covered (a mask split, merged or half occluded). With less IoU, one mask is many times larger and only lies over the
/// other. A pair is refused if the two overlap poorly, IoU < 2 min_iou, and one is more than twice as far: then one
/// passes behind the other. Depth under a ragged mask may be its neighbour's, so it does not separate masks that
/// overlap well. Where one only covers the other, they must be within the object's size and `depth_tolerance` of one
/// another, because what passes before an object covers it, too.
///
/// Every mask has at most one partner. A mask without partner costs as much as an overlap of zero, so that a good pair
/// is never separated in favour of two poor ones.
/// @return for each observed mask the index of its predicted one, or -1; in `workspace`, valid until its next use.
inline const std::vector<int>& associate(const std::vector<Outline>& predicted, const std::vector<Outline>& observed,
                                         const MaskSettings& settings, SparseAssignWorkspace& workspace) {
  workspace.pairs.clear();
  for (std::size_t i = 0; i < observed.size(); ++i) {
    for (std::size_t j = 0; j < predicted.size(); ++j) {
      const Mask &a = *observed[i].mask, &b = *predicted[j].mask;
      const int both = overlap(a, b);
      if (both == 0) continue;
      const double share = static_cast<double>(both) / (a.area + b.area - both);
      const double covered = static_cast<double>(both) / std::min(a.area, b.area);
      if (share < settings.min_iou && (covered < settings.min_containment || share < 0.5 * settings.min_iou)) continue;
      const double q = observed[i].inverse_depth, expected = predicted[j].inverse_depth;
      const bool apart = q > 0 && expected > 0 && std::max(q, expected) > 2 * std::min(q, expected);
      if (apart && share < 2 * settings.min_iou) continue;
      if (share < settings.min_iou && is_farther_than_its_size(predicted[j], q, settings.depth_tolerance)) continue;
      workspace.pairs.push_back({static_cast<int>(i), static_cast<int>(j), 1 - share});
    }
  }
  return assign(static_cast<int>(observed.size()), static_cast<int>(predicted.size()), 1, workspace);
}

DOT_END_NAMESPACE
