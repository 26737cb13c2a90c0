// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/diagnosis/watch.hpp"

#include <gtest/gtest.h>

#include <cstdint>

#include "dot/camera/depth_noise.hpp"

namespace {

using dot::Diagnosis;
using dot::Suspicion;

constexpr int kWidth = 320, kHeight = 240;
constexpr int kSpeeds[] = {3, 5, 7, 9, 11, 13, 15, 17, 19, 21};  // pixels a frame

/// Bars 3 m away before a wall 10 m away, in ten bands of rows, each with a speed of its own: with one speed for all,
/// depth that is late would be depth that is shifted.
dot::FrameData scene(int frame, double scale = 1) {
  dot::FrameData out;
  out.pyramid.levels.resize(1);
  out.depth.levels.resize(1);
  auto& image = out.pyramid.levels[0];
  auto& inverse_depth = out.depth.levels[0];
  image.resize(kWidth, kHeight);
  inverse_depth.resize(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const int band = y / 24;
      const int place = x + kSpeeds[band] * frame, bar = (place + 13 * band) % 80;
      const bool near = bar < 30;
      const int texture = (place * 2654435761u + static_cast<unsigned>(y) * 40503u) >> 16 & 7;
      image(x, y) = static_cast<std::uint8_t>((near ? 160 : 80) + texture);
      inverse_depth(x, y) = static_cast<float>((near ? 1.0 / 3 : 0.1) / scale);
    }
  return out;
}

struct Setting {
  double seconds = 0.1;
  int depth_late = 0;
  int repeat_every = 0;
  double scale = 1;
  bool few_points = false;
  bool no_depth = false;
  dot::Noticed noticed;
};

Diagnosis look(const Setting& setting, int frames = 40) {
  dot::Watch watch;
  const dot::DepthNoise noise(dot::DepthNoiseSettings{}, dot::Intrinsics{300, 300, 160, 120, kWidth, kHeight, 0});
  Diagnosis last;
  for (int i = 0; i < frames; ++i) {
    const bool again = setting.repeat_every > 0 && i % setting.repeat_every == 1;
    dot::FrameData frame = scene(100 + (again ? i - 1 : i), setting.scale);
    frame.repeats = again;
    frame.depth.levels[0] = scene(100 + (again ? i - 1 : i) - setting.depth_late, setting.scale).depth.levels[0];
    if (setting.no_depth) frame.depth.levels[0].fill(0);
    last = watch.update(frame, noise, i > 0 ? setting.seconds : 0, 1, setting.few_points, setting.noticed);
  }
  return last;
}

TEST(Watch, SuspectsNothingOfGoodInput) {
  EXPECT_EQ(look({}).reason, Suspicion::None);
  EXPECT_EQ(look({}).figure, 0);
}

TEST(Watch, NoticesDepthOfAnotherFrame) {
  for (const int late : {-2, -1, 1, 2}) {
    Setting setting;
    setting.depth_late = late;
    EXPECT_EQ(look(setting).reason, Suspicion::DepthOutOfStep) << late;
    EXPECT_EQ(look(setting).figure, late);
  }
}

TEST(Watch, PassesOnWhatTheStagesNoticeTheGravestFirst) {
  const auto expect = [](const Setting& setting, Suspicion reason, double figure) {
    EXPECT_EQ(look(setting).reason, reason);
    EXPECT_EQ(look(setting).figure, figure);
  };
  Setting setting;
  setting.noticed.scale_sigma = 0.005;  // as of a sensor
  expect(setting, Suspicion::None, 0);
  setting.noticed.scale_sigma = 0.02;
  expect(setting, Suspicion::UnsteadyScale, 0.02);
  setting.noticed.row_turn = 0.03;
  expect(setting, Suspicion::RollingShutter, 0.03);
  setting.noticed.distortion = 12;
  expect(setting, Suspicion::LensDistortion, 12);
  setting.noticed.fixed = 0.2;
  expect(setting, Suspicion::FixedPart, 0.2);
  setting.noticed.host_error = 40;
  expect(setting, Suspicion::HostMotion, 40);
  setting.depth_late = 1;
  expect(setting, Suspicion::DepthOutOfStep, 1);
}

TEST(Watch, NoticesTimesThatAreNoSeconds) {
  Setting setting;
  setting.seconds = 100;
  EXPECT_EQ(look(setting).reason, Suspicion::ImplausibleTimes);
  EXPECT_EQ(look(setting).figure, 100);
  setting.seconds = 1e-4;
  EXPECT_EQ(look(setting).reason, Suspicion::ImplausibleTimes);
}

TEST(Watch, NoticesRepeatedImages) {
  Setting setting;
  setting.repeat_every = 4;
  EXPECT_EQ(look(setting).reason, Suspicion::RepeatedImages);
  EXPECT_NEAR(look(setting).figure, 0.25, 0.07);
}

TEST(Watch, TakesOneRepeatedImageForAnAccident) {
  dot::Watch watch;
  const dot::DepthNoise noise(dot::DepthNoiseSettings{}, dot::Intrinsics{300, 300, 160, 120, kWidth, kHeight, 0});
  for (int i = 0; i < 30; ++i) {
    dot::FrameData frame = scene(100 + i);
    frame.repeats = i == 3;
    EXPECT_EQ(watch.update(frame, noise, i > 0 ? 0.1 : 0, 1, false).reason, Suspicion::None) << i;
  }
}

// Without noise, all images of a camera that stands are the same. A driver that hangs repeats its last one for longer.
TEST(Watch, TellsAnImageThatStaysFromACameraThatStandsForAWhile) {
  dot::Watch watch;
  const dot::DepthNoise noise(dot::DepthNoiseSettings{}, dot::Intrinsics{300, 300, 160, 120, kWidth, kHeight, 0});
  for (int i = 0; i < 90; ++i) {
    const int stood = i < 16 ? i : i < 60 ? 0 : i - 59, moved = i < 16 ? 0 : i < 60 ? i - 15 : 44;
    dot::FrameData frame = scene(100 + moved);
    frame.repeats = stood;
    const dot::Diagnosis diagnosis = watch.update(frame, noise, i > 0 ? 0.1 : 0, 1, false);
    EXPECT_EQ(diagnosis.reason, stood < 16 ? Suspicion::None : Suspicion::RepeatedImages) << i;
    EXPECT_EQ(diagnosis.figure, stood < 16 ? 0 : 1) << i;
  }
}

TEST(Watch, NoticesDepthOfAnotherUnit) {
  Setting setting;
  setting.scale = 100;
  EXPECT_EQ(look(setting).reason, Suspicion::ImplausibleDepth);
  EXPECT_GT(look(setting).figure, 150);
}

TEST(Watch, TellsLittleTextureFromLittleDepth) {
  Setting setting;
  setting.few_points = true;
  EXPECT_EQ(look(setting).reason, Suspicion::TooLittleTexture);
  EXPECT_EQ(look(setting).figure, 1);
  setting.no_depth = true;
  EXPECT_EQ(look(setting).reason, Suspicion::TooLittleDepth);
  EXPECT_EQ(look(setting).figure, 0);
}

// A lidar that is slower than the camera: the frames with depth have enough of everything.
TEST(Watch, NoticesMasksThatLeaveNoBackground) {
  Setting setting;
  setting.noticed.masked = 0.97;
  EXPECT_EQ(look(setting).reason, Suspicion::None) << "there are points beside them";
  setting.few_points = true;
  EXPECT_EQ(look(setting).reason, Suspicion::MasksCoverImage);
  EXPECT_EQ(look(setting).figure, 0.97);
  setting.noticed.masked = 0.3;
  EXPECT_EQ(look(setting).reason, Suspicion::TooLittleTexture);
  setting.noticed.masked = 0.97;
  setting.no_depth = true;
  EXPECT_EQ(look(setting).reason, Suspicion::TooLittleDepth);
}

TEST(Watch, TellsLittleTextureFromDepthThatComesWithSomeFrames) {
  dot::Watch watch;
  const dot::DepthNoise noise(dot::DepthNoiseSettings{}, dot::Intrinsics{300, 300, 160, 120, kWidth, kHeight, 0});
  for (int i = 0; i < 40; ++i) {
    dot::FrameData frame = scene(100 + i);
    const bool without = i % 3 != 0;
    if (without) frame.depth.levels[0].fill(0);
    const Diagnosis diagnosis = watch.update(frame, noise, i > 0 ? 0.1 : 0, 1, without);
    if (i < 20) continue;
    EXPECT_EQ(diagnosis.reason, Suspicion::TooLittleDepth) << i;
    EXPECT_EQ(diagnosis.figure, 0) << i;
  }
}

TEST(Watch, NoticesDepthThatIsCutOff) {
  Setting setting;
  setting.noticed.saturated = 0.3;
  EXPECT_EQ(look(setting, 7).reason, Suspicion::None);
  EXPECT_EQ(look(setting).reason, Suspicion::SaturatedDepth);
  EXPECT_EQ(look(setting).figure, 0.3);
  setting.repeat_every = 4;
  EXPECT_EQ(look(setting).reason, Suspicion::RepeatedImages);
}

TEST(Watch, ForgetsOnRequest) {
  dot::Watch watch;
  const dot::DepthNoise noise(dot::DepthNoiseSettings{}, dot::Intrinsics{300, 300, 160, 120, kWidth, kHeight, 0});
  for (int i = 0; i < 20; ++i) watch.update(scene(i), noise, i > 0 ? 100 : 0, 1, false);
  EXPECT_EQ(watch.update(scene(20), noise, 100, 1, false).reason, Suspicion::ImplausibleTimes);
  watch.forget();
  EXPECT_EQ(watch.update(scene(21), noise, 0, 1, false).reason, Suspicion::None);
}

TEST(Watch, TakesImagesTooSmallToTell) {
  dot::FrameData small;
  small.pyramid.levels.resize(1);
  small.depth.levels.resize(1);
  small.pyramid.levels[0].resize(8, 8);
  small.depth.levels[0].resize(8, 8);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) small.pyramid.levels[0](x, y) = 100, small.depth.levels[0](x, y) = 0.5f;
  dot::Watch watch;
  const dot::DepthNoise noise(dot::DepthNoiseSettings{}, dot::Intrinsics{8, 8, 4, 4, 8, 8, 0});
  for (int i = 0; i < 20; ++i) EXPECT_EQ(watch.update(small, noise, i > 0 ? 0.1 : 0, 1, false).reason, Suspicion::None);
}

TEST(Suspicion, HasNames) {
  EXPECT_STREQ(dot::to_string(Suspicion::None), "");
  EXPECT_STREQ(dot::to_string(Suspicion::DepthOutOfStep), "depth_out_of_step");
  EXPECT_STREQ(dot::to_string(Suspicion::SaturatedDepth), "saturated_depth");
  EXPECT_STREQ(dot::to_string(Suspicion::FixedPart), "fixed_part");
  EXPECT_STREQ(dot::to_string(Suspicion::RollingShutter), "rolling_shutter");
  EXPECT_STREQ(dot::to_string(Suspicion::UnsteadyScale), "unsteady_scale");
  EXPECT_STREQ(dot::to_string(Suspicion::HostMotion), "host_motion");
  EXPECT_STREQ(dot::to_string(Suspicion::LensDistortion), "lens_distortion");
}

}  // namespace
