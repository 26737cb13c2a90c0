// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/tracker.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "support/film.hpp"
#include "support/result_copy.hpp"
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

constexpr int frames = 8;
bool has_masks(int i) { return i % 3 == 0; }

std::vector<ResultCopy> alone() {
  Tracker tracker(sample().camera, Sample::options());
  std::vector<ResultCopy> out;
  for (int i = 0; i < frames; ++i) out.emplace_back(tracker.track(sample().frame(i, has_masks(i))));
  return out;
}

TEST(Tracker, SameInputGivesIdenticalOutput) {
  const std::vector<ResultCopy> first = alone(), again = alone();
  EXPECT_GE(first.back().objects.size(), 3u);
  for (std::size_t i = 0; i < first.size(); ++i) {
    SCOPED_TRACE(i);
    expect_same(first[i], again[i]);
  }
}

// Another tracker that runs the sequence backwards in between, on another camera, changes nothing.
TEST(Tracker, InterleavedTrackersDoNotInfluenceEachOther) {
  const std::vector<ResultCopy> expected = alone();
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
    expect_same(ResultCopy(result),
                expected[static_cast<std::size_t>(i)]);  // valid until the next call on the same tracker
  }
}

TEST(Tracker, ResetStartsAfreshWithOtherIds) {
  const std::vector<ResultCopy> expected = alone();
  Tracker tracker(sample().camera, Sample::options());
  for (int i = 5; i < 9; ++i) tracker.track(sample().frame(i));
  const std::uint32_t used = ResultCopy(tracker.track(sample().frame(9))).objects.back().id;
  tracker.reset();
  for (int i = 0; i < frames; ++i) {
    SCOPED_TRACE(i);
    ResultCopy got(tracker.track(sample().frame(i, has_masks(i))));
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
  const std::vector<ResultCopy> expected = alone();
  Tracker first(sample().camera, Sample::options());
  for (int i = 0; i < 3; ++i) first.track(sample().frame(i, has_masks(i)));
  Tracker moved(std::move(first));
  expect_same(ResultCopy(moved.track(sample().frame(3, has_masks(3)))), expected[3]);
  Tracker assigned(small_camera());
  assigned = std::move(moved);
  expect_same(ResultCopy(assigned.track(sample().frame(4, has_masks(4)))), expected[4]);
  std::vector<Tracker> many;
  many.push_back(std::move(assigned));
  expect_same(ResultCopy(many.back().track(sample().frame(5, has_masks(5)))), expected[5]);
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
