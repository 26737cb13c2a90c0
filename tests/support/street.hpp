// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "support/film.hpp"

namespace dot::test {

/// Ids of the cars in `street`.
constexpr std::uint32_t parked = 1, mover = 2;

/// The camera drives on; a car is parked and one crosses at 3 m/s.
inline Film<> street() {
  Film<> film;
  film.camera_path = straight({0, 0, 0}, {0, 0, 1});
  film.degradation.noise = 1;
  film.add(parked, straight({2.8, 1.3, 9}));
  film.add(mover, straight({-4, 1.3, 7.5}, {3, 0, 0}));
  return film;
}

}  // namespace dot::test
