// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// A hand-held camera that reads its rows one after another.

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

#include <Eigen/Cholesky>

#include "dot/dot.hpp"
#include "support/film.hpp"

namespace {

using dot::CameraMotion;
using dot::CameraStatus;
using dot::Dot;
using dot::Frame;
using dot::Matrix6;
using dot::ObjectResult;
using dot::Pinhole;
using dot::Result;
using dot::SE3d;
using dot::State;
using dot::Suspicion;
using dot::Vector3;
using dot::Vector6;
using namespace dot::test;

constexpr std::uint32_t standing = 1, moving = 2;

/// Shaken by up to 45 degrees a second, twice a second about one axis and less often about the other.
Film<> shaken(double readout) {
  Film<> film;
  film.interval = 1.0 / 30;
  film.readout = readout;
  film.degradation.noise = 2;
  film.camera_path = [](double t) {
    const Vector3<double> turned(0.062 * std::sin(12.6 * t), 0.08 * std::sin(9.4 * t + 1), 0);
    return SE3d{dot::so3::exp(turned), Vector3<double>(0.1 * t, 0, 0.2 * t)};
  };
  film.add(standing, straight({1.3, 1.2, 5}));
  film.add(moving, straight({-1.8, 1.2, 5}, {0.7, 0, 0}));
  return film;
}

/// Runs it, and tests what is said of the two objects. @param host gives the true motion of the camera.
void expect_right(double readout, bool host) {
  Film<> film = shaken(readout);
  Dot<> dot{Pinhole(small_camera())};
  int stands = 0, moves = 0, frames = 0;
  Suspicion last{};
  for (int i = 0; i < 26; ++i) {
    Frame frame = film.advance();
    if (host && i > 0) {
      CameraMotion& motion = frame.camera_motion.emplace();
      motion.T_cur_prev = film.T_c().row_major();
      for (std::size_t k = 0; k < 6; ++k) motion.covariance[7 * k] = k < 3 ? 1e-8 : 1e-10;  // 0.1 mm, 0.01 mrad
    }
    const Result& result = dot.track(frame);
    last = result.diagnosis.reason;
    if (i < 8) continue;
    ++frames;
    ASSERT_EQ(result.camera.status, host ? CameraStatus::FromHost : CameraStatus::Tracked) << i;
    const ObjectResult *still = object_on(result, film.truth().ids, standing),
                       *mover = object_on(result, film.truth().ids, moving);
    ASSERT_TRUE(still && mover) << i;
    EXPECT_NE(still->state, State::Moving) << i << ' ' << describe(still);
    EXPECT_NE(mover->state, State::Static) << i << ' ' << describe(mover);
    stands += still->state == State::Static, moves += mover->state == State::Moving;
  }
  const double enough = host ? 0.85 : 0.9;
  EXPECT_GE(stands, enough * frames);
  EXPECT_GE(moves, enough * frames);
  EXPECT_EQ(last, readout > 0 ? Suspicion::RollingShutter : Suspicion::None);
}

TEST(RollingShutterPipeline, WhatStandsIsNotCalledMoving) {
  for (const double readout : {0.0, 0.03}) {
    SCOPED_TRACE(readout);
    expect_right(readout, false);
  }
}

TEST(RollingShutterPipeline, NorByAHostsMotionOfTheMiddleRow) { expect_right(0.03, true); }

// The reported motion is that of the middle row, several times more exact than one for all rows.
TEST(RollingShutterPipeline, TheCamerasMotionIsThatOfTheMiddleRow) {
  Film<> film = shaken(0.03);
  Dot<> dot{Pinhole(small_camera())};
  double squared = 0, in_sigmas = 0;
  int frames = 0;
  for (int i = 0; i < 16; ++i) {
    const Result& result = film.next(dot);
    if (i < 4) continue;
    ++frames;
    const Vector6<double> e = (SE3d::from_row_major(result.camera.T_cur_prev) * film.T_c().inverse()).log();
    const Eigen::Map<const Matrix6<double>, Eigen::Unaligned> covariance(result.camera.covariance.data());
    squared += e.head<3>().squaredNorm();
    in_sigmas += e.dot(covariance.ldlt().solve(e)) / 6;
  }
  EXPECT_LT(std::sqrt(squared / frames), 0.01);  // metres; one motion for all rows is wrong by 0.04
  EXPECT_LT(in_sigmas / frames, 6);
}

}  // namespace
