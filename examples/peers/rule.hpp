// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "dot/camera/intrinsics.hpp"
#include "dot/lie/se3.hpp"
#include "dot/motion/state.hpp"

/// @file
/// Rules by which published systems tell moving objects from standing ones, to compare `dot` with. All of them get the
/// same masks and the true camera motion, and decide each frame by itself, as they do in the systems.

namespace peers {

/// What a rule sees of a frame.
struct View {
  cv::Mat grey;              ///< CV_8UC1
  cv::Mat depth;             ///< CV_32FC1, metres, 0 = none
  cv::Mat ids;               ///< CV_32SC1, of the objects, stable over time; 0 = background
  dot::SE3d T_world_camera;  ///< true
};

using Answers = std::map<std::uint32_t, dot::State>;  ///< by id; who is not in it is not observable

class Rule {
 public:
  virtual ~Rule() = default;

  /// The next view of the sequence; its images are kept.
  virtual Answers next(const View& view) = 0;
};

struct PublishedRule {
  std::string name;
  std::string source;  ///< where it is published, and its thresholds
  std::unique_ptr<Rule> rule;
};

/// All rules, for one sequence.
/// @throws runner::UsageError when the program was built without what they need.
std::vector<PublishedRule> published_rules(const dot::Intrinsics& camera);

}  // namespace peers
