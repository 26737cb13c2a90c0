// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/camera_motion/fixed_parts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "dot/camera/pinhole.hpp"
#include "support/host_pool.hpp"
#include "support/synthetic_scene.hpp"

namespace {

using dot::CameraStatus;
using dot::CameraStep;
using dot::FixedParts;
using dot::Image;
using dot::Vector3;
using dot::test::small_camera;
using dot::test::Texture;

constexpr int kWidth = 320, kHeight = 240, kFirstFixedRow = 190;
constexpr double kFocal = 200;

/// A wall before a camera that moves to the right, and a part of the image that stays.
struct Setting {
  double rate = 10;                ///< frames a second
  double speed = 0.6;              ///< m/s
  double distance = 4;             ///< metres, of the wall
  bool has_part = true;            ///< the lowest rows are fixed
  double part_distance = 1;        ///< metres, that the depth image has there
  int first_row = kFirstFixedRow;  ///< of that part
  int end_row = kHeight;           ///< of that part
  int end_column = kWidth;         ///< of that part
  bool is_striped = false;         ///< that part has edges along the rows alone, which stay though it moves
  double measured = 1;             ///< the camera's motion, over that to the wall
  int repeats = 0;                 ///< FrameData::repeats of each frame
  int stands_every = 0;            ///< frames of which it is known of one that the camera stands; 0: of none
};

class Camera {
 public:
  explicit Camera(const Setting& chosen)
      : setting(chosen), camera_(small_camera()), background_(kWidth, kHeight), ids_(kWidth, kHeight) {
    background_.fill(255);
    ids_.fill(0);
  }

  Setting setting;
  FixedParts parts;
  dot::Threads threads;
  bool found = false;  ///< parts that held the camera, in any frame

  void drive(double seconds) {
    const int frames = static_cast<int>(std::lround(seconds * setting.rate));
    for (int i = 0; i < frames; ++i) next();
  }

  /// As of another recording.
  void set_clock_back() { time_ -= 1e6; }

  /// Share of the rows from `first` to `end` that is excluded.
  double excluded(int first, int end) const {
    const std::vector<std::uint8_t> all = pixels();
    const auto excluded = std::count(all.begin() + first * kWidth, all.begin() + end * kWidth, std::uint8_t{0});
    return static_cast<double>(excluded) / ((end - first) * kWidth);
  }
  /// By rows, 0 where they are excluded.
  std::vector<std::uint8_t> pixels() const {
    Image<std::uint8_t> mask(kWidth, kHeight);
    mask.fill(255);
    parts.exclude(mask);
    return {mask.row(0), mask.row(0) + kWidth * kHeight};
  }
  double of_part() const { return excluded(setting.first_row, kHeight); }
  double of_scene() const { return excluded(0, kFirstFixedRow - 16); }

 private:
  void next() {
    const double way = setting.speed / setting.rate;
    position_ += way, time_ += 1 / setting.rate;
    const int shift = static_cast<int>(std::lround(kSteps * position_ * kFocal / setting.distance));
    Image<std::uint8_t> grey(kWidth, kHeight);
    Image<float> q(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const bool fixed = setting.has_part && y >= setting.first_row && y < setting.end_row && x < setting.end_column;
        grey(x, y) = fixed ? part_(setting.is_striped ? 0 : x, y) : wall_((kSteps * x + shift) % wall_.width(), y);
        q(x, y) = static_cast<float>(1 / (fixed ? setting.part_distance : setting.distance));
      }
    frame_.timestamp = time_;
    frame_.repeats = setting.repeats;
    frame_.pyramid.build(std::as_const(grey).view(), 3);
    frame_.depth.build(
        kWidth, kHeight, [&](int y, float* out) { std::copy_n(q.row(y), kWidth, out); }, 3);
    CameraStep step;
    step.status = CameraStatus::Tracked;
    step.seconds = 1 / setting.rate;
    step.T_cur_prev = dot::SE3d::translation(Vector3<double>(-setting.measured * way, 0, 0));
    step.alignment.stands = setting.stands_every > 0 && frames_++ % setting.stands_every == 0;
    found |= parts.update(frame_, background_, ids_, step, camera_, dot::portable_kernels(), threads);
  }

  static constexpr int kSteps = 2;  ///< of the wall's image, a pixel

  /// @param step pixels from column to column.
  static Image<std::uint8_t> paint(unsigned seed, double step, int width) {
    const Texture texture(seed, 12, 100);
    Image<std::uint8_t> out(width, kHeight);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < width; ++x) out(x, y) = static_cast<std::uint8_t>(texture(step * x, y));
    return out;
  }

  dot::Pinhole camera_;
  Image<std::uint8_t> background_;
  Image<std::uint32_t> ids_;
  dot::FrameData frame_;
  Image<std::uint8_t> wall_ = paint(1, 1.0 / kSteps, 2048), part_ = paint(2, 1, kWidth);
  double position_ = 0, time_ = 1000;
  int frames_ = 0;
};

TEST(FixedParts, AreFoundWhileTheSceneMovesAtAnyFrameRate) {
  for (const double rate : {5, 10, 30, 60}) {
    Setting setting;
    setting.rate = rate;
    Camera camera(setting);
    camera.drive(1);
    EXPECT_GT(camera.of_part(), 0.9) << rate;
    camera.drive(4);
    EXPECT_GT(camera.of_part(), 0.9) << rate;
    EXPECT_LT(camera.of_scene(), 0.01) << rate;
    EXPECT_NEAR(camera.parts.share(), 0.2, 0.03) << rate;
    EXPECT_FALSE(camera.found) << "the camera was not held";
  }
}

TEST(FixedParts, AreFoundThoughTheyHoldTheCamera) {
  Setting setting;
  setting.measured = 0;
  Camera camera(setting);
  camera.drive(3);
  EXPECT_TRUE(camera.found);
  EXPECT_GT(camera.of_part(), 0.9);
  EXPECT_LT(camera.of_scene(), 0.01);
}

// The wall is a lorry without a mask. The camera's motion is right and does not explain how the lorry moves. The edges
// of the road below are along its motion.
TEST(FixedParts, AreNotASceneInWhichALorryPasses) {
  for (const double measured : {0.0, 0.02}) {
    Setting setting;
    setting.measured = measured;
    setting.first_row = 120;
    setting.part_distance = 8;  // the scene behind it
    Camera camera(setting);
    camera.drive(3);
    EXPECT_FALSE(camera.found) << measured;
    EXPECT_EQ(camera.of_part(), 0) << measured;
    EXPECT_EQ(camera.parts.share(), 0) << measured;
  }
}

TEST(FixedParts, AreNotSuspectedForAWhileWhereTheCameraStood) {
  Setting setting;
  setting.measured = 0;
  setting.stands_every = 6;
  Camera camera(setting);
  camera.drive(3);
  EXPECT_FALSE(camera.found);
  EXPECT_EQ(camera.of_part(), 0);
  setting.stands_every = 1000;  // the first frame alone
  Camera held(setting);
  held.drive(5);
  EXPECT_TRUE(held.found);
}

TEST(FixedParts, AreNotWhatTheCameraPassesBesideAnotherMotion) {
  Setting setting;
  setting.measured = -1;
  setting.is_striped = true;
  Camera camera(setting);
  camera.drive(3);
  EXPECT_FALSE(camera.found);
  EXPECT_EQ(camera.of_part(), 0);
  setting.measured = 0;  // those of a bonnet may have held the camera
  Camera held(setting);
  held.drive(3);
  EXPECT_TRUE(held.found);
  EXPECT_GT(held.of_part(), 0.9);
}

TEST(FixedParts, AreNotInASceneThatMoves) {
  Setting setting;
  setting.has_part = false;
  Camera camera(setting);
  camera.drive(5);
  EXPECT_EQ(camera.excluded(0, kHeight), 0);
  EXPECT_EQ(camera.parts.share(), 0);
}

TEST(FixedParts, AreNotKnownToACameraThatStands) {
  Setting setting;
  setting.speed = 0;
  Camera camera(setting);
  camera.drive(10);
  EXPECT_EQ(camera.excluded(0, kHeight), 0);
}

// The lowest rows are as a far scene is to a camera that moves to the right.
TEST(FixedParts, AreNotWhatIsFar) {
  Setting setting;
  setting.part_distance = 1000;
  Camera camera(setting);
  camera.drive(5);
  EXPECT_EQ(camera.excluded(0, kHeight), 0);
  EXPECT_EQ(camera.parts.share(), 0);
}

TEST(FixedParts, AreRememberedWhileTheCameraStands) {
  Camera camera({});
  camera.drive(3);
  camera.setting.speed = 0;
  camera.drive(60);
  EXPECT_GT(camera.of_part(), 0.9);
  EXPECT_GT(camera.parts.share(), 0.15);
}

TEST(FixedParts, AreForgottenWhenTheyAreGone) {
  Camera camera({});
  camera.drive(3);
  ASSERT_GT(camera.of_part(), 0.9);
  camera.setting.has_part = false;
  camera.drive(3);
  EXPECT_EQ(camera.excluded(0, kHeight), 0);
  EXPECT_EQ(camera.parts.share(), 0);
}

TEST(FixedParts, AreNotLearntFromRepeatedImages) {
  Setting setting;
  setting.repeats = 1;
  Camera camera(setting);
  camera.drive(3);
  EXPECT_EQ(camera.excluded(0, kHeight), 0);
}

TEST(FixedParts, AreForgotten) {
  Camera camera({});
  camera.drive(3);
  ASSERT_GT(camera.of_part(), 0.9);
  camera.parts.forget();
  camera.set_clock_back();
  EXPECT_EQ(camera.excluded(0, kHeight), 0);
  EXPECT_EQ(camera.parts.share(), 0);
  camera.drive(0.1);
  EXPECT_EQ(camera.excluded(0, kHeight), 0);
  camera.drive(2);
  EXPECT_GT(camera.of_part(), 0.9);
}

// The bands of rows that the threads take may end in any order.
TEST(FixedParts, DoNotDependOnTheNumberOfThreads) {
  Setting bonnet, writing;
  writing.end_row = kFirstFixedRow + 16, writing.end_column = 80;
  for (const Setting& setting : {bonnet, writing}) {
    Camera alone(setting), shared(setting);
    shared.threads.count = 3, shared.threads.pool = dot::test::host_pool;
    for (int frame = 0; frame < 20; ++frame) {
      alone.drive(1 / setting.rate), shared.drive(1 / setting.rate);
      ASSERT_EQ(alone.parts.share(), shared.parts.share()) << "frame " << frame;
      ASSERT_EQ(alone.pixels(), shared.pixels()) << "frame " << frame;
    }
    EXPECT_GT(alone.excluded(kFirstFixedRow, kHeight), 0);
  }
}

// A line of writing over less than 2 % of the image is no part that could hold the camera.
TEST(Overlays, OfAnySizeAreExcluded) {
  Setting setting;
  setting.end_row = kFirstFixedRow + 16, setting.end_column = 80;
  Camera camera(setting);
  camera.drive(2);
  EXPECT_EQ(camera.parts.share(), 0);
  const auto excluded = [&] { return camera.excluded(kFirstFixedRow, setting.end_row) * kWidth / setting.end_column; };
  EXPECT_GT(excluded(), 0.8);
  EXPECT_EQ(camera.of_scene(), 0);
  EXPECT_LT(camera.excluded(setting.end_row + 8, kHeight), 0.01);
  camera.setting.speed = 0;
  camera.drive(10);
  EXPECT_GT(excluded(), 0.8) << "though the camera stands";
  camera.setting.speed = setting.speed, camera.setting.has_part = false;
  camera.drive(3);
  EXPECT_EQ(excluded(), 0) << "though it is gone";
  camera.setting.has_part = true, camera.setting.part_distance = 1000;  // something far, which stays as well
  camera.drive(3);
  EXPECT_EQ(excluded(), 0) << "of another thing";
}

TEST(FixedParts, AreNoneInAnImageThatIsTooSmall) {
  dot::FrameData frame;
  frame.pyramid.levels.resize(1);
  frame.depth.levels.resize(1);
  frame.pyramid.levels[0] = Image<std::uint8_t>(5, 5);
  frame.depth.levels[0] = Image<float>(5, 5);
  Image<std::uint8_t> background(5, 5);
  FixedParts parts;
  for (int i = 0; i < 10; ++i) {
    frame.timestamp = i;
    EXPECT_FALSE(parts.update(frame, background, Image<std::uint32_t>(5, 5), {}, dot::Pinhole(small_camera()),
                              dot::portable_kernels(), dot::Threads{}));
  }
  parts.exclude(background);
  EXPECT_EQ(parts.share(), 0);
}

}  // namespace
