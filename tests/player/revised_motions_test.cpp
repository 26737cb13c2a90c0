// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "player/revised_motions.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace player {
namespace {

dot::Result result_of(std::uint64_t frame_id, double ahead) {
  dot::Result result;
  result.frame_id = frame_id;
  result.camera.T_cur_prev[11] = -ahead;
  return result;
}

dot::CameraRevision revision(std::uint64_t frame_id, double right, double ahead) {
  dot::CameraRevision revision;
  revision.frame_id = frame_id;
  revision.T_cur_prev[3] = -right;
  revision.T_cur_prev[11] = -ahead;
  return revision;
}

TEST(RevisedMotions, AreComparedWithWhatWasSaid) {
  RevisedMotions motions;
  EXPECT_TRUE(motions.next(result_of(10, 0)).empty());
  EXPECT_TRUE(motions.next(result_of(11, -0.3)).empty());
  EXPECT_TRUE(motions.next(result_of(12, -0.2)).empty());
  const std::vector<dot::CameraRevision> revisions{revision(11, 0, 0.3), revision(12, 0.3, 0.2)};
  dot::Result result = result_of(13, 0.3);
  result.revised = {revisions.data(), revisions.size()};
  const std::vector<RevisedMotion> found = motions.next(result);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].frame_id, 11U);
  EXPECT_NEAR(found[0].metres, 0.6, 1e-12);
  EXPECT_EQ(found[1].frame_id, 12U);
  EXPECT_NEAR(found[1].metres, 0.5, 1e-12);
  EXPECT_TRUE(motions.next(result_of(14, 0.3)).empty());
}

TEST(RevisedMotions, OfFramesThatThePageDoesNotHaveAreLeftOut) {
  RevisedMotions motions;
  const std::vector<dot::CameraRevision> revisions{revision(11, 0, 0.3)};
  dot::Result result = result_of(12, 0.3);
  result.revised = {revisions.data(), revisions.size()};
  EXPECT_TRUE(motions.next(result).empty());
}

}  // namespace
}  // namespace player
