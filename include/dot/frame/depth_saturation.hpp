// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>

#include "dot/abi.hpp"
#include "dot/image/depth_plateau.hpp"
#include "dot/lie/se3.hpp"

DOT_BEGIN_NAMESPACE

/// Finds depth that is cut off at a largest value instead of missing. The scene there is farther away than the depth
/// says. A wall square to the view looks the same in a frame if its depth has no noise, as in a simulator; but its
/// depth changes when the camera comes nearer or turns. So the first plateau is left out on suspicion, for as long as
/// it takes to see the camera move. After that a plateau is left out only if it has stayed through a motion.
class DepthSaturation {
 public:
  /// Takes the next frame into account. @param max_depth metres; farther depth counts as not measured.
  /// @return metres; depth from there on is not measured: the plateau's, or infinite.
  double update(const ImageRef& depth, double max_depth) {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    const DepthPlateau plateau = find_plateau(depth, max_depth, depth_);
    share_ = 0;
    if (plateau.depth > 0 && plateau.depth != depth_) replace(plateau);
    if (!(plateau.depth > 0) || plateau.depth != depth_) return depth_ > 0 && certain_ ? depth_ : kNone;
    const double step = depth.format == PixelFormat::DepthU16 ? 1 / depth.depth_units_per_metre : 0;
    certain_ = certain_ || change() > kSteps * step + kOfDepth * depth_;
    if (!certain_ && suspected_++ >= kOnSuspicion) {
      suspected_ = kOnSuspicion;
      return kNone;
    }
    share_ = plateau.share;
    return depth_;
  }

  /// The camera's motion between the last two frames.
  void moved(const SE3<double>& T_cur_prev) {
    if (certain_ || !(depth_ > 0)) return;
    if (is_new_) {
      is_new_ = false;
      return;
    }
    if (++intervals_ > kWindow) forget_motion();
    T_cur_ref_ = T_cur_prev * T_cur_ref_;
  }

  /// It is not known.
  void forget_motion() noexcept { T_cur_ref_ = {}, intervals_ = 0, is_new_ = false; }

  /// Share of the last frame's pixels whose depth was left out.
  double share() const { return share_; }

  /// Starts afresh, as at the first frame.
  void forget() noexcept { *this = {}; }

 private:
  static constexpr int kOnSuspicion = 3;    ///< frames
  static constexpr int kWindow = 10;        ///< motions; the errors of more would add up to one
  static constexpr double kSteps = 1;       ///< of the depth's values: a change that cannot pass unnoticed
  static constexpr double kOfDepth = 1e-3;  ///< likewise, for the errors of the motion

  /// A frame has another largest depth than the plateau's.
  void replace(const DepthPlateau& plateau) {
    if (plateau.depth < depth_ && (certain_ || !plateau.is_flat)) return;
    // There is depth beyond it, or it was a wall, and that is nearer now.
    if (depth_ > 0) suspected_ = kOnSuspicion;
    depth_ = plateau.is_flat ? plateau.depth : 0;
    certain_ = false;
    forget_motion();
    is_new_ = depth_ > 0;
  }

  /// By how much the depth of a wall would have changed somewhere since the plateau was first seen, metres. The wall is
  /// as wide as a tenth of its distance at least.
  double change() const {
    constexpr double kWide = 0.1;
    return std::abs(T_cur_ref_.t.z()) + kWide * depth_ * std::hypot(T_cur_ref_.R(2, 0), T_cur_ref_.R(2, 1));
  }

  double depth_ = 0;      ///< of the plateau, metres; 0: none
  bool certain_ = false;  ///< it stayed through a motion
  bool is_new_ = false;   ///< first seen in the last frame
  int suspected_ = 0;     ///< frames with a plateau that was not certain
  int intervals_ = 0;     ///< of T_cur_ref_
  SE3<double> T_cur_ref_;
  double share_ = 0;
};

DOT_END_NAMESPACE
