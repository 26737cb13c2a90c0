// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "epipolar.hpp"
#include "everything_moves.hpp"
#include "multi_view_depth.hpp"
#include "rule.hpp"
#include "scene_flow.hpp"

namespace peers {

std::vector<PublishedRule> published_rules(const dot::Intrinsics& camera) {
  std::vector<PublishedRule> rules;
  const auto add = [&](const char* name, const char* source, std::unique_ptr<Rule> rule) {
    rules.push_back({name, source, std::move(rule)});
  };
  add("VDO-SLAM, paper", "scene flow: over 30 % of the points over 0.12 m a frame (arXiv:2005.11052)",
      std::make_unique<SceneFlowRule>(camera, SceneFlowRule::Settings{}));
  add("VDO-SLAM, program", "scene flow: at most 30 % of the points under 0.12 m a frame; undecided beyond 25 m",
      std::make_unique<SceneFlowRule>(camera, SceneFlowRule::Settings{0.12, 0.7, 25}));
  add("DS-SLAM, program", "one point over 1 px from its epipolar line (arXiv:1809.08379, III-C)",
      std::make_unique<EpipolarRule>(camera, EpipolarRule::Settings{}));
  add("DS-SLAM, 30 %", "the same, with over 30 % of the points: our choice, the paper has no number",
      std::make_unique<EpipolarRule>(camera, EpipolarRule::Settings{1, 0.3}));
  add("DynaSLAM, geometry", "over 30 % of the points 0.4 m or more before earlier views (arXiv:1806.05620, III-C)",
      std::make_unique<MultiViewDepthRule>(camera, MultiViewDepthRule::Settings{}));
  add("everything moves", "DynaSLAM without its geometry (III-B)", std::make_unique<EverythingMovesRule>());
  return rules;
}

}  // namespace peers
