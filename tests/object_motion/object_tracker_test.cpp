// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/object_motion/object_tracker.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/stage_film.hpp"

// One object, followed without a pipeline about it.

namespace {

using namespace dot::test;
using dot::CameraStatus;
using dot::Mask;
using dot::ObjectBelief;
using dot::ObjectFit;
using dot::ObjectMotion;
using dot::ObjectReference;
using dot::ObjectStep;
using dot::Observation;
using dot::Reason;
using dot::Vector3;

constexpr std::uint32_t car = 1;

/// A car before a camera that drives towards it.
struct Following : StageFilm {
  StageSetup setup;
  ObjectMotion motion;
  ObjectBelief belief;
  dot::ObjectWorkspace<dot::DirectAligner<>> workspace;

  static Film<> scene(const Vector3<double>& velocity, double ahead) {
    Film<> film;
    film.camera_path = straight({0, 0, 0}, {0, 0, 1});
    film.degradation.noise = 1;
    film.add(car, straight({-1, 1.3, ahead}, velocity));
    return film;
  }
  explicit Following(const Vector3<double>& velocity, double ahead = 7.5) : StageFilm(scene(velocity, ahead)) {}

  dot::ObjectTracker<dot::Pinhole, dot::DepthNoise, dot::DirectAligner<>> tracker() const {
    return DefaultTracks::tracker(setup, setup.noise);
  }
  /// The next frame, without following to it.
  void see() {
    advance();
    observe();
  }
  void remember() {
    const Mask visible = mask(car);
    tracker().remember(*cur, &visible, workspace, motion);
  }
  ObjectStep follow() { return tracker().follow(motion, belief, {}, interval(), {}, workspace); }
  /// The next frame, followed to and remembered.
  ObjectStep next() {
    see();
    motion.step = follow();
    motion.advance(camera_step, motion.step.T_o_outline);
    remember();
    return motion.step;
  }
  const Observation& observed() const { return observations.list.front(); }
};

TEST(Follow, FindsTheMotionOfTheLastInterval) {
  Following object({3, 0, 0});
  object.see();
  object.remember();
  const ObjectStep step = object.next();
  ASSERT_TRUE(step.fit.ok()) << to_string(step.fit.reason);
  EXPECT_LT((step.fit.motion.velocity - Vector3<double>(3, 0, 0)).norm(), 0.15);
  EXPECT_TRUE(step.has_evidence);
  const Vector3<double> before = object.film.before(car);
  EXPECT_LT((step.T_o * before - object.film.T_o(car) * before).norm(), 0.02);
}

TEST(Follow, ASlowThingShowsAgainstAnOlderFrame) {
  Following object({0.1, 0, 0});
  object.setup.estimator.velocity.acceleration = 0.1;  // m/s^2: nothing that starts within an interval
  object.see();
  object.remember();
  ObjectStep step;
  for (int i = 0; i < 4; ++i) step = object.next();
  ASSERT_TRUE(step.has_evidence);
  EXPECT_NEAR(step.evidence.span_seconds, 0.4, kClockError);
  EXPECT_LT((step.evidence.velocity - Vector3<double>(0.1, 0, 0)).norm(), 0.05);
}

TEST(Follow, LooksPastAFrameThatGaveNoFit) {
  Following object({3, 0, 0});
  object.see();
  object.remember();
  object.next();
  const double remembered = object.cur->timestamp;
  object.see();  // not followed to, but the camera moved on
  for (ObjectReference& r : object.motion.references) r.camera = r.camera.after(object.camera_step);
  object.see();
  const ObjectStep step = object.follow();
  ASSERT_TRUE(step.fit.ok()) << to_string(step.fit.reason);
  EXPECT_EQ(step.astray_since, remembered) << "where it was carried to since then was a guess";
  EXPECT_NEAR(step.fit.motion.span_seconds, 0.2, kClockError);
}

// The fit of the last interval is of a wrong minimum. That of an older frame starts from it and ends in the same one.
TEST(Follow, AnOlderFrameDoesNotTakeADoubtAway) {
  Following object({9, 0, 0}, 9);
  auto& settings = object.setup.estimator.settings;
  settings.min_phi = settings.min_phi_expected = -1;
  settings.min_inlier_share = settings.min_depth_agreement = 0, settings.min_inliers = 1;
  object.setup.estimator.velocity.acceleration = 0.1;  // m/s^2, so that the older frame is more precise
  object.see(), object.remember();
  object.see();
  object.motion.step.T_o = dot::SE3d::translation({0.7, 0, 0});  // a wrong one, to which the next fit may go on
  object.motion.advance(object.camera_step, {});
  object.remember();
  object.motion.has_T_o_now = true;
  object.motion.T_o_now = object.motion.step.T_o;
  settings.max_speed = 7.5;
  object.see();
  const ObjectStep step = object.follow();
  ASSERT_TRUE(step.fit.ok() && step.has_evidence);
  ASSERT_EQ(step.evidence.span_frames, 2);
  EXPECT_TRUE(step.evidence.is_doubtful);
  object.motion.references.pop_back();
  EXPECT_TRUE(object.follow().evidence.is_doubtful);
}

TEST(Follow, WithoutAReferenceSaysWhy) {
  Following object({3, 0, 0});
  object.see();
  object.motion.no_reference = Reason::TooLittleDepth;
  object.see();
  EXPECT_EQ(object.follow().fit.reason, Reason::TooLittleDepth);
  object.remember();
  object.see();
  object.camera_step.status = CameraStatus::Lost;
  EXPECT_EQ(object.follow().fit.reason, Reason::CameraLost);
  object.camera_step.status = CameraStatus::FirstFrame;
  EXPECT_EQ(object.follow().fit.reason, Reason::NoReference);
}

TEST(Follow, WithoutAFitGoesOnAsExpected) {
  Following object({3, 0, 0});
  object.see();
  object.see();
  object.belief.state = dot::State::Moving;
  object.belief.velocity_now = {3, 0, 0};
  const ObjectStep step = object.follow();
  EXPECT_FALSE(step.fit.ok());
  EXPECT_FALSE(step.has_evidence);
  EXPECT_LT((step.T_o.t - Vector3<double>(0.3, 0, 0)).norm(), 1e-5);
}

TEST(Follow, RefusesAFitThatItsVelocityExcludes) {
  Following object({3, 0, 0});
  object.see();
  object.remember();
  object.see();
  ObjectBelief& belief = object.belief;
  belief.velocity_now = {-20, 0, 0};
  belief.velocity_covariance = 0.01 * dot::Matrix3<double>::Identity();
  belief.last_fit = object.prev->timestamp;
  for (int i = 0; i < 5; ++i) belief.trust.accept(true, 0.1);
  ASSERT_TRUE(belief.knows_velocity());
  EXPECT_FALSE(object.follow().fit.ok());
}

TEST(AlignBackwards, FindsTheMotionOfWhatIsNew) {
  Following object({3, 0, 0});
  object.see();
  object.see();
  const auto fit = object.tracker().align_backwards(object.motion, object.belief, object.observed(), object.interval(),
                                                    object.workspace);
  ASSERT_TRUE(fit);
  EXPECT_LT((fit->motion.velocity - Vector3<double>(3, 0, 0)).norm(), 0.2);
  const Vector3<double> before = object.film.before(car);
  EXPECT_LT((fit->T_o * before - object.film.T_o(car) * before).norm(), 0.03);
}

TEST(AlignBackwards, RefusesWithoutACameraOrPoints) {
  Following object({3, 0, 0});
  object.see();
  object.see();
  const auto align = [&](const Observation& observed) {
    return object.tracker().align_backwards(object.motion, object.belief, observed, object.interval(),
                                            object.workspace);
  };
  Observation small;
  dot::fill_mask(
      {150, 150, 5, 5}, [](int, int) { return true; }, small.mask);
  EXPECT_FALSE(align(small)) << "too few pixels for a reference";
  object.camera_step.status = CameraStatus::Lost;
  EXPECT_FALSE(align(object.observed()));
}

TEST(MakeReference, SaysWhatIsMissing) {
  Following object({3, 0, 0});
  object.see();
  const auto reason = [&](const Mask& mask) {
    ObjectReference r;
    return object.tracker().make_reference(*object.cur, mask, {0, 0, 7}, {}, object.workspace, r);
  };
  EXPECT_EQ(reason(object.mask(car)), Reason::None);
  Mask small;
  dot::fill_mask(
      {150, 150, 5, 5}, [](int, int) { return true; }, small);
  EXPECT_EQ(reason(small), Reason::TooFewPixels);

  object.film.spoil = [](int, Rendering& seen) { seen.depth.fill(0); };
  object.see();
  EXPECT_EQ(reason(object.mask(car)), Reason::TooLittleDepth);
  object.film.spoil = [](int, Rendering& seen) { seen.grey.fill(100); };
  object.see();
  EXPECT_EQ(reason(object.mask(car)), Reason::TooLittleTexture);
}

TEST(Remember, KeepsTheMiddleOfWhatIsHalfHidden) {
  Following object({0, 0, 0});
  object.see();
  object.remember();
  const double size = object.motion.size;
  const Vector3<double> middle = object.motion.position_now.at;
  EXPECT_GT(size, 1);
  Mask half = object.mask(car);
  const auto [x, y, width, height] = half.box();
  const Mask whole = half;
  dot::fill_mask(
      {x, y, width / 4, height}, [&](int u, int v) { return whole.at(u, v); }, half);
  object.tracker().remember(*object.cur, &half, object.workspace, object.motion);
  EXPECT_EQ(object.motion.size, size);
  EXPECT_EQ(object.motion.position_now.at, middle) << "a quarter of it shows a part that is not its middle";
  object.tracker().remember(*object.cur, nullptr, object.workspace, object.motion);
  EXPECT_EQ(object.motion.no_reference, Reason::Hidden);
}

// A lidar beside the camera sees a car through the gap under a lorry, and then only the lorry.
struct SeenByALidar : Following {
  static constexpr double lorry = 4, place = 12;  // metres

  SeenByALidar() : Following({0, 0, 0}, place) { setup.estimator.settings.max_speed = 30; }
  /// The next frame. @param step of the car's pixels that have a depth, in both directions. @param depth metres,
  /// theirs.
  void see(int step, double depth) {
    film.spoil = [step, depth](int, Rendering& seen) {
      for (int y = 0; y < seen.ids.height(); ++y)
        for (int x = 0; x < seen.ids.width(); ++x)
          if (seen.ids(x, y) == car) seen.depth(x, y) = x % step || y % step ? 0 : static_cast<float>(depth);
    };
    Following::see();
  }
  void remember() {
    const Mask visible = mask(car);
    auto lidar = tracker();
    lidar.depth_source = dot::DepthSource::Lidar;
    lidar.remember(*cur, &visible, workspace, motion);
  }
};

TEST(Remember, AFewPointsThatAreFarFromTheObjectAreOfAnother) {
  for (const double other : {SeenByALidar::lorry, 3 * SeenByALidar::place}) {
    SeenByALidar object;
    object.see(1, SeenByALidar::place), object.remember();
    ASSERT_EQ(object.motion.references.size(), 1u);
    object.see(3, SeenByALidar::place), object.remember();
    ASSERT_EQ(object.motion.references.size(), 2u) << "few, but where it is";
    object.see(3, other), object.remember();
    EXPECT_EQ(object.motion.references.size(), 2u) << other;
    EXPECT_EQ(object.motion.no_reference, Reason::TooLittleDepth) << other;
    EXPECT_NEAR(object.motion.position_now.at.z(), SeenByALidar::place, 0.5) << other;
  }
}

// They are also few where they are refused for another reason. The object stays where it was.
TEST(Remember, AFewPointsOfAnotherThatWouldBeRefusedAnywayDoNotMoveTheObject) {
  SeenByALidar object;
  object.see(1, SeenByALidar::place), object.remember();
  const double size = object.motion.size;
  object.setup.estimator.settings.min_points = 100000;
  object.see(3, 3 * SeenByALidar::place), object.remember();
  EXPECT_NEAR(object.motion.position_now.at.z(), SeenByALidar::place, 0.5);
  EXPECT_EQ(object.motion.size, size);
}

// The middle of a half hidden object is predicted, and drifts. The newest reference was measured.
TEST(Remember, AFewPointsAreComparedWithWhatWasMeasured) {
  SeenByALidar object;
  object.see(1, SeenByALidar::place), object.remember();
  object.motion.position_now.at.z() = 3 * SeenByALidar::place;
  object.see(3, SeenByALidar::place), object.remember();
  EXPECT_EQ(object.motion.references.size(), 2u);
}

TEST(Remember, ManyPointsAreTheObjectWhereverTheyAre) {
  SeenByALidar object;
  object.see(1, SeenByALidar::place), object.remember();
  object.see(1, SeenByALidar::lorry), object.remember();
  EXPECT_EQ(object.motion.references.size(), 2u);
}

// What was remembered may have been the wrong one. It is not believed for longer than it is kept.
TEST(Remember, WithoutAReferenceAFewPointsAreTheObject) {
  SeenByALidar object;
  object.see(3, SeenByALidar::lorry), object.remember();
  ASSERT_EQ(object.motion.references.size(), 1u);
  object.motion.forget_references(Reason::NoReference);
  object.see(3, SeenByALidar::place), object.remember();
  EXPECT_EQ(object.motion.references.size(), 1u);
  EXPECT_NEAR(object.motion.position_now.at.z(), SeenByALidar::place, 0.5);
}

}  // namespace
