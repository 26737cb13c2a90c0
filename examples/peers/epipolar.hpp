// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "rule.hpp"

namespace peers {

/// DS-SLAM: an object moves when points on it leave their epipolar lines.
///
/// C. Yu et al.: DS-SLAM: A Semantic Visual SLAM towards Dynamic Environments, IROS 2018, arXiv:1809.08379, section
/// III-C, "moving consistency check". Points are followed by the pyramidal Lucas-Kanade flow; those near the border of
/// the image, and those whose surroundings have changed, are left out; an object moves when "a certain number" of its
/// points is farther from the line than a threshold. The published program has 1 px, and one point.
///
/// Here the lines are those of the true camera motion instead of a fundamental matrix by RANSAC. Where the camera
/// stands there are no lines; the distance is then that to where the rotation alone takes the point.
class EpipolarRule : public Rule {
 public:
  struct Settings {
    double pixels = 1;
    double moving_share = 0;  ///< of the points; 0: one is enough
  };
  EpipolarRule(const dot::Intrinsics& camera, const Settings& settings) : camera_(camera), settings_(settings) {}

  Answers next(const View& view) override;

 private:
  dot::Intrinsics camera_;
  Settings settings_;
  std::optional<View> before_;
};

}  // namespace peers
