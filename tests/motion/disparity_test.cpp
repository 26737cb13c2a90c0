// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/motion/disparity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "dot/camera/pinhole.hpp"
#include "support/random.hpp"

namespace {

using dot::DynamicDisparity;
using dot::Matrix6;
using dot::Pinhole;
using dot::PointSet;
using dot::SE3d;
using dot::Vector2;
using dot::Vector3;
using dot::Vector6;
using dot::test::Random;

const Pinhole camera({500, 480, 320, 240, 640, 480, 0});
const SE3d T_c{dot::so3::exp(Vector3<double>(0.01, 0.03, -0.02)), Vector3<double>(0.1, 0, -0.8)};
const SE3d T_o{dot::so3::exp(Vector3<double>(0, 0.05, 0)), Vector3<double>(0.6, 0, -1.1)};

/// A cloud of points about (1, 0, 12) m.
PointSet cloud(int n, unsigned seed) {
  Random random(seed);
  PointSet points;
  for (int i = 0; i < n; ++i) {
    const Vector3<double> X = Vector3<double>(1, 0, 12) + random.normal3();
    const Vector2<double> p = camera.project(X);
    const auto f = [](double value) { return static_cast<float>(value); };
    points.push(f(p.x()), f(p.y()), f(X.x() / X.z()), f(X.y() / X.z()), f(1 / X.z()), 0);
  }
  return points;
}

Vector3<double> position(const PointSet& points, std::size_t i) {
  return Vector3<double>(points.x[i], points.y[i], 1) / static_cast<double>(points.q[i]);
}

Vector3<double> centroid(const PointSet& points) {
  Vector3<double> sum = Vector3<double>::Zero();
  for (std::size_t i = 0; i < points.u.size(); ++i) sum += position(points, i);
  return sum / points.size();
}

TEST(DynamicDisparity, IsTheMedianDistance) {
  const PointSet points = cloud(101, 1);
  std::vector<double> distances;
  for (std::size_t i = 0; i < points.u.size(); ++i) {
    const Vector3<double> X = position(points, i);
    const Vector3<double> still = T_c * X, moved = T_c * T_o * X;
    distances.push_back((camera.project(moved) - camera.project(still)).norm());
  }
  std::sort(distances.begin(), distances.end());
  const DynamicDisparity d =
      dynamic_disparity(points, camera, T_c, T_o, centroid(points), Matrix6<double>::Zero().eval());
  EXPECT_NEAR(d.median_px, distances[50], 1e-9);
  EXPECT_EQ(d.noise_px, 0);
  EXPECT_GT(d.median_px, 5);
}

TEST(DynamicDisparity, OfAStaticObjectIsZero) {
  const PointSet points = cloud(50, 2);
  const Matrix6<double> sigma = 1e-4 * Matrix6<double>::Identity();
  const DynamicDisparity d = dynamic_disparity(points, camera, T_c, SE3d{}, centroid(points), sigma);
  EXPECT_NEAR(d.median_px, 0, 1e-9);
  EXPECT_GT(d.noise_px, 0.1);
}

TEST(DynamicDisparity, SidewaysMotionOfAPlaneIsKnown) {
  PointSet points;
  for (int i = 0; i < 9; ++i) points.push(0, 0, 0.1f * static_cast<float>(i - 4), 0, 0.1f, 0);
  const DynamicDisparity d = dynamic_disparity(points, camera, SE3d{}, SE3d::translation({0.2, 0, 0}),
                                               Vector3<double>(0, 0, 10), Matrix6<double>::Zero().eval());
  EXPECT_NEAR(d.median_px, 500 * 0.2 / 10, 1e-5);
}

TEST(DynamicDisparity, NoiseIsWhatRandomErrorsDo) {
  const PointSet points = cloud(40, 3);
  const Vector3<double> c = centroid(points), moved = T_o * c;
  Random random(4);
  Matrix6<double> L;
  for (int i = 0; i < 36; ++i) L(i / 6, i % 6) = random.normal(2e-3);
  const Matrix6<double> sigma = L * L.transpose();
  const DynamicDisparity d = dynamic_disparity(points, camera, T_c, T_o, c, sigma);
  double sum = 0;
  const int draws = 2000;
  for (int k = 0; k < draws; ++k) {
    Vector6<double> unit;
    for (int i = 0; i < 6; ++i) unit[i] = random.normal();
    const SE3d off = SE3d::translation(moved) * SE3d::exp(L * unit) * SE3d::translation(-moved) * T_o;
    for (std::size_t i = 0; i < points.u.size(); ++i) {
      const Vector3<double> X = position(points, i);
      const Vector3<double> right = T_c * T_o * X, wrong = T_c * off * X;
      sum += (camera.project(wrong) - camera.project(right)).squaredNorm();
    }
  }
  const double found = std::sqrt(sum / draws / points.size());
  EXPECT_NEAR(d.noise_px, found, 0.06 * found);  // 4 sigma, of one dominant direction: sqrt(1 / (2 draws)) each
}

TEST(DynamicDisparity, LeavesOutWhatIsNotInFront) {
  PointSet points = cloud(5, 5);
  const Vector3<double> c = centroid(points);
  points.push(0, 0, 0, 0, 0, 0);    // no depth
  points.push(0, 0, 0, 0, 5.f, 0);  // 0.2 m away: the camera passes it
  const DynamicDisparity all = dynamic_disparity(points, camera, T_c, T_o, c, Matrix6<double>::Identity().eval());
  const DynamicDisparity some = dynamic_disparity(cloud(5, 5), camera, T_c, T_o, c, Matrix6<double>::Identity().eval());
  EXPECT_EQ(all.median_px, some.median_px);
  EXPECT_EQ(all.noise_px, some.noise_px);
  const DynamicDisparity none = dynamic_disparity(PointSet{}, camera, T_c, T_o, c, Matrix6<double>::Identity().eval());
  EXPECT_EQ(none.median_px, 0);
  EXPECT_EQ(none.noise_px, 0);
}

}  // namespace
