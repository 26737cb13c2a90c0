// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <optional>

#include "rule.hpp"

namespace peers {

/// VDO-SLAM: an object moves when enough of its points move in the world from one frame to the next.
///
/// J. Zhang, M. Henein, R. Mahony, V. Ila: VDO-SLAM: A Visual Dynamic Object-aware SLAM System, arXiv:2005.11052,
/// "Dynamic Object Tracking" of the tracking component. The scene flow of a point is its displacement in the world,
/// by optical flow, depth and the camera's motion. Published are 0.12 m, and 30 % of the object's points. The paper has
/// objects move of which over 30 % of the points are faster; the published program those of which at most 30 % are
/// slower, and it leaves objects farther than 25 m undecided.
///
/// Here the flow is OpenCV's DIS flow instead of PWC-Net's, and the camera's motion the true one.
class SceneFlowRule : public Rule {
 public:
  struct Settings {
    double metres_a_frame = 0.12;
    double moving_share = 0.3;                                  ///< of the points
    double farthest = std::numeric_limits<double>::infinity();  ///< mean depth of an object that is decided, metres
  };
  SceneFlowRule(const dot::Intrinsics& camera, const Settings& settings) : camera_(camera), settings_(settings) {}

  Answers next(const View& view) override;

 private:
  dot::Intrinsics camera_;
  Settings settings_;
  std::optional<View> before_;
};

}  // namespace peers
