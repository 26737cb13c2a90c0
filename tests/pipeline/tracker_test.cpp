// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/tracker.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "support/film.hpp"
#include "support/sample.hpp"

namespace {

using dot::ClassifierKind;
using dot::ObjectResult;
using dot::Options;
using dot::Result;
using dot::State;
using dot::Tracker;
using dot::Vector3;
using namespace dot::test;

const Sample& sample() {
  static const Sample loaded(DOT_SAMPLE_DIR);
  return loaded;
}

/// All bytes that a result says, the clock's aside.
struct Copy {
  std::vector<std::uint8_t> labels;
  std::vector<std::uint32_t> ids;
  dot::CameraResult camera;
  std::vector<ObjectResult> objects;

  explicit Copy(const Result& r) : camera(r.camera), objects(r.objects.begin(), r.objects.end()) {
    for (int y = 0; y < r.labels.height; ++y) {
      labels.insert(labels.end(), r.labels.row(y), r.labels.row(y) + r.labels.width);
      ids.insert(ids.end(), r.ids.row(y), r.ids.row(y) + r.ids.width);
    }
  }
};

void expect_same(const Copy& a, const Copy& b) {
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

constexpr int frames = 8;
bool has_masks(int i) { return i % 3 == 0; }

std::vector<Copy> alone() {
  Tracker tracker(sample().camera, Sample::options());
  std::vector<Copy> out;
  for (int i = 0; i < frames; ++i) out.emplace_back(tracker.track(sample().frame(i, has_masks(i))));
  return out;
}

TEST(Tracker, SameInputGivesIdenticalOutput) {
  const std::vector<Copy> first = alone(), again = alone();
  EXPECT_GE(first.back().objects.size(), 3u);
  for (std::size_t i = 0; i < first.size(); ++i) {
    SCOPED_TRACE(i);
    expect_same(first[i], again[i]);
  }
}

// Another tracker that runs the sequence backwards in between, on another camera, changes nothing.
TEST(Tracker, InterleavedTrackersDoNotInfluenceEachOther) {
  const std::vector<Copy> expected = alone();
  Film<> film;
  film.add(1, straight({0, 1.3, 6}, {1, 0, 0}));
  Tracker tracker(sample().camera, Sample::options()), backwards(sample().camera), synthetic(small_camera());
  for (int i = 0; i < frames; ++i) {
    SCOPED_TRACE(i);
    dot::Frame other = sample().frame(frames - 1 - i);
    other.timestamp = 0.1 * i;
    backwards.track(other);
    const Result& result = tracker.track(sample().frame(i, has_masks(i)));
    film.next(synthetic);
    expect_same(Copy(result), expected[static_cast<std::size_t>(i)]);  // valid until the next call on the same tracker
  }
}

TEST(Tracker, ResetStartsAfreshWithOtherIds) {
  const std::vector<Copy> expected = alone();
  Tracker tracker(sample().camera, Sample::options());
  for (int i = 5; i < 9; ++i) tracker.track(sample().frame(i));
  const std::uint32_t used = Copy(tracker.track(sample().frame(9))).objects.back().id;
  tracker.reset();
  for (int i = 0; i < frames; ++i) {
    SCOPED_TRACE(i);
    Copy got(tracker.track(sample().frame(i, has_masks(i))));
    // The same as a new tracker's, with ids that go on.
    ASSERT_FALSE(got.objects.empty());
    const std::uint32_t shift = got.objects.front().id - expected[static_cast<std::size_t>(i)].objects.front().id;
    EXPECT_GE(shift, used);
    for (ObjectResult& o : got.objects) o.id -= shift;
    for (std::uint32_t& id : got.ids) id -= id ? shift : 0;
    expect_same(got, expected[static_cast<std::size_t>(i)]);
  }
}

TEST(Tracker, IsMovable) {
  const std::vector<Copy> expected = alone();
  Tracker first(sample().camera, Sample::options());
  for (int i = 0; i < 3; ++i) first.track(sample().frame(i, has_masks(i)));
  Tracker moved(std::move(first));
  expect_same(Copy(moved.track(sample().frame(3, has_masks(3)))), expected[3]);
  Tracker assigned(small_camera());
  assigned = std::move(moved);
  expect_same(Copy(assigned.track(sample().frame(4, has_masks(4)))), expected[4]);
  std::vector<Tracker> many;
  many.push_back(std::move(assigned));
  expect_same(Copy(many.back().track(sample().frame(5, has_masks(5)))), expected[5]);
}

TEST(Tracker, KeepsItsOptions) {
  Options options;
  options.velocity.v0 = 0.25;
  options.selection.object_points = 123;
  options.classifier = ClassifierKind::Entropy;
  const Tracker tracker(small_camera(), options);
  EXPECT_EQ(tracker.options().velocity.v0, 0.25);
  EXPECT_EQ(tracker.options().selection.object_points, 123);
  EXPECT_EQ(tracker.options().classifier, ClassifierKind::Entropy);
}

/// A street with one parked car and one that moves at `speed`, and what is said of both in the last frame.
std::pair<State, State> last_states(const Options& options, double speed) {
  Film<> film;
  film.camera_path = straight(Vector3<double>::Zero(), {0, 0, 1});
  film.add(1, straight({1.8, 1.3, 7}));
  film.add(2, straight({-1.8, 1.3, 6.5}, {speed, 0, 0}));
  Tracker tracker(small_camera(), options);
  std::pair<State, State> out;
  for (int i = 0; i < 8; ++i) {
    const Result& result = film.next(tracker);
    const ObjectResult *parked = object_on(result, film.truth().ids, 1),
                       *mover = object_on(result, film.truth().ids, 2);
    out = {parked ? parked->state : State::Background, mover ? mover->state : State::Background};
  }
  return out;
}

TEST(Tracker, ClassifierIsChosenAtRunTime) {
  Options options;
  EXPECT_EQ(last_states(options, 1.5), std::make_pair(State::Static, State::Moving));
  options.classifier = ClassifierKind::Entropy;
  EXPECT_EQ(last_states(options, 1.5), std::make_pair(State::Static, State::Moving));
  // A gate that nothing passes: entropies are far below 0 and above -200 nats.
  options.entropy.max_entropy = -200;
  EXPECT_EQ(last_states(options, 1.5), std::make_pair(State::NotObservable, State::NotObservable));
  // The rule as printed has its gate the other way round.
  options.classifier = ClassifierKind::EntropyLiteral;
  options.entropy.min_entropy = -200;
  EXPECT_EQ(last_states(options, 1.5), std::make_pair(State::Static, State::Moving));
  options.entropy.min_entropy = 0;
  EXPECT_EQ(last_states(options, 1.5), std::make_pair(State::NotObservable, State::NotObservable));
}

TEST(Tracker, V0SaysWhatCountsAsMoving) {
  Options options;
  EXPECT_EQ(last_states(options, 0.9).second, State::Moving);  // four times 0.005 / (m s) * (6.5 m)^2
  options.velocity.v0 = 3;
  options.velocity.v0_per_square_metre = 3;
  EXPECT_EQ(last_states(options, 0.9).second, State::Static);
}

}  // namespace
