// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// A host whose motion of the camera is wrong: Frame::camera_motion.

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>

#include "dot/tracker.hpp"
#include "support/film.hpp"

namespace {

using dot::CameraMotion;
using dot::CameraStatus;
using dot::Frame;
using dot::ObjectResult;
using dot::Result;
using dot::SE3d;
using dot::State;
using dot::Suspicion;
using dot::Tracker;
using dot::Vector3;
using namespace dot::test;

constexpr std::uint32_t parked = 1, mover = 2, lorry = 3;

/// A drive that becomes faster, past a parked car and one that moves.
Film<> drive() {
  Film<> film;
  film.degradation.noise = 1;
  film.camera_path = [](double t) { return SE3d::translation({0.1 * t, 0, t + 0.4 * t * t}); };
  film.add(parked, straight({2.6, 1.3, 9}));
  film.add(mover, straight({-2.6, 1.3, 9}, {0, 0, 2}));
  return film;
}

/// What the answers of 20 frames are worth.
struct Answers {
  int from_host = 0;  ///< frames whose motion is the host's
  int suspected = 0;  ///< frames with the suspicion that it is wrong
  double figure = 0;  ///< of the last one
  int wrong = 0;      ///< frames with a wrong state of parked or mover, from the fifth on
};

/// @param stated what the host gives for the motion T_c of a frame.
Answers play(Film<>& film, const std::function<SE3d(const SE3d& T_c)>& stated) {
  film.edit = [&](int i, Frame& frame) {
    if (i == 0) return;
    CameraMotion& motion = frame.camera_motion.emplace();
    motion.T_cur_prev = stated(film.T_c()).row_major();
    for (std::size_t k = 0; k < 6; ++k) motion.covariance[7 * k] = k < 3 ? 1e-6 : 1e-9;
  };
  Tracker tracker(small_camera());
  Answers out;
  for (int i = 0; i < 20; ++i) {
    const Result& result = film.next(tracker);
    out.from_host += result.camera.status == CameraStatus::FromHost;
    if (result.diagnosis.reason == Suspicion::HostMotion) ++out.suspected, out.figure = result.diagnosis.figure;
    if (i < 5) continue;
    const ObjectResult *stands = object_on(result, film.truth().ids, parked),
                       *moves = object_on(result, film.truth().ids, mover);
    if (stands) out.wrong += stands->state != State::Static;
    if (moves) out.wrong += moves->state != State::Moving;
  }
  return out;
}

TEST(HostMotion, ThatIsInvertedIsNamedAndNotUsed) {
  Film<> film = drive();
  const Answers answers = play(film, [](const SE3d& T_c) { return T_c.inverse(); });
  EXPECT_EQ(answers.from_host, 0);
  EXPECT_EQ(answers.wrong, 0);
  EXPECT_GT(answers.suspected, 8);
  EXPECT_GT(answers.figure, 2);
}

TEST(HostMotion, OfTheIntervalBeforeIsNotUsed) {
  Film<> film = drive();
  film.camera_path = [](double t) {  // in a hand
    const Vector3<double> turned(0, 0.05 * std::sin(9 * t), 0);
    return SE3d{dot::so3::exp(turned), {0.1 * t, 0, 0.5 * t}};
  };
  SE3d before;
  const Answers answers = play(film, [&](const SE3d& T_c) {
    const SE3d late = before;
    before = T_c;
    return late;
  });
  EXPECT_LE(answers.from_host, 4) << "where the hand turns evenly";
  EXPECT_EQ(answers.wrong, 0);
  EXPECT_GT(answers.suspected, 8);
}

TEST(HostMotion, ThatIsRightIsUsed) {
  Film<> film = drive();
  const Answers answers = play(film, [](const SE3d& T_c) { return T_c; });
  EXPECT_EQ(answers.from_host, 19);
  EXPECT_EQ(answers.suspected, 0);
  EXPECT_EQ(answers.wrong, 0);
}

// It covers most of the image and has more texture than all that stands.
TEST(HostMotion, ThatIsRightIsUsedBesideALargeMoverWithoutAMask) {
  Film<> film = drive();
  film.add(box(lorry, {2, 2, 0.7}, 77, 0.2, 0.9), straight({0, 0.4, 5}, {0.6, 0, 1}));
  film.spoil = [](int, Rendering& seen) {
    for (int y = 0; y < seen.ids.height(); ++y)
      for (int x = 0; x < seen.ids.width(); ++x)
        if (seen.ids(x, y) == lorry) seen.ids(x, y) = 0;
  };
  const Answers answers = play(film, [](const SE3d& T_c) { return T_c; });
  EXPECT_EQ(answers.from_host, 19);
  EXPECT_EQ(answers.suspected, 0);
}

}  // namespace
