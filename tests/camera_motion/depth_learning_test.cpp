// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/camera_motion/depth_learning.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "dot/camera/pinhole.hpp"
#include "support/random.hpp"

namespace {

using dot::DepthLearning;
using dot::DepthNoise;
using dot::DepthSource;
using dot::Image;
using dot::SE3d;
using dot::Vector3;
using dot::test::Random;

constexpr int kColumns = 16, kRows = 16;   // patches of the image
constexpr double kWall = 10, kGround = 2;  // metres ahead of the world's origin, and below it

dot::Intrinsics intrinsics(double baseline) { return {400, 400, 319.5, 239.5, 640, 480, baseline}; }
const dot::Pinhole camera(intrinsics(0));

DepthNoise noise_of(DepthSource source, double baseline = 0.2) {
  dot::DepthNoiseSettings s;
  s.source = source;
  return {s, intrinsics(baseline)};
}

/// Errors of inverse depth, as multiples of what the prior says of each.
struct Errors {
  double common = 0, pixel = 0;
};

/// Errors that the pixels of a patch share, 1 sigma; a patch is (row, column).
using Shared = std::function<double(int, int)>;

/// Inverse depth of a wall and, if asked for, of the ground before it, from a place of a camera that does not turn.
Image<float> view(const Vector3<double>& place, bool ground, const Errors& errors, const Shared& shared,
                  const DepthNoise& noise, Random& random) {
  Image<float> q(camera.width(), camera.height());
  for (int y = 0; y < q.height(); ++y)
    for (int x = 0; x < q.width(); ++x) {
      const Vector3<double> ray = camera.unproject(dot::Vector2<double>(x, y));
      double exact = 1 / (kWall - place.z());
      if (ground) exact = std::max(exact, ray.y() / (kGround - place.y()));
      double error = errors.pixel * noise.prior_pixel_sigma(exact) * random.normal();
      if (errors.common > 0)
        error += errors.common * noise.prior_shared_sigma(exact) *
                 shared(y / DepthLearning::kHeight, x / DepthLearning::kWidth);
      q(x, y) = static_cast<float>(exact + error);
    }
  return q;
}

/// A scale learnt from `frames` frames that each say v: the prior counts as one frame, a quarter is added.
double blended(double v, int frames) { return 1.25 * std::sqrt((frames * v * v + 1) / (frames + 1)); }

/// A wall that a stereo camera passes, 10 frames a second, each of them a whole number of pixels farther. With a patch
/// a frame, the errors that pixels share move on with the patches that they belong to. The long baseline makes errors
/// small beside the inverse depth: what is seen five frames later is still looked for in the same patch.
struct Drive {
  Errors errors;
  int pixels_per_frame = DepthLearning::kWidth;
  std::function<void(int, Image<float>&)> spoil;  ///< changes the inverse depth of a frame

  DepthNoise noise = noise_of(DepthSource::Stereo, 2);
  DepthLearning learning;

  void run(int frames) {
    Random random(7);
    Image<std::uint8_t> background(camera.width(), camera.height());
    background.fill(255);
    // Of each patch of the wall, the mean of three innovations: after three frames nothing is left of an error.
    using Layer = std::array<std::vector<double>, kRows>;
    std::vector<Layer> innovation(static_cast<std::size_t>(frames + 2));
    for (Layer& layer : innovation)
      for (std::vector<double>& row : layer)
        for (int c = 0; c < kColumns + frames; ++c) row.push_back(random.normal(1 / std::sqrt(3.0)));
    const SE3d T_cur_prev = SE3d::translation({-pixels_per_frame * kWall / camera.intrinsics().fx, 0, 0});
    for (int i = 0; i < frames; ++i) {
      const auto shared = [&](int row, int column) {
        const auto r = static_cast<std::size_t>(row);
        const auto c = static_cast<std::size_t>(column + i * pixels_per_frame / DepthLearning::kWidth);
        double sum = 0;
        for (int k = 0; k < 3; ++k) sum += innovation[static_cast<std::size_t>(i + k)][r][c];
        return sum;
      };
      Image<float> q = view(Vector3<double>::Zero(), false, errors, shared, noise, random);
      if (spoil) spoil(i, q);
      const double t = 0.1 * i;
      if (i > 0) learning.learn(camera, T_cur_prev, q, t, noise);
      learning.remember(camera, q, background, t);
    }
  }
};

/// Something nearer, at inverse depth q, in some columns of patches.
void cover(Image<float>& image, int first, int count, double q) {
  for (int y = 0; y < image.height(); ++y)
    for (int x = first * DepthLearning::kWidth; x < (first + count) * DepthLearning::kWidth; ++x)
      image(x, y) = static_cast<float>(q);
}

// Bounds: a frame has 180 to 240 patches, which know the 85 % quantile of a normal to 6 or 7 %; the median of twenty
// frames, one in three of which tells something new, to 4 %. Of 80 pixels the lower median of the distances to their
// own median is 2 to 3 % smaller than that of many.
TEST(DepthLearning, LearnsTheSizeOfEachError) {
  for (const Errors& errors : {Errors{0.5, 1}, Errors{1, 0.5}, Errors{2, 1.5}}) {
    SCOPED_TRACE(std::to_string(errors.common) + ", " + std::to_string(errors.pixel));
    Drive drive;
    drive.errors = errors;
    drive.run(27);
    // A third of an error is new in the next frame, all of it after three. The median of 80 pixels adds a little.
    const double of_pixels = std::sqrt(2 * 1.571 / 80) * errors.pixel * 0.3 / 0.2;
    const double change = std::hypot(std::sqrt(2.0 / 3) * errors.common, of_pixels);
    const double common = std::hypot(std::sqrt(2.0) * errors.common, of_pixels);
    EXPECT_NEAR(drive.noise.shared_drift_scale, blended(change, 20), 0.08 * blended(change, 20));
    EXPECT_NEAR(drive.noise.shared_scale, blended(common, 20), 0.08 * blended(common, 20));
    EXPECT_NEAR(drive.noise.pixel_scale, errors.pixel, 0.04 * errors.pixel);
  }
}

// The wall and the ground before it, whatever form the noise has. Each view with errors is followed by one without, so
// that errors of ground, which does not move on with the patches of the image, stay what they are.
TEST(DepthLearning, SlantedGroundCounts) {
  const Errors errors{1.5, 0.5};
  for (const DepthSource source : {DepthSource::Unknown, DepthSource::Stereo, DepthSource::Rgbd}) {
    SCOPED_TRACE(static_cast<int>(source));
    DepthNoise noise = noise_of(source);
    DepthLearning learning;
    Random random(3);
    Image<std::uint8_t> background(camera.width(), camera.height());
    // Ground alone: at 10 m it begins 80 pixels below the horizon.
    for (int y = 0; y < background.height(); ++y)
      for (int x = 0; x < background.width(); ++x) background(x, y) = y < 330 ? 0 : 255;
    const Vector3<double> way(0.3, 0, 0.05);
    for (int i = 0; i < 20; ++i) {
      std::array<double, kRows * kColumns> drawn{};
      for (double& d : drawn) d = random.normal();
      const auto shared = [&](int r, int c) { return drawn[static_cast<std::size_t>(r * kColumns + c)]; };
      learning.clear();
      learning.remember(camera, view(Vector3<double>::Zero(), true, errors, shared, noise, random), background, i);
      learning.learn(camera, SE3d::translation(-way), view(way, true, {0, errors.pixel}, {}, noise, random), i + 0.4,
                     noise);
    }
    EXPECT_NEAR(noise.shared_scale, blended(errors.common, 20), 0.1 * blended(errors.common, 20));
    EXPECT_NEAR(noise.shared_drift_scale, blended(errors.common, 20), 0.1 * blended(errors.common, 20));
    EXPECT_NEAR(noise.pixel_scale, errors.pixel, 0.05 * errors.pixel);
  }
}

TEST(DepthLearning, ACameraAtRestLearnsNothing) {
  Drive drive;
  drive.errors = {2, 2};
  drive.pixels_per_frame = 0;
  drive.noise.shared_drift_scale = drive.noise.shared_scale = drive.noise.pixel_scale = 3;
  drive.run(12);
  EXPECT_TRUE(drive.learning.change.said.empty());
  EXPECT_TRUE(drive.learning.common.said.empty());
  EXPECT_TRUE(drive.learning.pixel.said.empty());
  EXPECT_EQ(drive.noise.shared_drift_scale, 1);
  EXPECT_EQ(drive.noise.shared_scale, 1);
  EXPECT_EQ(drive.noise.pixel_scale, 1);
}

// One pixel a frame shows nothing new against the frame before, five do against the one half a second ago.
TEST(DepthLearning, ASlowCameraLearnsFromTheOlderFrame) {
  Drive drive;
  drive.errors = {1, 1};
  drive.pixels_per_frame = 1;
  drive.run(12);
  EXPECT_TRUE(drive.learning.change.said.empty());
  EXPECT_TRUE(drive.learning.pixel.said.empty());
  EXPECT_FALSE(drive.learning.common.said.empty());
  EXPECT_EQ(drive.noise.shared_drift_scale, 1);
  EXPECT_EQ(drive.noise.pixel_scale, 1);
}

// Clearly nearer, and so little nearer that its patches might be the wall's with a large error.
TEST(DepthLearning, OneFrameWithHalfTheImageHiddenDoesNotMoveTheScales) {
  Drive free;
  free.errors = {1, 1};
  free.run(20);
  for (const double nearer : {0.2, 5 * free.noise.prior_pixel_sigma(0.1)}) {
    SCOPED_TRACE(nearer);
    Drive hidden;
    hidden.errors = free.errors;
    hidden.spoil = [&](int i, Image<float>& q) {
      if (i == 12) cover(q, 0, kColumns / 2, 1 / kWall + nearer);
    };
    hidden.run(20);
    EXPECT_NEAR(hidden.noise.shared_drift_scale, free.noise.shared_drift_scale, 0.06 * free.noise.shared_drift_scale);
    EXPECT_NEAR(hidden.noise.shared_scale, free.noise.shared_scale, 0.06 * free.noise.shared_scale);
    EXPECT_NEAR(hidden.noise.pixel_scale, free.noise.pixel_scale, 0.02 * free.noise.pixel_scale);
  }
}

// In each frame something near hides another quarter of the wall, and has left the quarter before.
TEST(DepthLearning, PatchesThatSomethingNearerHidesDoNotCount) {
  Drive free;
  free.errors = {1, 1};
  free.run(24);
  Drive hidden;
  hidden.errors = free.errors;
  hidden.spoil = [](int i, Image<float>& q) { cover(q, 4 * (i % 4), 4, 1 / kWall + 0.2); };
  hidden.run(24);
  EXPECT_NEAR(hidden.noise.shared_drift_scale, free.noise.shared_drift_scale, 0.1 * free.noise.shared_drift_scale);
  EXPECT_NEAR(hidden.noise.shared_scale, free.noise.shared_scale, 0.1 * free.noise.shared_scale);
  EXPECT_NEAR(hidden.noise.pixel_scale, free.noise.pixel_scale, 0.05 * free.noise.pixel_scale);
}

// A seventh of the pixels in each frame.
TEST(DepthLearning, APixelWithoutDepthIsNoMeasurement) {
  Drive whole;
  whole.errors = {1, 1};
  whole.run(24);
  Drive holes;
  holes.errors = whole.errors;
  holes.spoil = [](int i, Image<float>& q) {
    Random random(static_cast<unsigned>(100 + i));
    for (int y = 0; y < q.height(); ++y)
      for (int x = 0; x < q.width(); ++x)
        if (random.uniform() < 0.14) q(x, y) = 0;
  };
  holes.run(24);
  EXPECT_NEAR(holes.noise.shared_drift_scale, whole.noise.shared_drift_scale, 0.05 * whole.noise.shared_drift_scale);
  EXPECT_NEAR(holes.noise.shared_scale, whole.noise.shared_scale, 0.05 * whole.noise.shared_scale);
  EXPECT_NEAR(holes.noise.pixel_scale, whole.noise.pixel_scale, 0.02 * whole.noise.pixel_scale);
}

// Exact depth: the prior is given up frame by frame, and never altogether.
TEST(DepthLearning, ThePriorCountsAsOneFrame) {
  for (const int frames : {2, 3, 6, 30}) {
    SCOPED_TRACE(frames);
    Drive drive;
    drive.run(frames);
    EXPECT_NEAR(drive.noise.shared_drift_scale, blended(0, std::min(frames - 1, 20)), 0.01);
    EXPECT_EQ(drive.noise.pixel_scale, 0.2);
  }
}

TEST(DepthLearning, LearnsNothingFromWhatIsBlockedOrNotMeasured) {
  DepthNoise noise = noise_of(DepthSource::Stereo);
  Random random(1);
  const Vector3<double> origin = Vector3<double>::Zero();
  const Image<float> q = view(origin, false, {0, 1}, {}, noise, random);
  Image<float> empty(camera.width(), camera.height());
  empty.fill(0);
  Image<std::uint8_t> free(camera.width(), camera.height()), blocked(camera.width(), camera.height());
  free.fill(255);
  blocked.fill(0);
  const SE3d T_cur_prev = SE3d::translation({-1, 0, 0});
  const auto learns = [&](const Image<float>& before, const Image<std::uint8_t>& mask, const Image<float>& now) {
    DepthLearning learning;
    learning.remember(camera, before, mask, 0);
    learning.learn(camera, T_cur_prev, now, 0.1, noise);
    return !learning.change.said.empty();
  };
  EXPECT_TRUE(learns(q, free, q));
  EXPECT_FALSE(learns(q, blocked, q));
  EXPECT_FALSE(learns(empty, free, q));
  EXPECT_FALSE(learns(q, free, empty));
}

TEST(DepthLearning, ForgetsAll) {
  Drive drive;
  drive.errors = {3, 1.5};
  drive.run(10);
  ASSERT_GT(drive.noise.shared_drift_scale, 1.5);
  ASSERT_GT(drive.noise.shared_scale, 1.5);
  ASSERT_GT(drive.noise.pixel_scale, 1.3);
  drive.learning.clear();  // what was seen, as after a gap in time
  EXPECT_TRUE(drive.learning.history.empty());
  EXPECT_FALSE(drive.learning.change.said.empty());
  drive.learning.forget();
  EXPECT_TRUE(drive.learning.history.empty());
  drive.pixels_per_frame = 0;
  drive.run(3);
  EXPECT_EQ(drive.noise.shared_drift_scale, 1);
  EXPECT_EQ(drive.noise.shared_scale, 1);
  EXPECT_EQ(drive.noise.pixel_scale, 1);
}

}  // namespace
