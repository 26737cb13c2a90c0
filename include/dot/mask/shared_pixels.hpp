// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "dot/image/image.hpp"
#include "dot/mask/mask.hpp"

DOT_BEGIN_NAMESPACE

/// A mask and how sure the network is of it.
struct Claim {
  const Mask& mask;             ///< its pixels
  float score;                  ///< the network's
  bool always_dynamic = false;  ///< people and the like
};

/// Whether a mask gives pixels up to another where their depth does not tell whose they are. It lies around the other,
/// as one about a group of things or about the whole image does, or both are of one object and it is less sure. People
/// do not give way to things, because these can count as standing.
inline bool gives_way(const Claim& claim, const Claim& other) {
  constexpr double kOfOne = 0.75;  // IoU of masks of one object
  constexpr double kInside = 0.9;  // of the other one's area
  constexpr double kAround = 1.5;  // of the other one's area, of masks that are as sure
  if (claim.score > other.score || (claim.always_dynamic && !other.always_dynamic)) return false;
  const bool less_sure = claim.score < other.score, larger = claim.mask.area >= kAround * other.mask.area;
  if (!less_sure && !larger) return false;
  const int both = overlap(claim.mask, other.mask);
  const bool of_one = both >= kOfOne * (claim.mask.area + other.mask.area - both);
  return both > 0 && ((less_sure && of_one) || both >= kInside * other.mask.area);
}

/// Gives pixels that are set in two masks to the object whose depth they have: boxes of a detector, and masks of a
/// coarse network, show parts of their neighbours. Where that is not clear, `loser` gives them up. Without one both
/// keep them. By depth alone a mask does not become empty, because its own median stays in it.
/// @param inverse_depth 1/m, of the frame; 0: not measured. @param q_a, q_b medians over the masks, 1/m; 0: not known.
/// @param noise pixel_sigma(q) of an inverse depth, 1/m. @param loser `a`, `b` or null.
/// @return whether a mask has changed. Its crop is tight again.
template <typename Noise>
bool separate(const Image<float>& inverse_depth, const Noise& noise, float q_a, float q_b, Mask& a, Mask& b,
              const Mask* loser, Mask& scratch) {
  constexpr float kSigmas = 4, kSameDepth = 0.05f;  // the latter relative: depths of one object differ by so much
  const float nearer = std::max(q_a, q_b);
  const float doubt = kSigmas * static_cast<float>(noise.pixel_sigma(nearer)) + kSameDepth * nearer;
  const bool apart = q_a > 0 && q_b > 0 && std::abs(q_a - q_b) > doubt;  // else no pixel is nearer by more than that
  if (!apart && !loser) return false;
  const int left = std::max(a.x, b.x), right = std::min(a.x + a.width(), b.x + b.width());
  const int top = std::max(a.y, b.y), bottom = std::min(a.y + a.height(), b.y + b.height());
  bool changed_a = false, changed_b = false;
  for (int v = top; v < bottom; ++v)
    for (int u = left; u < right; ++u) {
      std::uint8_t &in_a = a.pixels(u - a.x, v - a.y), &in_b = b.pixels(u - b.x, v - b.y);
      const float q = inverse_depth(u, v);
      if (!in_a || !in_b) continue;
      const float to_a = std::abs(q - q_a), to_b = std::abs(q - q_b);
      const bool told = apart && q > 0, is_a = told && to_a + doubt < to_b, is_b = told && to_b + doubt < to_a;
      if (is_b || (loser == &a && !is_a))
        in_a = 0, changed_a = true;
      else if (is_a || loser == &b)
        in_b = 0, changed_b = true;
    }
  const auto tighten = [&scratch](Mask& mask) {
    fill_mask(
        mask.box(), [&mask](int u, int v) { return mask.at(u, v); }, scratch);
    std::swap(mask, scratch);
  };
  if (changed_a) tighten(a);
  if (changed_b) tighten(b);
  return changed_a || changed_b;
}

DOT_END_NAMESPACE
