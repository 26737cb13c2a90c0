// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "support/film.hpp"

/// @file
/// A scene whose first camera motions are wrong, because a large mover has no mask yet.

namespace dot::test {

inline constexpr std::uint32_t kLorry = 9;

/// A camera behind a lorry at 6 m/s, which covers most of the view; two parked cars beside it.
/// @param masked the frame from which on the network sees the lorry.
inline Film<> behind_a_lorry(const Path& camera_path, int masked) {
  Film<> film;
  film.camera_path = camera_path;
  film.degradation.noise = 1;
  film.add(1, straight({-4.2, 1.3, 9}));
  film.add(2, straight({-4.6, 1.3, 14}));
  film.add(box(kLorry, {3.2, 2.6, 3}, 77, 0.25, 1.2), straight({1, -0.2, 8}, {0.2, 0, 6}));
  film.spoil = [masked](int index, Rendering& seen) {
    for (int y = 0; index < masked && y < seen.ids.height(); ++y)
      for (int x = 0; x < seen.ids.width(); ++x)
        if (seen.ids(x, y) == kLorry) seen.ids(x, y) = 0;
  };
  return film;
}

}  // namespace dot::test
