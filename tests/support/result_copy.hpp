// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "dot/pipeline/result.hpp"

namespace dot::test {

/// What a result says as soon as the labels are ready, copied.
struct ResultCopy {
  std::vector<std::uint8_t> labels;
  std::vector<std::uint32_t> ids;
  CameraResult camera;
  std::vector<ObjectResult> objects;

  explicit ResultCopy(const Result& r) : camera(r.camera), objects(r.objects.begin(), r.objects.end()) {
    for (int y = 0; y < r.labels.height; ++y) {
      labels.insert(labels.end(), r.labels.row(y), r.labels.row(y) + r.labels.width);
      ids.insert(ids.end(), r.ids.row(y), r.ids.row(y) + r.ids.width);
    }
  }
};

/// Expects the same, to the last bit.
inline void expect_same(const ResultCopy& a, const ResultCopy& b) {
  EXPECT_TRUE(a.labels == b.labels);
  EXPECT_TRUE(a.ids == b.ids);
  EXPECT_EQ(a.camera.status, b.camera.status);
  EXPECT_EQ(a.camera.T_cur_prev, b.camera.T_cur_prev);
  EXPECT_EQ(a.camera.covariance, b.camera.covariance);
  EXPECT_EQ(a.camera.gain, b.camera.gain);
  EXPECT_EQ(a.camera.offset, b.camera.offset);
  EXPECT_EQ(a.camera.phi, b.camera.phi);
  EXPECT_EQ(a.camera.n_inliers, b.camera.n_inliers);
  ASSERT_EQ(a.objects.size(), b.objects.size());
  for (std::size_t k = 0; k < a.objects.size(); ++k) {
    const ObjectResult &l = a.objects[k], &r = b.objects[k];
    SCOPED_TRACE("track " + std::to_string(l.id));
    EXPECT_EQ(l.id, r.id);
    EXPECT_EQ(l.state, r.state);
    EXPECT_EQ(l.reason, r.reason);
    EXPECT_EQ(l.p_moving, r.p_moving);
    EXPECT_EQ(l.T_o, r.T_o);
    EXPECT_EQ(l.covariance, r.covariance);
    EXPECT_EQ(l.velocity, r.velocity);
    EXPECT_EQ(l.velocity_covariance, r.velocity_covariance);
    EXPECT_EQ(l.fused_velocity, r.fused_velocity);
    EXPECT_EQ(l.disparity_px, r.disparity_px);
    EXPECT_EQ(l.entropy, r.entropy);
    EXPECT_EQ(l.box, r.box);
    EXPECT_EQ(l.area, r.area);
  }
}

}  // namespace dot::test
