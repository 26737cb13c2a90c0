// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "dot/tracks/track.hpp"

DOT_BEGIN_NAMESPACE

/// Marks for Discovery::find the pixels that are explained already: by tracks, at their expected places, and by
/// observations. @param inverse_depth 1/m, of the frame. @param out has the image's size and is overwritten.
template <typename Discovery>
void explain_pixels(const std::vector<Track*>& tracks, const Observations& observations,
                    const Image<float>& inverse_depth, Image<std::uint8_t>& out) {
  constexpr float kSameSurface = 0.05f;  // relative difference of inverse depth
  out.fill(Discovery::kNothing);
  std::uint8_t number = 0;
  for (const Track* t : tracks) {
    const WarpedMask& warped = t->outline.warped;
    const Mask& mask = warped.mask;
    if (t->is_rejected_candidate()) {
      for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x) {
          const float q = warped.inverse_depth(x, y), now = inverse_depth(mask.x + x, mask.y + y);
          if (q > 0 && now > 0 && std::abs(now - q) < kSameSurface * q)
            out(mask.x + x, mask.y + y) = Discovery::kStanding;
        }
    } else if (t->identity.discovered && !t->candidacy.is_candidate) {
      number = static_cast<std::uint8_t>(number % (Discovery::kStanding - 1) + 1);
      mask.write(number, out);
    }
  }
  for (const Track* t : tracks)
    if (!t->identity.discovered) t->outline.warped.mask.write(Discovery::kCovered, out);
  for (const Observation& o : observations.list) o.mask.write(Discovery::kCovered, out);
}

DOT_END_NAMESPACE
