// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "dot/lie/se3.hpp"

DOT_BEGIN_NAMESPACE

/// How an object moved since past frames, apart from the camera: what takes a mask of one of them to the present.
///
/// M_t is in the newest camera's axes: a point that would be at X if it had stood since t is at M_t X. A new frame
/// makes it T_c T_o M_t T_c^-1.
class ObjectPath {
 public:
  void clear() { past_.clear(); }

  /// The last interval: camera motion and the object's, axes of the previous camera.
  void advance(const SE3d& T_c, const SE3d& T_o) {
    for (Past& p : past_) p.M = T_c * T_o * p.M * T_c.inverse();
  }

  /// Starts the motion since the newest frame. @param oldest what is before it is forgotten. Both in seconds.
  void add(double timestamp, double oldest) {
    past_.push_back({timestamp, {}});
    past_.erase(past_.begin(),
                std::find_if(past_.begin(), past_.end(), [oldest](const Past& p) { return !(p.timestamp < oldest); }));
  }

  /// Forgets where it was carried to after this time: it was not found there.
  void forget_after(double timestamp) {
    while (!past_.empty() && past_.back().timestamp > timestamp) past_.pop_back();
  }

  /// M of a past frame. At a time that was forgotten, or before the object was known: at constant velocity.
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
