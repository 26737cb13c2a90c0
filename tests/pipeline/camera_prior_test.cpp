// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// A host that knows roughly how the camera moved: Frame::camera_prior.

#include <gtest/gtest.h>

#include <optional>

#include "dot/tracker.hpp"
#include "support/film.hpp"

namespace {

using dot::CameraStatus;
using dot::Frame;
using dot::Result;
using dot::SE3d;
using dot::Tracker;
using dot::Vector3;
using dot::Vector6;
using namespace dot::test;

constexpr int jump = 5;

/// A slow drive, but between frames 4 and 5 the camera turns by 0.45 rad.
Film<> turned_away() {
  Film<> film;
  film.camera_path = [](double t) {
    Vector6<double> turn = Vector6<double>::Zero();
    turn[4] = t > 0.1 * jump - 0.05 ? 0.45 : 0;
    return SE3d::translation(Vector3<double>(0, 0, 0.5 * t)) * SE3d::exp(turn);
  };
  film.add(1, straight({1.6, 1.3, 8}));
  return film;
}

double error(const Result& result, const Film<>& film) {
  return (SE3d::from_row_major(result.camera.T_cur_prev) * film.T_c().inverse()).log().norm();
}

/// The result of the frame after the jump, with a prior that is off by a twist, or without.
void play(Film<>& film, Tracker& tracker, const std::optional<Vector6<double>>& off, const Result*& result) {
  film.edit = [&film, off](int i, Frame& frame) {
    if (i == jump && off) frame.camera_prior = (SE3d::exp(*off) * film.T_c()).row_major();
  };
  for (int i = 0; i <= jump; ++i) result = &film.next(tracker);
}

TEST(CameraPrior, FindsAMotionThatIsNotFoundWithoutIt) {
  Vector6<double> off;
  off << 0.05, -0.02, 0.05, 0.01, 0.02, 0.01;
  const Result* result = nullptr;
  {
    Film<> film = turned_away();
    Tracker tracker(small_camera());
    play(film, tracker, std::nullopt, result);
    EXPECT_TRUE(result->camera.status == CameraStatus::Lost || error(*result, film) > 0.1);
  }
  Film<> film = turned_away();
  Tracker tracker(small_camera());
  play(film, tracker, off, result);
  EXPECT_EQ(result->camera.status, CameraStatus::Tracked);
  EXPECT_LT(error(*result, film), 0.005);
}

// Odometry slips; constant velocity is tried as well. The last interval's 6 m, 90 pixels on the wall, are too far from
// standing still.
TEST(CameraPrior, DoesNoHarmWhenItIsWrong) {
  Film<> film;
  film.camera_path = [](double t) { return SE3d::translation(Vector3<double>(40 * t * t, 0, 0)); };
  film.edit = [](int, Frame& frame) {
    Vector6<double> wrong = Vector6<double>::Zero();
    wrong[4] = 0.6;
    frame.camera_prior = SE3d::exp(wrong).row_major();
  };
  Tracker tracker(small_camera());
  film.next(tracker);
  for (int i = 1; i < 9; ++i) {
    const Result& result = film.next(tracker);
    EXPECT_EQ(result.camera.status, CameraStatus::Tracked) << i;
    EXPECT_LT(error(result, film), 0.02) << i;
  }
}

// What is known at all is better than nothing.
TEST(CameraPrior, IsTheGuessWhenTheCameraIsLost) {
  Film<> film = turned_away();
  film.spoil = [](int i, Rendering& seen) {
    if (i == jump) seen.intensity.fill(7), seen.round();
  };
  Tracker tracker(small_camera());
  const Result* result = nullptr;
  play(film, tracker, Vector6<double>(Vector6<double>::Zero()), result);
  EXPECT_EQ(result->camera.status, CameraStatus::Lost);
  EXPECT_LT(error(*result, film), 1e-9);
}

}  // namespace
