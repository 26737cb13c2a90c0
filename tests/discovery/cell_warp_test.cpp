// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/discovery/cell_warp.hpp"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "dot/camera/pinhole.hpp"
#include "dot/camera/radtan.hpp"

namespace {

using dot::CellWarp;
using dot::Intrinsics;
using dot::SE3d;
using dot::Vector2;

Intrinsics intrinsics() {
  Intrinsics k;
  k.fx = k.fy = 60;
  k.cx = 31.5, k.cy = 23.5;
  k.width = 67, k.height = 48;  // no multiple of the number of lanes
  return k;
}

template <typename Camera>
void compare_rows_with_cells(const Camera& camera) {
  CellWarp<Camera> warp;
  warp.prepare(camera);
  std::mt19937 random(5);
  std::uniform_real_distribution<float> inverse_depth(0.01f, 2);
  std::normal_distribution<double> size;
  int seen = 0, unseen = 0;
  for (int trial = 0; trial < 20; ++trial) {
    dot::Vector6<double> twist;
    for (int i = 0; i < 6; ++i) twist[i] = (i < 3 ? 0.5 : 0.2) * size(random);
    const dot::SE3f T = SE3d::exp(twist).cast<float>();
    std::vector<float> q(static_cast<std::size_t>(camera.width()));
    for (float& value : q) value = random() % 4 ? inverse_depth(random) : 0;  // some of them end up behind the camera
    const int y = static_cast<int>(random() % static_cast<unsigned>(camera.height()));
    warp.move_row(camera, T, y, q.data());
    for (int x = 0; x < camera.width(); ++x) {
      const float value = q[static_cast<std::size_t>(x)];
      typename CellWarp<Camera>::Moved alone{};
      const bool is_seen = value > 0 && warp(camera, T, x, y, value, alone);
      ASSERT_EQ(is_seen, warp.nearest(x) >= 0) << x << ' ' << y;
      ++(is_seen ? seen : unseen);
      if (!is_seen) {
        EXPECT_EQ(warp.nearest(x), -1);
        continue;
      }
      const typename CellWarp<Camera>::Moved in_row = warp.moved(x);
      EXPECT_EQ(warp.nearest(x),
                std::lround(std::floor(in_row.v + 0.5f)) * camera.width() + std::lround(std::floor(in_row.u + 0.5f)));
      EXPECT_EQ(warp.moved_q(x), in_row.q);
      EXPECT_NEAR(in_row.u, alone.u, 1e-3);
      EXPECT_NEAR(in_row.v, alone.v, 1e-3);
      EXPECT_NEAR(in_row.q, alone.q, 1e-4f * alone.q);
      // The derivative of the place, against a difference.
      const float step = 1e-3f * value;
      typename CellWarp<Camera>::Moved nearer{}, farther{};
      if (!warp(camera, T, x, y, value + step, nearer) || !warp(camera, T, x, y, value - step, farther)) continue;
      const Vector2<float> by_q = warp.by_inverse_depth(camera, T, x, y, value);
      const Vector2<float> difference((nearer.u - farther.u) / (2 * step), (nearer.v - farther.v) / (2 * step));
      EXPECT_LT((by_q - difference).norm(), 0.02f * by_q.norm() + 0.5f) << value;
    }
  }
  EXPECT_GT(seen, 200);
  EXPECT_GT(unseen, 50);
}

TEST(CellWarp, MovesARowAsItMovesItsCells) { compare_rows_with_cells(dot::Pinhole(intrinsics())); }

TEST(CellWarp, MovesARowOfADistortedCameraAsItMovesItsCells) {
  compare_rows_with_cells(dot::RadTan(intrinsics(), {-0.1, 0.02, 0, 0, 0}));
}

}  // namespace
