// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace dot {

/// The label of an object and of each of its pixels. The values are those of the label image.
enum class State : std::uint8_t {
  Background = 0,    ///< no object
  Static = 1,        ///< it stands
  Moving = 2,        ///< it moves
  NotObservable = 3  ///< the data does not decide between Static and Moving
};

/// Name of a state, as in the runner's files.
constexpr const char* to_string(State state) {
  constexpr const char* names[] = {"background", "static", "moving", "unobservable"};
  return static_cast<int>(state) < 4 ? names[static_cast<int>(state)] : "?";
}

}  // namespace dot
