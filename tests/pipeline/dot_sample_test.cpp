// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// The sample sequence against its truth: what the README promises of `dot_run examples/data/mini`.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "dot/dot.hpp"
#include "dot/tracker.hpp"
#include "support/sample.hpp"

namespace {

using dot::ObjectResult;
using dot::Result;
using dot::SE3d;
using dot::State;
using dot::Tracker;
using dot::test::Sample;

const Sample& sample() {
  static const Sample loaded(DOT_SAMPLE_DIR);
  return loaded;
}

constexpr int min_pixels = 200;  // of an object in a frame and in the one before: smaller ones do not count
constexpr double min_speed = 1;  // m/s; what is slower but not parked is left out

/// Counts over a run.
struct Score {
  int true_moving = 0, false_moving = 0, missed_moving = 0;  // objects times frames
  std::map<int, std::pair<int, int>> parked;                 // by true id: frames said moving, of frames
  int static_kept = 0, parked_frames = 0;
  int both = 0, said_only = 0, truth_only = 0;  // pixels
  std::vector<double> camera_cm;

  void add(int i, const Result& result) {
    const Sample::View& view = sample()[i];
    std::map<int, int> area;
    std::map<std::pair<int, std::uint32_t>, int> shared;
    for (int y = 0; y < view.instance.rows; ++y)
      for (int x = 0; x < view.instance.cols; ++x) {
        const int id = view.instance.at<std::uint16_t>(y, x);
        const bool said = result.labels(x, y) == static_cast<int>(State::Moving);
        const double v = id ? view.speed.at(id) : 0;
        if (id) ++area[id], ++shared[{id, result.ids(x, y)}];
        if (v > 0 && v < min_speed) continue;
        both += said && v > 0, said_only += said && v == 0, truth_only += !said && v > 0;
      }
    for (const auto& [id, pixels] : area) {
      if (pixels < min_pixels || previous_area_[id] < min_pixels) continue;
      const double v = view.speed.at(id);
      if (v > 0 && v < min_speed) continue;
      const ObjectResult* best = nullptr;
      int most = pixels / 4;
      for (const ObjectResult& o : result.objects)
        if (const int n = shared[{id, o.id}]; n > most) most = n, best = &o;
      const bool moving = best && best->state == State::Moving;
      if (v > 0) {
        moving ? ++true_moving : ++missed_moving;
      } else {
        ++parked_frames;
        static_kept += best && best->state == State::Static;
        false_moving += moving;
        parked[id].first += moving, ++parked[id].second;
      }
    }
    previous_area_ = area;
    if (i > 0) {
      const SE3d truth = view.T_world_camera.inverse() * sample()[i - 1].T_world_camera;
      camera_cm.push_back(100 * (SE3d::from_row_major(result.camera.T_cur_prev).inverse() * truth).t.norm());
    }
  }

  void check() {
    ASSERT_GT(true_moving + missed_moving, 20);
    ASSERT_GE(parked.size(), 3u);
    const double f1 = 2.0 * true_moving / (2.0 * true_moving + false_moving + missed_moving);
    EXPECT_GE(f1, 0.9) << true_moving << " found, " << missed_moving << " missed, " << false_moving << " false";
    for (const auto& [id, share] : parked)
      EXPECT_LE(share.first, 0.05 * share.second) << "parked car " << id << " moving in " << share.first << " frames";
    EXPECT_GE(static_kept, 0.7 * parked_frames);
    EXPECT_GE(static_cast<double>(both) / (both + said_only + truth_only), 0.7);
    std::sort(camera_cm.begin(), camera_cm.end());
    EXPECT_LE(camera_cm[camera_cm.size() / 2], 1.0);
    EXPECT_LE(camera_cm.back(), 5.0);
  }

 private:
  std::map<int, int> previous_area_;
};

class MaskEvery : public testing::TestWithParam<int> {};

TEST_P(MaskEvery, IsAnsweredWell) {
  Tracker tracker(sample().camera, Sample::options());
  Score score;
  for (int i = 0; i < sample().size(); ++i) score.add(i, tracker.track(sample().frame(i, i % GetParam() == 0)));
  score.check();
}

INSTANTIATE_TEST_SUITE_P(Sample, MaskEvery, testing::Values(1, 4),
                         [](const auto& test) { return std::to_string(test.param); });

// The compiled tier and the template say the same. Compilers may round the two differently, so a pixel of an outline
// may differ.
TEST(Sample, TrackerAndDotAgree) {
  Tracker tracker(sample().camera, Sample::options());
  dot::Dot<> dot(dot::Pinhole(sample().camera), Sample::options());
  int pixels = 0, differ = 0;
  for (int i = 0; i < 14; ++i) {
    const dot::Frame frame = sample().frame(i, i % 2 == 0);
    const Result &a = tracker.track(frame), &b = dot.track(frame);
    ASSERT_EQ(a.objects.size, b.objects.size);
    EXPECT_EQ(a.camera.status, b.camera.status);
    for (std::size_t k = 0; k < a.objects.size; ++k) {
      EXPECT_EQ(a.objects[k].id, b.objects[k].id);
      EXPECT_EQ(a.objects[k].state, b.objects[k].state) << "frame " << i << " track " << a.objects[k].id;
      EXPECT_EQ(a.objects[k].reason, b.objects[k].reason) << "frame " << i << " track " << a.objects[k].id;
    }
    for (int y = 0; y < a.labels.height; ++y)
      for (int x = 0; x < a.labels.width; ++x)
        ++pixels, differ += a.labels(x, y) != b.labels(x, y) || a.ids(x, y) != b.ids(x, y);
  }
  EXPECT_LE(differ, pixels / 1000);
}

}  // namespace
