// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/labels/labeller.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <memory>
#include <vector>

#include "dot/camera/depth_noise.hpp"
#include "dot/camera/pinhole.hpp"
#include "support/box_scene.hpp"

namespace {

using box_scene::kFar;
using box_scene::kHeight;
using box_scene::kNear;
using box_scene::kObject;
using box_scene::kWidth;
using dot::CameraStatus;
using dot::Reason;
using dot::State;
using dot::Track;

/// Frames of boxes before a wall; the camera stands.
struct Scene {
  dot::Pinhole camera{box_scene::kIntrinsics};
  dot::DepthNoise noise{{}, box_scene::kIntrinsics};
  dot::MaskSettings settings;
  dot::Labeller<dot::Pinhole, dot::DepthNoise> labeller;
  std::deque<Track> tracks;
  std::vector<Track*> far_to_near;
  CameraStatus status = CameraStatus::FromHost;

  Track& add(State state) {
    Track& t = tracks.emplace_back();
    t.identity.id = static_cast<std::uint32_t>(tracks.size());
    t.belief.state = state;
    far_to_near.push_back(&t);
    return t;
  }
  /// Its mask in the next frame. @param pixels that it has come to the right since the segmentation.
  static void place(Track& t, const std::array<int, 4>& box, int pixels = 0) {
    dot::fill_mask(
        dot::clip_box(box, kWidth, kHeight), [](int, int) { return true; }, t.outline.mask);
    t.outline.visible = !t.outline.mask.empty();
    t.outline.T_now_shape = box_scene::back(pixels).inverse();
    t.outline.is_newest = true;
    t.motion.step.fit.reason = Reason::None;
  }
  void label(const std::vector<box_scene::Box>& boxes, bool segmented) {
    auto frame = std::make_shared<dot::FrameData>();
    frame->depth.levels.push_back(box_scene::render(boxes).inverse_depth);
    frame->timestamp = ++frames_;
    dot::CameraStep step;
    step.status = status;
    step.seconds = 1;
    labeller.label(far_to_near, frame, step, segmented, camera, noise, settings);
  }

 private:
  int frames_ = 0;
};

TEST(Labeller, WritesStatesAndIdsTheNearestOnTop) {
  Scene scene;
  Track &far = scene.add(State::Static), &near = scene.add(State::Moving);
  Scene::place(far, {10, 10, 20, 10});
  Scene::place(near, {20, 10, 20, 10});
  scene.label({{10, 30, 10, 20, kObject, 1}, {20, 40, 10, 20, kNear, 2}}, true);
  EXPECT_EQ(scene.labeller.ids()(12, 12), 1u);
  EXPECT_EQ(scene.labeller.ids()(25, 12), 2u);
  EXPECT_EQ(scene.labeller.labels().image()(12, 12), static_cast<int>(State::Static));
  EXPECT_EQ(scene.labeller.labels().image()(25, 12), static_cast<int>(State::Moving));
  EXPECT_EQ(scene.labeller.labels().image()(5, 5), 0);
  EXPECT_EQ(far.outline.mask.box(), (std::array<int, 4>{10, 10, 10, 10})) << "what is visible of it";
}

TEST(Labeller, SaysThatWhatIsCoveredIsHidden) {
  Scene scene;
  Track &far = scene.add(State::Static), &near = scene.add(State::Moving);
  Scene::place(far, {22, 12, 10, 5});
  Scene::place(near, {20, 10, 20, 10});
  scene.label({{20, 40, 10, 20, kNear, 2}}, true);
  EXPECT_FALSE(far.outline.visible);
  EXPECT_EQ(far.motion.step.fit.reason, Reason::Hidden);
  EXPECT_EQ(near.motion.step.fit.reason, Reason::None);
}

/// A mover comes in over the left border: the last segmentation showed a part, eight pixels less of it.
int gained_at_border(Scene& scene) {
  Track& t = scene.add(State::Moving);
  Scene::place(t, {0, 10, 12, 20});
  scene.label({{-20, 12, 10, 30, kObject, 1}}, true);
  Scene::place(t, {8, 10, 12, 20}, 8);
  scene.label({{-12, 20, 10, 30, kObject, 1}}, false);
  return t.outline.mask.area - 12 * 20;
}

TEST(Labeller, ShowsPartsThatTheSegmentationCouldNotSee) {
  Scene scene;
  EXPECT_EQ(gained_at_border(scene), 8 * 20);
  EXPECT_EQ(scene.labeller.ids()(2, 15), 1u);
}

/// A network that gives a mask of another object alone, after frames in which it gave all.
TEST(Labeller, ShowsPartsOfAnObjectThatTheSegmentationMissed) {
  Scene scene;
  Track &missed = scene.add(State::Moving), &other = scene.add(State::Static);
  dot::Observation observation;
  const box_scene::Box standing{60, 70, 10, 20, kNear, 2};
  for (const int x : {-22, -20}) {
    missed.observed = other.observed = &observation;
    Scene::place(missed, {0, 10, 32 + x, 20});
    Scene::place(other, {60, 10, 10, 10});
    scene.label({{x, 32 + x, 10, 30, kObject, 1}, standing}, true);
  }
  missed.observed = nullptr;
  Scene::place(missed, {8, 10, 12, 20}, 8);
  Scene::place(other, {60, 10, 10, 10});
  scene.label({{-12, 20, 10, 30, kObject, 1}, standing}, true);
  EXPECT_EQ(missed.outline.mask.area, 20 * 20);
  EXPECT_EQ(other.outline.mask.area, 10 * 10);
}

TEST(Labeller, ShowsNoNewPartsAfterAGuessOfTheCamera) {
  Scene scene;
  scene.status = CameraStatus::Lost;
  EXPECT_EQ(gained_at_border(scene), 0);
}

TEST(Labeller, ShowsNoNewPartsWithoutAMotion) {
  Scene scene;
  Track& t = scene.add(State::Moving);
  Scene::place(t, {0, 10, 12, 20});
  scene.label({{-20, 12, 10, 30, kObject, 1}}, true);
  Scene::place(t, {8, 10, 12, 20}, 8);
  t.motion.step.fit.reason = Reason::LowCorrelation;
  scene.label({{-12, 20, 10, 30, kObject, 1}}, false);
  EXPECT_EQ(t.outline.mask.area, 12 * 20);
}

TEST(Labeller, ForgetsWhatTheSegmentationShowed) {
  Scene scene;
  Track& t = scene.add(State::Moving);
  Scene::place(t, {0, 10, 12, 20});
  scene.label({{-20, 12, 10, 30, kObject, 1}}, true);
  scene.labeller.forget();
  Scene::place(t, {8, 10, 12, 20}, 8);
  scene.label({{-12, 20, 10, 30, kObject, 1}}, false);
  EXPECT_EQ(t.outline.mask.area, 12 * 20);
}

}  // namespace
