// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/camera_motion/camera_tracker.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <random>

#include "support/stage_film.hpp"

// The camera alone: no object, no label.

namespace {

using namespace dot::test;
using dot::CameraStatus;
using dot::CameraStep;
using dot::Image;
using dot::SE3d;
using dot::Vector3;

struct Drive : StageFilm {
  StageSetup setup;
  dot::CameraMotionEstimator estimator;
  dot::CameraTracker<dot::Pinhole, dot::DepthNoise, dot::DirectAligner<>> tracker;
  dot::ObjectWorkspace<dot::DirectAligner<>> workspace;
  dot::PaintedImage<std::uint8_t> labels;
  dot::Image<std::uint32_t> ids;
  bool enough = false;

  static Film<> scene() {
    Film<> film;
    film.camera_path = straight({0, 0, 0}, {0.2, 0, 1});
    film.degradation.noise = 1;
    return film;
  }
  Drive() : StageFilm(scene()), ids(camera.width(), camera.height()) {
    labels.clear(camera.width(), camera.height());
    ids.fill(0);
  }

  std::vector<const dot::PointSet*> objects;

  CameraStep next(const dot::HostMotion& host = {}) {
    advance();
    const double seconds = prev ? cur->timestamp - prev->timestamp : 0;
    CameraStep step =
        tracker.track(prev, *cur, seconds, host, objects, camera, estimator, workspace.aligner, workspace.minima);
    tracker.learn_depth(*cur, step, camera, {}, estimator.settings.min_points, setup.noise);
    tracker.find_fixed_parts(*cur, step, labels, ids, {}, camera, dot::portable_kernels(), dot::Threads{});
    const dot::Selector<dot::Pinhole, dot::DepthNoise> select{
        camera, setup.noise, cur->pyramid, cur->inverse_depth().view(), setup.selection, workspace.selection};
    enough = tracker.take_background(*cur, step, select, estimator.settings.min_points);
    return step;
  }
  double error(const CameraStep& step) const { return (step.T_cur_prev * film.T_c().inverse()).log().norm(); }
};

TEST(CameraTracker, MeasuresTheMotionBetweenTwoFrames) {
  Drive drive;
  EXPECT_EQ(drive.next().status, CameraStatus::FirstFrame);
  EXPECT_TRUE(drive.enough);
  for (int i = 0; i < 3; ++i) {
    const CameraStep step = drive.next();
    ASSERT_EQ(step.status, CameraStatus::Tracked);
    EXPECT_LT(drive.error(step), 5e-3);
    EXPECT_NEAR(step.seconds, 0.1, kClockError);
    EXPECT_GT(step.covariance.trace(), 0);
  }
}

// A camera that is shaken: from frame to frame it turns by up to 5 degrees otherwise than before. From constant
// velocity the alignment ends in a wrong minimum, whose correlation is high enough to be accepted.
TEST(CameraTracker, FollowsJolts) {
  Drive drive;
  drive.film.camera_path = [](double t) {
    std::minstd_rand bits(static_cast<unsigned>(std::lround(10 * t)) + 3);
    bits.discard(5);
    std::uniform_real_distribution<double> angle(-0.045, 0.045);  // rad
    const Vector3<double> turn(angle(bits), angle(bits), angle(bits));
    return SE3d{dot::so3::exp(t < 0.25 ? Vector3<double>::Zero().eval() : turn), {0.2 * t, 0, t}};
  };
  for (int i = 0; i < 20; ++i) {
    const CameraStep step = drive.next();
    if (i == 0) continue;
    ASSERT_EQ(step.status, CameraStatus::Tracked) << i;
    EXPECT_LT(drive.error(step), 5e-3) << i << ": correlation " << step.alignment.phi;
  }
}

TEST(CameraTracker, TakesTheHostsMotion) {
  Drive drive;
  drive.next();
  dot::CameraMotion motion;
  motion.T_cur_prev = SE3d::translation({-0.02, 0, -0.1}).row_major();
  motion.covariance[0] = 1e-4;
  const CameraStep step = drive.next({motion, std::nullopt});
  EXPECT_EQ(step.status, CameraStatus::FromHost);
  EXPECT_EQ(step.T_cur_prev.t, Vector3<double>(-0.02, 0, -0.1));
  EXPECT_EQ(step.covariance(0, 0), 1e-4);
  EXPECT_EQ(drive.tracker.host_error(), 0);
}

dot::CameraMotion host_motion(const SE3d& T_cur_prev, double sigma_metres, double sigma_radians) {
  dot::CameraMotion motion;
  motion.T_cur_prev = T_cur_prev.row_major();
  for (std::size_t k = 0; k < 6; ++k) {
    const double sigma = k < 3 ? sigma_metres : sigma_radians;
    motion.covariance[7 * k] = sigma * sigma;
  }
  return motion;
}

// The film moves by (0.02, 0, 0.1) m a frame.
TEST(CameraTracker, DoesNotTakeAMotionThatTheImageRefutes) {
  const SE3d right = SE3d::translation({-0.02, 0, -0.1});
  dot::Vector6<double> off;
  off << 0.01, 0, 0, 0, 0.01, 0;
  const SE3d wrong[] = {
      right.inverse(),                     // T_prev_cur
      SE3d::translation({-0.1, 0.02, 0}),  // axes of a body: ahead, left, up
      SE3d::translation({-20, 0, -100}),   // millimetres
      SE3d::exp(off) * right,              // rough odometry
  };
  for (const SE3d& T : wrong) {
    Drive drive;
    drive.next();
    for (int i = 0; i < 3; ++i) {
      const CameraStep step = drive.next({host_motion(T, 1e-4, 1e-5), std::nullopt});
      ASSERT_EQ(step.status, CameraStatus::Tracked) << T.t.transpose() << ", " << i;
      EXPECT_LT(drive.error(step), 5e-3);
      EXPECT_GT(drive.tracker.host_error(), 0.5);
      EXPECT_LE(drive.tracker.host_error(), drive.camera.width());
    }
    EXPECT_EQ(drive.next({host_motion(drive.film.T_c(), 1e-3, 1e-4), std::nullopt}).status, CameraStatus::FromHost);
    EXPECT_EQ(drive.tracker.host_error(), 0) << "of the last interval alone";
  }
}

TEST(CameraTracker, TakesARoughMotionWhoseCovarianceSaysSo) {
  dot::Vector6<double> off;
  off << 0.01, 0, 0, 0, 0.01, 0;
  Drive drive;
  drive.next();
  const dot::CameraMotion rough = host_motion(SE3d::exp(off) * SE3d::translation({-0.02, 0, -0.1}), 0.01, 0.01);
  EXPECT_EQ(drive.next({rough, std::nullopt}).status, CameraStatus::FromHost);
}

// Whatever fills the image: a camera that is mounted for good does not move.
TEST(CameraTracker, TakesThatACameraIsMounted) {
  Drive drive;
  drive.next();
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(drive.next({dot::CameraMotion{}, std::nullopt}).status, CameraStatus::FromHost) << i;
  EXPECT_EQ(drive.next({host_motion(SE3d{}, 1e-4, 1e-5), std::nullopt}).status, CameraStatus::Tracked);
}

TEST(CameraTracker, GuessesWithoutPoints) {
  Drive drive;
  drive.film.spoil = [](int, Rendering& seen) { seen.depth.fill(0); };
  drive.next();
  EXPECT_FALSE(drive.enough);
  const CameraStep step = drive.next();
  EXPECT_EQ(step.status, CameraStatus::TooLittleDepth);
  EXPECT_FALSE(step.known());
  const double metres = drive.estimator.settings.search_speed * step.seconds;
  EXPECT_NEAR(step.covariance(0, 0), metres * metres / 3, 1e-9) << "nothing is known but its limits";
}

TEST(CameraTracker, GoesOnWithOlderPointsOverAFrameWithoutDepth) {
  Drive drive;
  drive.next();
  drive.next();
  drive.film.spoil = [](int, Rendering& seen) { seen.depth.fill(0); };
  CameraStep step = drive.next();
  EXPECT_EQ(step.status, CameraStatus::Tracked) << "the points are of the frame before";
  EXPECT_FALSE(drive.enough);
  step = drive.next();
  EXPECT_EQ(step.status, CameraStatus::Tracked) << "and serve once more";
  EXPECT_LT(drive.error(step), 1e-2);
  EXPECT_TRUE(drive.tracker.is_sure());
}

TEST(CameraTracker, WhatFollowsAGuessIsAsUnsureAsThatGuess) {
  Drive drive;
  drive.next();
  const CameraStep good = drive.next();
  drive.film.spoil = [](int, Rendering& seen) { seen.depth.fill(0); };
  drive.estimator.settings.min_phi = drive.estimator.settings.min_phi_unexpected = 2;  // nothing is good enough
  EXPECT_EQ(drive.next().status, CameraStatus::Lost);
  EXPECT_FALSE(drive.tracker.is_sure());
  drive.estimator = {};
  drive.film.spoil = nullptr;
  CameraStep step = drive.next();
  ASSERT_EQ(step.status, CameraStatus::Tracked);
  EXPECT_GT(step.covariance.trace(), 1e3 * good.covariance.trace());
  EXPECT_TRUE(drive.tracker.is_sure()) << "from here on there are new points";
  step = drive.next();
  EXPECT_LT(step.covariance.trace(), 10 * good.covariance.trace());
}

// At 18 m/s a camera that is taken to stand after a repeated image is out of the reach of its alignment. After it the
// motion is that since the last new image if the scene went on meanwhile, or that of one interval if an image was
// inserted.
TEST(CameraTracker, GoesOnAtItsVelocityAfterARepeatedImage) {
  for (const bool inserted : {false, true}) {
    Drive drive;
    int shown = 0;
    const auto path = straight({0, 0, 0}, {10, 0, 15});
    drive.film.camera_path = [&](double t) { return inserted ? path(0.1 * shown) : path(t); };
    Image<std::uint8_t> image;
    Image<float> depth;
    SE3d T_world_last;
    for (int i = 0; i < 7; ++i) {
      const bool repeats = i % 4 == 3;
      if (!repeats) ++shown;
      drive.film.spoil = [&](int, Rendering& seen) {
        if (repeats) seen.grey = image, seen.depth = depth;
        image = seen.grey, depth = seen.depth;
      };
      const CameraStep step = drive.next();
      if (repeats) continue;
      const SE3d T_world_cur = drive.film.T_world_camera();
      if (i > 0) {
        ASSERT_EQ(step.status, CameraStatus::Tracked) << i;
        const SE3d T_c = T_world_cur.inverse() * T_world_last;
        EXPECT_LT((step.T_cur_prev * T_c.inverse()).log().norm(), 0.02) << i << ", inserted: " << inserted;
      }
      T_world_last = T_world_cur;
    }
  }
}

/// A road of little contrast, and a wall far ahead, of which most of the image stays where it is.
dot::test::Body road(unsigned seed) {
  using V = Vector3<double>;
  dot::test::Body body;
  body.quads.push_back({V(0, 2, 60), V(60, 0, 0), V(0, 0, 60), dot::test::Texture(seed, 1, 6, 10)});
  body.quads.push_back({V(0, -38, 120), V(200, 0, 0), V(0, 40, 0), dot::test::Texture(seed + 1, 8, 60)});
  return body;
}

// Except for its noise the recording begins with one image several times, as from a camera that stands. A motion that
// is much shorter than the one that follows explains the image nearly as well, and is nearer to standing.
TEST(CameraTracker, IsNotHeldByAFirstImageThatRepeats) {
  for (const int times : {2, 3, 5})
    for (const double speed : {0.2, 1.0, 3.0, 10.0, 15.0, 25.0, 35.0}) {
      Drive drive;
      const auto path = straight({0, 0, 0}, {0, 0, speed});
      drive.film.camera_path = [&](double t) { return path(std::max(0.0, t - 0.1 * (times - 1))); };
      drive.film.direct = [](int, dot::test::Scene& scene) { scene.bodies.front() = road(100); };
      for (int i = 0; i < times; ++i) drive.next();
      for (int i = 0; i < 3; ++i) {
        const CameraStep step = drive.next();
        EXPECT_EQ(step.status, CameraStatus::Tracked) << times << " times, " << speed << " m/s";
        EXPECT_LT(drive.error(step), 0.03) << times << " times, " << speed << " m/s, motion " << i;
      }
    }
}

/// A drive whose frame `index` has the image and depth of the one before.
Drive repeating(int index) {
  Drive drive;
  drive.film.spoil = [=, grey = Image<std::uint8_t>(), depth = Image<float>()](int i, Rendering& seen) mutable {
    if (i == index) seen.grey = grey, seen.depth = depth;
    grey = seen.grey, depth = seen.depth;
  };
  return drive;
}

// The host's motion is that of its interval, also after a repeated image.
TEST(CameraTracker, TakesTheHostsVelocityAfterARepeatedImage) {
  Drive drive = repeating(1);
  drive.next();
  EXPECT_EQ(drive.next().status, CameraStatus::Tracked);
  dot::CameraMotion motion;
  motion.T_cur_prev = SE3d::translation({-1, 0, -1.5}).row_major();
  drive.next({motion, std::nullopt});
  drive.estimator.settings.min_phi = drive.estimator.settings.min_phi_unexpected = 2;  // nothing is good enough
  const CameraStep step = drive.next();
  EXPECT_EQ(step.status, CameraStatus::Lost);
  EXPECT_LT((step.T_cur_prev.t - Vector3<double>(-1, 0, -1.5)).norm(), 1e-4);
}

// Nothing is known of the camera's motion since the last new image.
TEST(CameraTracker, AGuessAfterARepeatedImageIsAsUnsureAsBothIntervals) {
  Drive drive = repeating(2);
  for (int i = 0; i < 3; ++i) drive.next();
  drive.estimator.settings.min_phi = drive.estimator.settings.min_phi_unexpected = 2;
  const CameraStep step = drive.next();
  EXPECT_EQ(step.status, CameraStatus::Lost);
  const double metres = drive.estimator.settings.search_speed * 2 * step.seconds;
  EXPECT_NEAR(step.covariance(0, 0), metres * metres / 3, 1e-4 * metres * metres);
}

// A guess shows the velocity: that of the new images if the scene went on meanwhile, or that of the frames.
TEST(CameraTracker, KnowsWhetherARepeatedImageWasInserted) {
  for (const bool inserted : {false, true}) {
    Drive drive = repeating(3);
    const auto path = straight({0, 0, 0}, {2, 0, 3});
    drive.film.camera_path = [&](double t) { return path(inserted && t > 0.25 ? t - 0.1 : t); };
    for (int i = 0; i < 5; ++i) drive.next();
    drive.estimator.settings.min_phi = drive.estimator.settings.min_phi_unexpected = 2;
    const CameraStep step = drive.next();
    EXPECT_EQ(step.status, CameraStatus::Lost);
    EXPECT_LT((step.T_cur_prev.t - Vector3<double>(-0.2, 0, -0.3)).norm(), 0.02) << "inserted: " << inserted;
  }
}

// The edge of a picture in a black border has depth and stays. At 20 m/s it is what fits best.
TEST(CameraTracker, IsNotHeldByABlackBorder) {
  Drive drive;
  drive.film.camera_path = straight({0, 0, 0}, {0, 0, 20});
  drive.film.spoil = [](int, Rendering& seen) {
    constexpr int kBars = 60;  // rows
    for (int y = 0; y < seen.grey.height(); ++y) {
      if (y >= kBars && y < seen.grey.height() - kBars) continue;
      for (int x = 0; x < seen.grey.width(); ++x) seen.grey(x, y) = 2, seen.depth(x, y) = 0;
    }
  };
  drive.next();
  for (int i = 0; i < 5; ++i) {
    const CameraStep step = drive.next();
    ASSERT_EQ(step.status, CameraStatus::Tracked) << i;
    EXPECT_LT(drive.error(step), 0.02) << i;
  }
}

TEST(CameraTracker, HasNoPointsWhereObjectsAre) {
  Drive drive;
  drive.labels.image().fill(1);
  drive.labels.add({0, 0, drive.camera.width(), drive.camera.height()});
  drive.next();
  EXPECT_FALSE(drive.enough);
}

TEST(CameraTracker, ForgetsTheFrames) {
  Drive drive;
  drive.next();
  drive.next();
  drive.tracker.forget_frames();
  EXPECT_EQ(drive.next().status, CameraStatus::TooLittleDepth);
}

}  // namespace
