// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "dot/lie/se3.hpp"

DOT_BEGIN_NAMESPACE

/// An object's own motion since past frames, without the camera's. It moves a mask of a past frame to the present.
///
/// M_t is in the newest camera's axes. A point that would be at X if it had stood still since t is at M_t X. A new
/// frame changes M_t to T_c T_o M_t T_c^-1.
class ObjectPath {
 public:
  /// Forgets the past.
  void clear() { past_.clear(); }

  /// Appends the last interval: the camera's motion T_c and the object's T_o, axes of the previous camera.
  void advance(const SE3d& T_c, const SE3d& T_o) {
    for (Past& p : past_) p.M = T_c * T_o * p.M * T_c.inverse();
  }

  /// Starts the motion since the newest frame. @param oldest earlier frames are forgotten. Both in seconds.
  void add(double timestamp, double oldest) {
    past_.push_back({timestamp, {}});
    past_.erase(past_.begin(),
                std::find_if(past_.begin(), past_.end(), [oldest](const Past& p) { return !(p.timestamp < oldest); }));
  }

  /// Forgets the path after this time, because the object was not found where it leads.
  void forget_after(double timestamp) {
    while (!past_.empty() && past_.back().timestamp > timestamp) past_.pop_back();
  }

  /// M of a past frame. Assumes constant velocity for times that were forgotten or before the object was known.
  /// @param now seconds, of the newest frame. @param velocity m/s, newest camera's axes.
  SE3d since(double then, double now, const Vector3<double>& velocity) const {
    Past next{now, {}};
    for (auto p = past_.rbegin(); p != past_.rend() && p->timestamp >= then; ++p) next = *p;
    return next.M * SE3d::translation(velocity * (next.timestamp - then));
  }

 private:
  struct Past {
    double timestamp;
    SE3d M;
  };
  std::vector<Past> past_;  ///< oldest first
};

DOT_END_NAMESPACE
