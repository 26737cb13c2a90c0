// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

/// The rules of published systems, each on scenes of which everything is known: two planes, one before the other.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "peers/epipolar.hpp"
#include "peers/everything_moves.hpp"
#include "peers/multi_view_depth.hpp"
#include "peers/scene_flow.hpp"

namespace peers {
namespace {

const dot::Intrinsics camera{300, 300, 159.5, 119.5, 320, 240, 0};
constexpr int object_id = 7;

/// Grey values of a plane's points, smooth enough for a flow to follow them.
double texture(double x, double y) {
  return 128 + 45 * std::sin(9 * x + 2 * std::sin(5 * y)) + 45 * std::sin(8 * y + 2 * std::sin(6 * x));
}

/// A wall at 12 m and before it a board of 3 x 2 m, both square to the camera's axis.
struct Scene {
  Eigen::Vector3d camera{0, 0, 0};  ///< position in the world
  Eigen::Vector3d board{0, 0, 6};   ///< of its centre

  View view() const {
    View v;
    const cv::Size size(peers::camera.width, peers::camera.height);
    v.grey.create(size, CV_8UC1);
    v.depth.create(size, CV_32FC1);
    v.ids = cv::Mat::zeros(size, CV_32SC1);
    v.T_world_camera.t = camera;
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const Eigen::Vector3d ray((x - peers::camera.cx) / peers::camera.fx, (y - peers::camera.cy) / peers::camera.fy,
                                  1);
        const double to_board = board.z() - camera.z(), to_wall = 12 - camera.z();
        const Eigen::Vector3d on_board = camera + to_board * ray - board;
        const bool hit = std::abs(on_board.x()) < 1.5 && std::abs(on_board.y()) < 1;
        const Eigen::Vector3d on_wall = 0.5 * (camera + to_wall * ray) + Eigen::Vector3d(7, 3, 0);
        v.grey.at<std::uint8_t>(y, x) = static_cast<std::uint8_t>(
            std::lround(hit ? texture(on_board.x(), on_board.y()) : texture(on_wall.x(), on_wall.y())));
        v.depth.at<float>(y, x) = static_cast<float>(hit ? to_board : to_wall);
        if (hit) v.ids.at<int>(y, x) = object_id;
      }
    }
    return v;
  }
};

/// The answer after `frames` frames, between which camera and board move by a step each.
dot::State answer(Rule& rule, int frames, const Eigen::Vector3d& camera_step, const Eigen::Vector3d& board_step,
                  Scene scene = {}) {
  Answers answers;
  for (int i = 0; i < frames; ++i) {
    answers = rule.next(scene.view());
    scene.camera += camera_step;
    scene.board += board_step;
  }
  EXPECT_LE(answers.size(), 1U);
  const auto found = answers.find(object_id);
  return found == answers.end() ? dot::State::NotObservable : found->second;
}

using Step = Eigen::Vector3d;
const Step none(0, 0, 0);
const Step ahead(0, 0, 0.5);

TEST(SceneFlowRule, DecidesByTheDistanceOfAFrame) {
  const auto after = [](const Step& camera_step, const Step& board_step) {
    SceneFlowRule rule(camera, {});
    return answer(rule, 2, camera_step, board_step);
  };
  EXPECT_EQ(after(none, none), dot::State::Static);
  EXPECT_EQ(after(ahead, none), dot::State::Static);
  EXPECT_EQ(after(none, {0.2, 0, 0}), dot::State::Moving);
  EXPECT_EQ(after(ahead, {0.2, 0, 0}), dot::State::Moving);
  EXPECT_EQ(after(none, {0, 0, 0.2}), dot::State::Moving) << "along the line of sight";
  EXPECT_EQ(after(none, {0.08, 0, 0}), dot::State::Static) << "slower than 0.12 m a frame";
}

TEST(SceneFlowRule, NeedsTwoFrames) {
  SceneFlowRule rule(camera, {});
  EXPECT_EQ(answer(rule, 1, none, none), dot::State::NotObservable);
}

TEST(SceneFlowRule, LeavesFarObjectsUndecidedWhereAskedTo) {
  SceneFlowRule near(camera, {0.12, 0.3, 7}), far(camera, {0.12, 0.3, 5});
  EXPECT_EQ(answer(near, 2, none, {0.2, 0, 0}), dot::State::Moving);
  EXPECT_EQ(answer(far, 2, none, {0.2, 0, 0}), dot::State::NotObservable);
}

TEST(SceneFlowRule, WithoutDepthNothingIsObservable) {
  SceneFlowRule rule(camera, {});
  View view = Scene{}.view();
  view.depth.setTo(0);
  rule.next(view);
  EXPECT_TRUE(rule.next(view).empty());
}

TEST(EpipolarRule, DecidesByTheDistanceToTheLine) {
  const auto after = [](const Step& camera_step, const Step& board_step) {
    EpipolarRule rule(camera, {1, 0.3});
    return answer(rule, 2, camera_step, board_step);
  };
  const Step aside(0.2, 0, 0);
  EXPECT_EQ(after(aside, none), dot::State::Static);
  EXPECT_EQ(after(aside, {0, 0.1, 0}), dot::State::Moving) << "5 px across the lines";
  EXPECT_EQ(after(aside, {0.05, 0, 0}), dot::State::Static) << "along the lines no rule of this kind sees it";
  EXPECT_EQ(after(none, none), dot::State::Static);
  EXPECT_EQ(after(none, {0.1, 0, 0}), dot::State::Moving) << "a standing camera has no lines";
}

TEST(EpipolarRule, OnePointIsEnoughForThePublishedProgram) {
  // A patch of the board slides over it: a few of its points move.
  const auto views = [](int shift) {
    View view = Scene{}.view();
    const cv::Rect patch(150, 110, 24, 24);
    for (int y = 0; y < patch.height; ++y)
      for (int x = 0; x < patch.width; ++x)
        view.grey.at<std::uint8_t>(patch.y + y, patch.x + x + shift) =
            static_cast<std::uint8_t>(std::lround(texture(0.1 * x, 0.1 * y)));
    return view;
  };
  EpipolarRule program(camera, {}), most(camera, {1, 0.3});
  program.next(views(0)), most.next(views(0));
  EXPECT_EQ(program.next(views(3))[object_id], dot::State::Moving);
  EXPECT_EQ(most.next(views(3))[object_id], dot::State::Static);
}

TEST(MultiViewDepthRule, DecidesByWhatStandsBeforeAnEarlierView) {
  const auto after = [](int frames, const Step& camera_step, const Step& board_step) {
    MultiViewDepthRule rule(camera, {});
    return answer(rule, frames, camera_step, board_step);
  };
  EXPECT_EQ(after(1, none, none), dot::State::NotObservable);
  EXPECT_EQ(after(6, none, none), dot::State::Static);
  EXPECT_EQ(after(6, {0, 0, 0.2}, none), dot::State::Static);
  EXPECT_EQ(after(6, none, {0, 0, -0.2}), dot::State::Moving) << "it comes 0.8 m closer after a keyframe";
  EXPECT_EQ(after(6, none, {0, 0, -0.05}), dot::State::Static) << "less than 0.4 m";
  EXPECT_EQ(after(6, none, {0, 0, 0.2}), dot::State::Static) << "what goes away uncovers, and is not seen";
}

TEST(MultiViewDepthRule, SeesWhatCoversAPartOfTheWallThatWasSeen) {
  // In frame 5 the first keyframe has seen the wall behind 83 % of the board, the second one behind 17 %.
  Scene scene;
  scene.board.x() = -1.5;
  MultiViewDepthRule rule(camera, {});
  EXPECT_EQ(answer(rule, 6, none, {0.5, 0, 0}, scene), dot::State::Moving);
}

TEST(EverythingMovesRule, SaysSo) {
  EverythingMovesRule rule;
  const Answers answers = rule.next(Scene{}.view());
  EXPECT_EQ(answers, (Answers{{object_id, dot::State::Moving}}));
}

TEST(PublishedRules, HaveNamesAndSources) {
  const std::vector<PublishedRule> rules = published_rules(camera);
  EXPECT_EQ(rules.size(), 6U);
  for (const PublishedRule& rule : rules) {
    EXPECT_FALSE(rule.name.empty());
    EXPECT_FALSE(rule.source.empty());
    EXPECT_TRUE(rule.rule->next(Scene{}.view()).size() <= 1);
  }
}

}  // namespace
}  // namespace peers
