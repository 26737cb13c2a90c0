// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "sequence/distortion.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "dot/camera/radtan.hpp"

namespace {

using runner::Distortion;

const dot::Intrinsics camera{200, 205, 159.5, 119.5, 320, 240, 0};
const Distortion radtan{Distortion::Model::RadTan, {-0.28, 0.07, 0.0006, -0.0004, -0.005}};
const Distortion fisheye{Distortion::Model::Equidistant, {-0.013, 0.02, -0.013, 0.002, 0}};

/// The ray of a distorted point, by Newton's method with numeric derivatives.
Eigen::Vector2d undistort(const Distortion& distortion, const Eigen::Vector2d& target) {
  Eigen::Vector2d ray = target;
  for (int i = 0; i < 8; ++i) {
    Eigen::Matrix2d J;
    constexpr double h = 1e-6;
    for (int axis = 0; axis < 2; ++axis) {
      const Eigen::Vector2d step = h * Eigen::Vector2d::Unit(axis);
      J.col(axis) = (distortion.distort(ray + step) - distortion.distort(ray - step)) / (2 * h);
    }
    ray += J.inverse() * (target - distortion.distort(ray));
  }
  return ray;
}

TEST(Distortion, RadTanIsThatOfTheLibrary) {
  const dot::RadTan model(camera, radtan.coefficients);
  for (double x = -0.8; x <= 0.8; x += 0.2) {
    for (double y = -0.6; y <= 0.6; y += 0.2) {
      const Eigen::Vector2d pixel = model.project(Eigen::Vector3d(x, y, 1)), d = radtan.distort({x, y});
      EXPECT_NEAR(camera.fx * d.x() + camera.cx, pixel.x(), 1e-9);
      EXPECT_NEAR(camera.fy * d.y() + camera.cy, pixel.y(), 1e-9);
    }
  }
}

TEST(Distortion, EquidistantAngles) {
  // Without coefficients the distance from the centre is the angle itself.
  const Distortion pure{Distortion::Model::Equidistant, {}};
  for (const double degrees : {0.0, 1e-9, 10.0, 45.0, 80.0}) {
    const double t = degrees * CV_PI / 180;
    const Eigen::Vector2d direction(0.6, 0.8), d = pure.distort(std::tan(t) * direction);
    EXPECT_NEAR(d.x(), t * 0.6, 1e-12) << degrees;
    EXPECT_NEAR(d.y(), t * 0.8, 1e-12) << degrees;
  }
  // By hand: at t = 0.5 with k1 = 0.1, k2 = 0.2: 0.5 (1 + 0.025 + 0.0125) = 0.51875.
  const Distortion bent{Distortion::Model::Equidistant, {0.1, 0.2, 0, 0, 0}};
  EXPECT_NEAR(bent.distort({std::tan(0.5), 0}).x(), 0.51875, 1e-12);
}

TEST(Distortion, ThereAndBack) {
  for (const Distortion& distortion : {radtan, fisheye}) {
    for (double x = -0.7; x <= 0.7; x += 0.1) {
      for (double y = -0.5; y <= 0.5; y += 0.1) {
        const Eigen::Vector2d back = undistort(distortion, distortion.distort({x, y}));
        EXPECT_NEAR(back.x(), x, 1e-9);
        EXPECT_NEAR(back.y(), y, 1e-9);
      }
    }
  }
}

/// What a camera without distortion sees at a pixel.
double scene(double x, double y) { return 128 + 60 * std::sin(x / 9) + 50 * std::cos(y / 7); }

TEST(Undistorter, GivesTheImageOfAPinhole) {
  for (const Distortion& distortion : {radtan, fisheye}) {
    // The image through the lens: the ray of each of its pixels hits the scene.
    cv::Mat image(camera.height, camera.width, CV_8UC1);
    cv::Mat ids(camera.height, camera.width, CV_16UC1);
    for (int y = 0; y < camera.height; ++y) {
      for (int x = 0; x < camera.width; ++x) {
        const Eigen::Vector2d ray = undistort(distortion, {(x - camera.cx) / camera.fx, (y - camera.cy) / camera.fy});
        const double px = camera.fx * ray.x() + camera.cx, py = camera.fy * ray.y() + camera.cy;
        image.at<std::uint8_t>(y, x) = static_cast<std::uint8_t>(std::lround(scene(px, py)));
        ids.at<std::uint16_t>(y, x) = px < 160 ? 700 : 40000;
      }
    }
    const runner::Undistorter undistorter(camera, distortion);
    const cv::Mat flat = undistorter.image(image), flat_ids = undistorter.labels(ids);
    for (int y = 40; y < 200; ++y) {
      for (int x = 50; x < 270; ++x) {
        ASSERT_NEAR(flat.at<std::uint8_t>(y, x), scene(x, y), 3) << x << ", " << y;
        const int id = flat_ids.at<std::uint16_t>(y, x);
        ASSERT_TRUE(id == 700 || id == 40000) << "a mean of two ids at " << x << ", " << y;
        if (std::abs(x - 160) > 1) {
          ASSERT_EQ(id, x < 160 ? 700 : 40000) << x << ", " << y;
        }
      }
    }
  }
}

TEST(Undistorter, BeyondTheImageThereIsNoDepth) {
  // A pincushion: the corners of the pinhole's image lie outside of the lens's.
  const Distortion pincushion{Distortion::Model::RadTan, {0.5, 0, 0, 0, 0}};
  const runner::Undistorter undistorter(camera, pincushion);
  const cv::Mat depth = undistorter.labels(cv::Mat(camera.height, camera.width, CV_16UC1, cv::Scalar(1000)));
  EXPECT_EQ(depth.at<std::uint16_t>(0, 0), 0);
  EXPECT_EQ(depth.at<std::uint16_t>(120, 160), 1000);
  const cv::Mat image = undistorter.image(cv::Mat(camera.height, camera.width, CV_8UC3, cv::Scalar(9, 8, 7)));
  EXPECT_EQ(image.at<cv::Vec3b>(0, 0), cv::Vec3b(9, 8, 7)) << "no edge arises where the image ends";
}

}  // namespace
