// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot_eval/pool.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace eval {
namespace {

/// A run whose movers' mask IoU is `correct` / 100.
RunScore run(const std::string& name, int every, long correct, double step_cm) {
  RunScore score;
  score.name = name;
  score.every = every;
  score.objects.emplace();
  score.objects->pixels.push_back({0, 100, correct, 0});
  score.objects->confusion.add(true, Answer::Moving);
  score.objects->confusion.add(false, Answer::Static);
  score.objects->bands[0].moving_speed_error = {0.1 * every};
  score.objects->bands[1].moving_speed_error = {0.3 * every};
  score.camera.emplace();
  score.camera->step_cm = {step_cm};
  score.camera->step_deg = {0.1};
  score.frame_ms = {25, 5, 6, 4};
  score.stage_ms.fill(1);
  return score;
}

TEST(Pool, AddsObjectsAndAveragesMasks) {
  const std::vector<RunScore> runs{run("a", 1, 90, 1), run("b", 1, 80, 3), run("a", 4, 45, 2), run("b", 4, 80, 1)};
  const Pooled first = pool(runs, 1, 1);
  EXPECT_EQ(first.confusion.total(), 4);
  EXPECT_DOUBLE_EQ(first.mask_iou, 0.85);
  EXPECT_DOUBLE_EQ(first.iou_ratio_mean, 1);
  EXPECT_DOUBLE_EQ(first.rpe_trans_median_cm, 3);
  EXPECT_DOUBLE_EQ(first.near_speed_error, 0.2);
  const Pooled fourth = pool(runs, 4, 1);
  EXPECT_DOUBLE_EQ(fourth.iou_ratio_mean, 0.75);
  EXPECT_DOUBLE_EQ(fourth.iou_ratio_min, 0.5);
  EXPECT_DOUBLE_EQ(fourth.stage_ms[0], 1);
  EXPECT_DOUBLE_EQ(fourth.frame_time.mean, 10);
  EXPECT_DOUBLE_EQ(fourth.frame_time.median, 5.5);
  EXPECT_DOUBLE_EQ(fourth.frame_time.p99, 25 - 0.03 * 19);
  EXPECT_DOUBLE_EQ(fourth.frame_time.largest, 25);
  EXPECT_DOUBLE_EQ(fourth.frame_time.second, 25);
}

TEST(Pool, FailedRunsAndRunsWithoutMoversAreLeftOut) {
  std::vector<RunScore> runs{run("a", 1, 90, 1), run("b", 1, 80, 3), run("c", 1, 0, 1)};
  runs[1].error = "b: no such folder";
  runs[2].objects->pixels = {{0, 0, 0, 1}};  // where nothing moves, one pixel is labelled so
  const Pooled pooled = pool(runs, 1, 1);
  EXPECT_EQ(pooled.runs, 3);
  EXPECT_EQ(pooled.failed, 1);
  EXPECT_EQ(pooled.confusion.total(), 4);
  EXPECT_DOUBLE_EQ(pooled.mask_iou, 0.9);
  EXPECT_DOUBLE_EQ(pooled.rpe_trans_median_cm, 1);
}

TEST(Pool, NothingIsNotANumber) {
  const Pooled pooled = pool({}, 1, 1);
  EXPECT_TRUE(std::isnan(pooled.confusion.f1()));
  EXPECT_TRUE(std::isnan(pooled.mask_iou));
  EXPECT_TRUE(std::isnan(pooled.frame_time.mean));
}

}  // namespace
}  // namespace eval
