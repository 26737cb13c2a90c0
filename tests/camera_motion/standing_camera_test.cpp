// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/camera_motion/standing_camera.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace {

using dot::CellVotes;
using dot::StandingCamera;
using Depths = CellVotes::Depths;

constexpr int kWidth = 320, kHeight = 160;  // cells of 20 x 20 pixels

/// A hundred points in each of two cells. The first is of what stays, the second of what moves.
struct TwoCells {
  dot::PointSet points;
  Depths staying{};
  std::vector<float> without, with;  ///< costs: of no motion, of the motion found

  /// @param rise of the cost of each point of a cell, if there is no motion.
  TwoCells(float rise_of_first, float rise_of_second) {
    for (int i = 0; i < 200; ++i) {
      points.push(i < 100 ? 10 : 110, 10, 0, 0, 0.1F, 0.01F);
      with.push_back(0.4F);
      without.push_back(0.4F + (i < 100 ? rise_of_first : rise_of_second));
    }
    staying[CellVotes::cell_of(points, 0, kWidth, kHeight)] = 0.1F;
  }
  bool is_zero(double covariance_scale = 4) const {
    return StandingCamera::is_zero(points, without, with, staying, kWidth, kHeight, covariance_scale);
  }
};

TEST(StandingCamera, HasAMotionThatFitsNoBetterThanNone) {
  EXPECT_TRUE(TwoCells(0, 0).is_zero());
  EXPECT_TRUE(TwoCells(-0.1F, 0).is_zero());
  EXPECT_TRUE(TwoCells(0.6F, 0).is_zero());
  EXPECT_FALSE(TwoCells(0.7F, 0).is_zero()) << "2 x 33 of a hundred points";
  EXPECT_FALSE(TwoCells(0.6F, 0).is_zero(1)) << "independent points tell more";
  EXPECT_TRUE(TwoCells(0, 3).is_zero()) << "of what moves";
}

TEST(StandingCamera, IsToldByThePointsThatBothMotionsSee) {
  TwoCells cells(0, 0);
  for (std::size_t i = 0; i < 20; ++i) cells.without[i] = -1, cells.with[99 - i] = -1;
  EXPECT_TRUE(cells.is_zero());
  for (std::size_t i = 20; i < 40; ++i) cells.without[i] = -1;
  EXPECT_FALSE(cells.is_zero()) << "of few points";
}

/// Sets the inverse depth of `count` cells from `first` on.
void set(Depths& cells, std::size_t first, std::size_t count, float q) {
  for (std::size_t i = first; i < first + count; ++i) cells[i] = q;
}

TEST(StandingCamera, StandsInASceneThatIsNotNearerThanWhatMoves) {
  Depths staying{}, moving{};
  set(staying, 0, 20, 0.25F), set(staying, 20, 20, 1);
  set(moving, 60, 30, 0.5F);
  EXPECT_TRUE(StandingCamera::is_scene(staying, moving));
  set(staying, 0, 20, 0.5F);
  EXPECT_TRUE(StandingCamera::is_scene(staying, moving)) << "a table seen from above, with a belt on it";
}

TEST(StandingCamera, IsNotToldByAPartOfItsVehicle) {
  Depths staying{}, moving{};
  set(staying, 0, 36, 1), set(staying, 36, 4, 0.01F);  // a bonnet, and what is far
  set(moving, 60, 30, 0.2F);
  EXPECT_FALSE(StandingCamera::is_scene(staying, moving));
}

TEST(StandingCamera, IsNotToldByAFewCells) {
  Depths staying{}, moving{};
  set(staying, 0, 20, 0.25F);
  set(moving, 60, 30, 0.5F);
  EXPECT_FALSE(StandingCamera::is_scene(staying, moving));
  EXPECT_FALSE(StandingCamera::is_scene({}, {}));
  set(staying, 0, 60, 0.25F);
  EXPECT_FALSE(StandingCamera::is_scene(staying, {})) << "nothing moves";
}

}  // namespace
