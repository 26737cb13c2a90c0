// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <deque>

#include "rule.hpp"

namespace peers {

/// DynaSLAM's multi-view geometry: what stands before that which earlier views have seen there has moved.
///
/// B. Bescos, J. M. Facil, J. Civera, J. Neira: DynaSLAM: Tracking, Mapping and Inpainting in Dynamic Scenes, RA-L
/// 2018, arXiv:1806.05620, section III-C. Points of five earlier keyframes are projected into the view; those of over
/// 30 degrees of parallax are left out. A point is dynamic when its projected depth exceeds the measured one by more
/// than 0.4 m, but not at a border of the depth.
///
/// The paper grows regions of pixels from such points and has no rule for objects; here an object moves when over 30 %
/// of the points that fall on its mask are dynamic. Every fourth view is a keyframe, and the points are those of a grid
/// instead of ORB's. The paper chose 0.4 m for RGB-D cameras indoors.
class MultiViewDepthRule : public Rule {
 public:
  struct Settings {
    double metres = 0.4;
    double parallax_degrees = 30;
    double moving_share = 0.3;  ///< of the points
    std::size_t keyframes = 5;
    int keyframe_every = 4;
  };
  MultiViewDepthRule(const dot::Intrinsics& camera, const Settings& settings) : camera_(camera), settings_(settings) {}

  Answers next(const View& view) override;

 private:
  dot::Intrinsics camera_;
  Settings settings_;
  std::deque<View> keyframes_;
  int count_ = 0;  ///< of views so far
};

}  // namespace peers
