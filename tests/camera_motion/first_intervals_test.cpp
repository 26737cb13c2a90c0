// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// A first motion that was wrong is found again when the next one contradicts it.

#include "dot/camera_motion/first_intervals.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "dot/tracker.hpp"
#include "support/exact_points.hpp"
#include "support/lorry.hpp"
#include "support/stage_film.hpp"

namespace {

using dot::CameraRevision;
using dot::ObjectResult;
using dot::Options;
using dot::PointSet;
using dot::Result;
using dot::SE3d;
using dot::State;
using dot::Tracker;
using namespace dot::test;

double error(const std::array<double, 12>& T_cur_prev, const SE3d& truth) {
  return (SE3d::from_row_major(T_cur_prev).t - truth.t).norm();
}

/// The frame from which on the network sees the lorry.
class WrongFirstMotion : public testing::TestWithParam<int> {
 protected:
  Film<> film = behind_a_lorry(straight({0, 0, 0}, {0, 0, 3}), GetParam());
};

TEST_P(WrongFirstMotion, IsRevisedOnceTheLorryHasItsMask) {
  const int masked = GetParam();
  Tracker tracker(small_camera(), Options{});
  for (int i = 0; i < 8; ++i) {
    const Result& result = film.next(tracker);
    if (i > 0 && i <= masked) {
      ASSERT_GT(error(result.camera.T_cur_prev, film.T_c()), 0.3) << "the scene is too easy, frame " << i;
      EXPECT_TRUE(result.revised.empty());
      continue;
    }
    if (i == 0) continue;
    EXPECT_LT(error(result.camera.T_cur_prev, film.T_c()), 0.01) << i;
    ASSERT_EQ(result.revised.size, i == masked + 1 ? static_cast<std::size_t>(masked) : 0) << i;
    for (int k = 0; k < masked && !result.revised.empty(); ++k) {
      const CameraRevision& revised = result.revised[static_cast<std::size_t>(k)];
      EXPECT_EQ(revised.frame_id, static_cast<std::uint64_t>(k + 1));
      EXPECT_DOUBLE_EQ(revised.timestamp, film.epoch + film.interval * (k + 1));
      EXPECT_LT(error(revised.T_cur_prev, film.T_c()), 0.02) << k;
      for (int axis = 0; axis < 3; ++axis) {
        const auto at = static_cast<std::size_t>(axis);
        EXPECT_LT(std::abs(revised.T_cur_prev[4 * at + 3] - film.T_c().t[axis]),
                  4 * std::sqrt(revised.covariance[7 * at]))
            << k << ", axis " << axis;
      }
    }
    for (const ObjectResult& o : result.objects) {
      EXPECT_NE(o.state, o.instance_id == kLorry ? State::Static : State::Moving) << o.instance_id << " in frame " << i;
      if (i > masked + 2) {
        EXPECT_EQ(o.state, o.instance_id == kLorry ? State::Moving : State::Static) << o.instance_id << " in " << i;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(MaskedFrom, WrongFirstMotion, testing::Values(1, 2, 3));

// A camera that does change its velocity in no time, as over a kerb: the motions before were right.
TEST(RightFirstMotion, IsNotRevised) {
  for (const int jerk : {2, 3, 4}) {
    Film<> film = behind_a_lorry(
        [jerk](double t) {
          const double jump = t > 0.1 * jerk - 0.05 ? 0.4 : 0;
          return SE3d::translation(dot::Vector3<double>(0, 0, 3 * t + jump));
        },
        0);
    Tracker tracker(small_camera(), Options{});
    for (int i = 0; i < 8; ++i) {
      const Result& result = film.next(tracker);
      EXPECT_TRUE(result.revised.empty()) << "jerk " << jerk << ", frame " << i;
      if (i > 0) {
        EXPECT_LT(error(result.camera.T_cur_prev, film.T_c()), 0.01) << "jerk " << jerk << ", frame " << i;
      }
    }
  }
}

// The recording begins with one image twice, so that the camera seems to stand. A lorry without a mask that goes on
// ahead at the camera's speed then seems to be what a camera at that velocity sees.
TEST(FirstMotion, AfterAnImageTwiceIsNotThatOfALorryAhead) {
  for (const double faster : {0.0, 1.0})
    for (const double half_width : {2.0, 2.4}) {
      const auto late = [](const dot::Vector3<double>& from, const dot::Vector3<double>& velocity) {
        return [path = straight(from, velocity)](double t) { return path(std::max(0.0, t - 0.1)); };
      };
      constexpr double kSpeed = 10;  // m/s
      const double height = 0.8 * half_width;
      Film<> film;
      film.camera_path = late({0, 0, 0}, {0, 0, kSpeed});
      film.degradation.noise = 1;
      film.add(1, straight({-4.2, 1.3, 9}));
      film.add(2, straight({-4.6, 1.3, 14}));
      film.add(box(kLorry, {half_width, height, 2}, 77, 0.25, 1.2),
               late({1, 2 - height, 9}, {0.2, 0, kSpeed + faster}));
      film.spoil = [](int, Rendering& seen) {
        for (int y = 0; y < seen.ids.height(); ++y)
          for (int x = 0; x < seen.ids.width(); ++x)
            if (seen.ids(x, y) == kLorry) seen.ids(x, y) = 0;
      };
      Tracker tracker(small_camera(), Options{});
      film.next(tracker);
      film.next(tracker);
      for (int i = 2; i < 5; ++i) {
        const Result& result = film.next(tracker);
        EXPECT_LT(error(result.camera.T_cur_prev, film.T_c()), 0.02)
            << i << ", half width " << half_width << ", faster by " << faster;
      }
    }
}

/// Two intervals behind the lorry, which is part of the background. Their motions are measured by all points, by those
/// beside the lorry or by those on it.
struct TwoIntervals : StageFilm {
  enum class By { Lorry, Rest };
  dot::CameraMotionEstimator estimator;
  dot::DirectAligner<> aligner;
  dot::MinimaWorkspace workspace;
  dot::FirstIntervals intervals;

  TwoIntervals() : StageFilm(behind_a_lorry(straight({0, 0, 0}, {0, 0, 3}), 0)) { advance(); }

  /// The points of the present frame.
  PointSet points(const std::function<bool(std::uint32_t)>& accept) const {
    return exact_points(
        film.truth(), camera, cur->pyramid, 4, [&](int x, int y) { return accept(film.truth().ids(x, y)); }, 0.001f);
  }

  /// The next frame, and the step to it. @param masked the background has no other points than the measured ones.
  dot::CameraStep next(By by, bool masked, dot::Background& background) {
    const PointSet measured = points([by](std::uint32_t id) { return (id == kLorry) == (by == By::Lorry); });
    background = {};
    background.points = masked ? measured : points([](std::uint32_t) { return true; });
    advance();
    const std::vector<const PointSet*> no_objects;
    dot::CameraStep step = camera_step;
    const SE3d T_o = by == By::Lorry ? film.T_o(kLorry) : SE3d{};
    step.alignment = estimator.estimate(measured, cur->pyramid, camera, {film.T_c() * T_o}, nullptr, {no_objects, {}},
                                        aligner, workspace);
    step.status = dot::CameraStatus::Tracked;
    step.T_cur_prev = step.alignment.state.T;
    return step;
  }

  /// @param masked as above, of the second interval.
  std::vector<dot::RevisedInterval> revised(By first, By second, bool masked) {
    dot::Background background;
    const dot::CameraStep one = next(first, false, background);
    intervals.add(background, one, true);
    intervals.keep_frame(cur);
    const dot::CameraStep two = next(second, masked, background);
    std::vector<dot::RevisedInterval> out;
    intervals.revise(background, *cur, two, camera, estimator, aligner, workspace, out);
    return out;
  }
};

// Two velocities that contradict each other, and some of the background moves at the first one in both intervals: it is
// not certain which of them is the wrong one.
TEST(FirstIntervals, AreNotRevisedWhereTheNewestMotionMayBeTheWrongOne) {
  using By = TwoIntervals::By;
  EXPECT_TRUE(TwoIntervals{}.revised(By::Rest, By::Lorry, false).empty());
  EXPECT_TRUE(TwoIntervals{}.revised(By::Lorry, By::Rest, false).empty());
  EXPECT_EQ(TwoIntervals{}.revised(By::Lorry, By::Rest, true).size(), 1u)
      << "nothing speaks for the first one any more";
}

}  // namespace
