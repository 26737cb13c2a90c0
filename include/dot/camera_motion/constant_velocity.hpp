// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>

#include "dot/lie/se3.hpp"

DOT_BEGIN_NAMESPACE

/// Where the camera is after an interval at constant velocity, in its frame before, metres. A vehicle in a bend turns
/// with its velocity. A camera that shakes turns, but its velocity keeps its direction. Which of both it is, is not
/// known.
/// @param predicted T_cur_prev with the same twist as in the interval before.
/// @return the place along the bend, and the one straight on.
inline std::array<Vector3<double>, 2> places_at_constant_velocity(const SE3d& predicted) {
  return {predicted.inverse().t, -predicted.t};
}

/// Metres by which a motion T_cur_prev leads to another place than constant velocity, at least. Turns do not count.
inline double change_of_place(const SE3d& T_cur_prev, const SE3d& predicted) {
  const Vector3<double> place = T_cur_prev.inverse().t;
  const auto [along, straight] = places_at_constant_velocity(predicted);
  return std::min((place - along).norm(), (place - straight).norm());
}

DOT_END_NAMESPACE
