// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/camera_motion/motion_choice.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "support/exact_points.hpp"
#include "support/film.hpp"

namespace {

using dot::Alignment;
using dot::MotionChoice;
using dot::MotionEvidence;
using dot::PointSet;
using dot::SE3d;
using dot::Vector3;
using namespace dot::test;

/// Two walls side by side, 6 m ahead. The left one is the world, which the camera passes to the left. The right one
/// moves to the right at 0.2 m a frame besides. Points of a wall are dense or thin.
struct TwoWalls {
  const dot::Pinhole camera{small_camera()};
  Rendering before, after;
  dot::Pyramid past, now;
  dot::DirectAligner<> aligner;
  dot::MinimaWorkspace workspace;
  std::vector<const PointSet*> objects;
  std::vector<Alignment> minima;  ///< the world's motion, the right wall's
  static constexpr double kShift = 0.2;

  /// @param moved metres by which the camera moves.
  explicit TwoWalls(double moved = 0.1) {
    Scene scene;
    const auto wall = [](double x, unsigned seed) {
      Body body;
      body.quads.push_back(
          {Vector3<double>(x, 0, 6), Vector3<double>(5, 0, 0), Vector3<double>(0, 8, 0), Texture(seed, 0.4, 2.5)});
      return body;
    };
    scene.bodies = {wall(-5, 1), wall(5, 2)};
    before = scene.render(camera, SE3d{});
    scene.bodies[0].T_world_body = SE3d::translation(Vector3<double>(moved, 0, 0));
    scene.bodies[1].T_world_body = SE3d::translation(Vector3<double>(moved + kShift, 0, 0));
    after = scene.render(camera, SE3d{});
    past.build(before.grey.view(), 3), now.build(after.grey.view(), 3);
    for (const double x : {moved, moved + kShift}) {
      Alignment a;
      a.state.T = SE3d::translation(Vector3<double>(x, 0, 0));
      minima.push_back(a);
    }
  }
  /// Of the left wall, or of the right one, one point every `step` pixels, in a part of the image.
  PointSet points(bool right, int step, int top = 0, int bottom = 240) const {
    return exact_points(
        before, camera, past, step, [=](int x, int y) { return (right ? x > 170 : x < 150) && y >= top && y < bottom; },
        0.001f);
  }
  static PointSet both(const PointSet& a, const PointSet& b) {
    PointSet all = a;
    all.append_every(1, b);
    return all;
  }
  MotionChoice choose(const PointSet& background, const SE3d& predicted = {}, double reach = 1e9,
                      double steadiness = 0) {
    MotionEvidence evidence{objects, {}, reach, steadiness};
    return {
        dot::AlignProblem<dot::Pinhole>{background, now, camera}, minima, predicted, evidence, {}, aligner, workspace};
  }
};

TEST(MotionChoice, LeastCostWinsWhereNothingElseExplainsMuch) {
  TwoWalls walls;
  const MotionChoice choice = walls.choose(walls.points(false, 8));
  EXPECT_EQ(choice.chosen, 0u);
  EXPECT_FALSE(choice.rival);
  EXPECT_GT(walls.minima[0].margin, 0.5);
  EXPECT_EQ(choice.added_variance.norm(), 0);
}

// The right wall has five times as many points, but covers a part of the image only.
TEST(MotionChoice, AreaWinsOverTexture) {
  TwoWalls walls;
  const PointSet all = TwoWalls::both(walls.points(false, 7), walls.points(true, 3, 80, 200));
  const MotionChoice choice = walls.choose(all);
  EXPECT_EQ(choice.chosen, 0u);
  EXPECT_EQ(choice.rival, 1u);
  EXPECT_EQ(choice.added_variance.norm(), 0) << "a clear majority";
}

TEST(MotionChoice, ObjectsThatStandHaveAVote) {
  TwoWalls walls;
  const PointSet all = TwoWalls::both(walls.points(false, 7, 60, 180), walls.points(true, 7));
  EXPECT_EQ(walls.choose(all).chosen, 1u) << "more of the image";
  const PointSet above = walls.points(false, 7, 0, 60), below = walls.points(false, 7, 180, 240);
  walls.objects = {&above, &below, &above, &below};
  EXPECT_EQ(walls.choose(all).chosen, 0u);
}

TEST(MotionChoice, TheReachableOneWinsAContest) {
  TwoWalls walls;
  const PointSet all = TwoWalls::both(walls.points(false, 7), walls.points(true, 7, 80, 200));
  EXPECT_EQ(walls.choose(all).chosen, 0u);
  EXPECT_EQ(walls.choose(all, walls.minima[1].state.T, 0.1).chosen, 1u);
  EXPECT_EQ(walls.choose(all, walls.minima[1].state.T, 1).chosen, 0u) << "both can be reached";
}

// One row of the cells on each wall, too few for a vote. The right one has a little more texture, or much more.
TEST(MotionChoice, AChangeOfASteadyVelocityMustFitClearlyBetter) {
  TwoWalls walls;
  const PointSet left = walls.points(false, 4, 94, 114);
  const PointSet little = TwoWalls::both(left, walls.points(true, 4, 94, 118));
  const PointSet much = TwoWalls::both(left, walls.points(true, 2, 94, 118));
  const SE3d stands = walls.minima[0].state.T;
  EXPECT_EQ(walls.choose(little, stands, 0.22, 0).chosen, 1u) << "a velocity just found";
  EXPECT_EQ(walls.choose(little, stands, 0.22, 1).chosen, 0u);
  EXPECT_EQ(walls.choose(little, stands, 0.1, 1).chosen, 0u) << "out of reach";
  EXPECT_EQ(walls.choose(little, stands, 1, 1).chosen, 1u) << "a small part of the reach";
  EXPECT_EQ(walls.choose(much, stands, 0.22, 1).chosen, 1u);
}

TEST(MotionChoice, CloseVotesAreADoubtOfTheDistanceBetweenTheTwo) {
  TwoWalls walls;
  const PointSet all = TwoWalls::both(walls.points(false, 7), walls.points(true, 7));
  const MotionChoice choice = walls.choose(all);
  ASSERT_TRUE(choice.rival);
  EXPECT_NEAR(choice.added_variance[0], TwoWalls::kShift * TwoWalls::kShift, 1e-9);
  EXPECT_NEAR(choice.added_variance[2], TwoWalls::kShift * TwoWalls::kShift, 1e-9);
  EXPECT_LT(walls.minima[choice.chosen].margin, 0.15);
}

// The left wall stands, and the right one has more of the image.
TEST(MotionChoice, ACameraThatStandsNeedsNoMajority) {
  TwoWalls moving;
  EXPECT_EQ(moving.choose(TwoWalls::both(moving.points(false, 7, 30, 210), moving.points(true, 7))).chosen, 1u);
  EXPECT_FALSE(moving.minima[0].stands || moving.minima[1].stands);
  TwoWalls walls(0);
  const PointSet all = TwoWalls::both(walls.points(false, 7, 30, 210), walls.points(true, 7));
  const MotionChoice choice = walls.choose(all);
  EXPECT_EQ(choice.chosen, 0u);
  EXPECT_EQ(choice.rival, 1u);
  EXPECT_EQ(choice.added_variance.norm(), 0);
  EXPECT_TRUE(walls.minima[0].stands);
  EXPECT_GT(walls.minima[0].margin, 0.15);
  EXPECT_EQ(walls.choose(all, walls.minima[1].state.T, 0.1).chosen, 1u) << "it cannot have stopped";
  TwoWalls little(0.02);
  EXPECT_EQ(little.choose(TwoWalls::both(little.points(false, 7, 30, 210), little.points(true, 7))).chosen, 1u)
      << "less than a pixel";
}

}  // namespace
