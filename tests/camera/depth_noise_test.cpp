// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/camera/depth_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using dot::DepthNoise;
using dot::DepthNoiseSettings;
using dot::DepthSource;
using dot::Intrinsics;

const Intrinsics stereo_camera{700, 720, 320, 240, 640, 480, 0.5};

DepthNoiseSettings settings_of(DepthSource source) {
  DepthNoiseSettings s;
  s.source = source;
  return s;
}

/// Standard deviation of the depth that one of inverse depth makes at z.
double metres(double sigma_q, double z) { return sigma_q * z * z; }

TEST(DepthNoise, OfStereoIsConstantInDisparity) {
  DepthNoiseSettings s = settings_of(DepthSource::Stereo);
  s.stereo_sigma_px = 0.4;
  s.stereo_shared_px = 0.1;
  const DepthNoise noise(s, stereo_camera);
  EXPECT_DOUBLE_EQ(noise.focal_baseline, 355);  // of the mean focal length
  for (const double z : {1.0, 10.0, 90.0}) {
    EXPECT_DOUBLE_EQ(noise.pixel_sigma(1 / z), 0.4 / 355);
    EXPECT_DOUBLE_EQ(noise.shared_sigma(1 / z), 0.1 / 355);
    EXPECT_DOUBLE_EQ(noise.shared_drift_sigma(1 / z), 0.1 / 355);
  }
}

TEST(DepthNoise, OfStereoWithoutBaselineIsUnknown) {
  Intrinsics camera = stereo_camera;
  camera.baseline = 0;
  const DepthNoise noise(settings_of(DepthSource::Stereo), camera);
  EXPECT_EQ(noise.settings.source, DepthSource::Unknown);
  EXPECT_TRUE(std::isfinite(noise.pixel_sigma(0.1)));
  EXPECT_DOUBLE_EQ(noise.pixel_sigma(0.1),
                   DepthNoise(settings_of(DepthSource::Unknown), stereo_camera).pixel_sigma(0.1));
}

TEST(DepthNoise, OfRgbdGrowsWithTheSquareOfTheDepth) {
  DepthNoiseSettings s = settings_of(DepthSource::Rgbd);
  s.rgbd_sigma = 0.003;
  const DepthNoise noise(s, stereo_camera);
  EXPECT_NEAR(metres(noise.pixel_sigma(1), 1), 0.003, 0.0015);
  const double ratio = metres(noise.pixel_sigma(1 / 8.0), 8) / metres(noise.pixel_sigma(1 / 4.0), 4);
  EXPECT_GT(ratio, 3);  // four without the constant share, which is quadratic in neither
  EXPECT_LE(ratio, 4);
}

TEST(DepthNoise, OfLidarIsAboutConstantInMetres) {
  DepthNoiseSettings s = settings_of(DepthSource::Lidar);
  s.lidar_sigma = 0.05;
  const DepthNoise noise(s, stereo_camera);
  EXPECT_GE(metres(noise.pixel_sigma(1), 1), 0.05);
  EXPECT_LE(metres(noise.pixel_sigma(1), 1), 0.10);
  // A far beam covers more: the metres grow, but far less than stereo's, which would by 400.
  const double ratio = metres(noise.pixel_sigma(1 / 40.0), 40) / metres(noise.pixel_sigma(1 / 2.0), 2);
  EXPECT_GE(ratio, 1);
  EXPECT_LT(ratio, 20);
}

TEST(DepthNoise, OfUnknownSourceIsRelative) {
  DepthNoiseSettings s = settings_of(DepthSource::Unknown);
  s.unknown_relative = 0.02;
  const DepthNoise noise(s, stereo_camera);
  EXPECT_DOUBLE_EQ(noise.pixel_sigma(0.5), 0.01);
  EXPECT_DOUBLE_EQ(noise.pixel_sigma(0.05), 0.001);
}

TEST(DepthNoise, ScalesMultiplyThePriors) {
  for (const DepthSource source : {DepthSource::Stereo, DepthSource::Rgbd, DepthSource::Lidar, DepthSource::Unknown}) {
    DepthNoise noise(settings_of(source), stereo_camera);
    for (const double q : {0.02, 0.3, 1.5}) {
      const double pixel = noise.prior_pixel_sigma(q), common = noise.prior_shared_sigma(q);
      EXPECT_GT(pixel, 0);
      EXPECT_GT(common, 0);
      EXPECT_LE(common, pixel);  // what an object shares is the smaller part
      noise.pixel_scale = 2, noise.shared_scale = 3, noise.shared_drift_scale = 5;
      EXPECT_DOUBLE_EQ(noise.pixel_sigma(q), 2 * pixel);
      EXPECT_DOUBLE_EQ(noise.shared_sigma(q), 3 * common);
      EXPECT_DOUBLE_EQ(noise.shared_drift_sigma(q), 5 * common);
      noise.pixel_scale = noise.shared_scale = noise.shared_drift_scale = 1;
    }
  }
}

struct Incomplete {
  double pixel(double) const { return 1; }
  double common(double) const { return 1; }
};

TEST(DepthNoiseConcept, AcceptsDepthNoiseAndNothingElse) {
  EXPECT_TRUE(dot::is_depth_noise_v<DepthNoise>);
  EXPECT_FALSE(dot::is_depth_noise_v<Incomplete>);
  EXPECT_FALSE(dot::is_depth_noise_v<double>);
}

}  // namespace
