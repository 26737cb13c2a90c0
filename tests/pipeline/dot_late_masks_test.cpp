// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// Masks that arrive after their frame: carried to the present, as good as masks in time as far as that can be.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "dot/tracker.hpp"
#include "support/street.hpp"

namespace {

using dot::Frame;
using dot::Image;
using dot::Masks;
using dot::ObjectResult;
using dot::Options;
using dot::Result;
using dot::State;
using dot::Tracker;
using namespace dot::test;

/// Plays a film to a tracker whose network looks at every `every`th frame and takes `delay` frames for it.
class LateNetwork {
 public:
  LateNetwork(Film<>& film, Tracker& tracker, int every, int delay)
      : film_(film), tracker_(tracker), every_(every), delay_(delay) {}

  const Result& next() {
    Frame frame = film_.advance();
    const int i = film_.index();
    const bool segmented = i % every_ == 0;
    if (!segmented || delay_ > 0) frame.masks.reset();
    const Result& result = tracker_.track(frame);
    if (segmented && delay_ > 0) pending_.push_back({i, film_.seen().ids});
    if (!pending_.empty() && pending_.front().index + delay_ <= i) {
      submit(tracker_, static_cast<std::uint64_t>(pending_.front().index), pending_.front().ids);
      pending_.pop_front();
    }
    return result;
  }

  static void submit(Tracker& tracker, std::uint64_t frame, const Image<std::uint32_t>& ids) {
    Masks masks;
    masks.ids = {ids.row(0), ids.width(), ids.height(), ids.view().stride, dot::PixelFormat::Id32};
    tracker.submit_masks(frame, masks);
  }

 private:
  struct Pending {
    int index;
    Image<std::uint32_t> ids;
  };
  Film<>& film_;
  Tracker& tracker_;
  int every_, delay_;
  std::deque<Pending> pending_;
};

double iou(const Film<>& film, const Result& result, std::uint32_t body) {
  const ObjectResult* o = object_on(result, film.truth().ids, body);
  return o ? overlap(film.truth().ids, body, result.ids, o->id).iou() : 0;
}

std::vector<std::uint8_t> pixels(const Result& result) {
  std::vector<std::uint8_t> out;
  for (int y = 0; y < result.labels.height; ++y)
    out.insert(out.end(), result.labels.row(y), result.labels.row(y) + result.labels.width);
  return out;
}

// The car has crossed 1.2 m, more than half its length, when its first mask arrives.
TEST(LateMasks, FindANewObjectWhereItIsByNow) {
  Film<> film = street();
  Tracker tracker(small_camera());
  LateNetwork network(film, tracker, 100, 3);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(network.next().objects.size, 0u) << i;
  for (int i = 4; i < 8; ++i) {
    SCOPED_TRACE(i);
    const Result& result = network.next();
    ASSERT_EQ(result.objects.size, 2u);
    const ObjectResult* o = object_on(result, film.truth().ids, mover);
    ASSERT_TRUE(o);
    EXPECT_GT(iou(film, result, mover), 0.85) << describe(o);
    EXPECT_GT(iou(film, result, parked), 0.85);
    EXPECT_EQ(o->state, State::Moving) << describe(o);
    EXPECT_NEAR(o->velocity[0], 3, 0.1) << describe(o);
    const ObjectResult* still = object_on(result, film.truth().ids, parked);
    ASSERT_TRUE(still);
    EXPECT_EQ(still->state, State::Static) << describe(still);
    EXPECT_FALSE(o->segmented);
  }
}

struct Timing {
  int every, delay;
};
class Steady : public testing::TestWithParam<Timing> {};

// Masks follow one another, the next frame's may be taken before the last one's have arrived.
TEST_P(Steady, KeepsTracksAndOutlines) {
  Film<> film = street();
  Tracker tracker(small_camera());
  LateNetwork network(film, tracker, GetParam().every, GetParam().delay);
  std::set<std::uint32_t> ids;
  for (int i = 0; i < 15; ++i) {
    const Result& result = network.next();
    if (i <= GetParam().delay + 1) continue;
    SCOPED_TRACE(i);
    EXPECT_EQ(result.objects.size, 2u);
    for (const ObjectResult& o : result.objects) ids.insert(o.id);
    for (const std::uint32_t body : {parked, mover}) {
      const ObjectResult* o = object_on(result, film.truth().ids, body);
      ASSERT_TRUE(o) << body;
      EXPECT_EQ(o->state, body == parked ? State::Static : State::Moving) << describe(o);
      EXPECT_GT(iou(film, result, body), 0.85) << describe(o);
    }
  }
  EXPECT_EQ(ids.size(), 2u);
}

INSTANTIATE_TEST_SUITE_P(LateMasks, Steady, testing::Values(Timing{4, 3}, Timing{1, 1}, Timing{2, 5}, Timing{3, 3}),
                         [](const auto& test) {
                           return "Every" + std::to_string(test.param.every) + "Delay" +
                                  std::to_string(test.param.delay);
                         });

// The outline is that of the late mask, not of the first one.
TEST(LateMasks, ReplaceTheOutline) {
  Film<> film = street();
  film.edit = [](int i, Frame& frame) {
    if (i > 0) frame.masks.reset();
  };
  // The first mask shows the lower half of the mover alone.
  film.spoil = [](int i, Rendering& seen) {
    if (i > 0) return;
    for (int y = 0; y < 160; ++y)
      for (int x = 0; x < seen.ids.width(); ++x)
        if (seen.ids(x, y) == mover) seen.ids(x, y) = 0;
  };
  Tracker tracker(small_camera());
  std::uint32_t id = 0;
  Image<std::uint32_t> late;
  for (int i = 0; i < 8; ++i) {
    const Result& result = film.next(tracker);
    if (i == 0) id = object_on(result, film.truth().ids, mover)->id;
    if (i == 3) late = film.truth().ids;
    if (i == 5) {
      EXPECT_LT(iou(film, result, mover), 0.7);
      LateNetwork::submit(tracker, 3, late);
    }
    if (i <= 5) continue;
    ASSERT_TRUE(object_on(result, film.truth().ids, mover));
    EXPECT_EQ(object_on(result, film.truth().ids, mover)->id, id);
    EXPECT_GT(iou(film, result, mover), 0.85);
  }
}

// Cars in a row: by now the second is where the first was in the frame of the masks.
TEST(LateMasks, TellCarsInARowApart) {
  Film<> film;
  film.add(parked, straight({-3.2, 1.3, 8}, {4.2, 0, 0}));
  film.add(mover, straight({-5.3, 1.3, 8}, {4.2, 0, 0}));
  film.edit = [](int i, Frame& frame) {
    if (i > 0) frame.masks.reset();
  };
  Tracker tracker(small_camera());
  std::uint32_t first = 0, second = 0;
  Image<std::uint32_t> late;
  for (int i = 0; i < 11; ++i) {
    const Result& result = film.next(tracker);
    if (i == 0) first = object_on(result, film.truth().ids, parked)->id;
    if (i == 0) second = object_on(result, film.truth().ids, mover)->id;
    if (i == 4) late = film.truth().ids;
    if (i == 9) LateNetwork::submit(tracker, 4, late);
    if (i < 10) continue;
    EXPECT_EQ(result.objects.size, 2u);
    EXPECT_GT(overlap(film.truth().ids, parked, result.ids, first).iou(), 0.85);
    EXPECT_GT(overlap(film.truth().ids, mover, result.ids, second).iou(), 0.85);
  }
}

// The last one that a mask showed is the second frame; a network that looked at the fifth did not see it.
TEST(LateMasks, EndWhatTheyDoNotShow) {
  Options options;
  options.mask.keep_seconds = 0.55;
  for (const bool submitted : {false, true}) {
    Film<> film = street();
    film.spoil = [](int i, Rendering& seen) {
      if (i > 1) return;  // a patch of the wall
      for (int y = 40; y < 80; ++y)
        for (int x = 200; x < 260; ++x)
          if (seen.ids(x, y) == 0) seen.ids(x, y) = 9;
    };
    film.edit = [](int i, Frame& frame) {
      if (i > 1) frame.masks.reset();
    };
    Tracker tracker(small_camera(), options);
    Image<std::uint32_t> late;
    int last_seen = 0;
    for (int i = 0; i < 14; ++i) {
      const Result& result = film.next(tracker);
      if (i == 4) late = film.truth().ids;
      if (i == 6 && submitted) LateNetwork::submit(tracker, 4, late);
      if (result.ids(230, 60) != 0) last_seen = i;
    }
    if (submitted)
      EXPECT_LE(last_seen, 12);
    else
      EXPECT_EQ(last_seen, 13);
  }
}

/// A mask of one box that no other one touches. @param place 0 to 3.
Image<std::uint32_t> lone_box(const Image<std::uint32_t>& size, int place) {
  Image<std::uint32_t> ids(size.width(), size.height());
  ids.fill(0);
  const int width = size.width() / 8, left = place * 2 * width;
  for (int y = size.height() / 2; y < size.height() / 2 + 40; ++y)
    for (int x = left; x < left + width; ++x) ids(x, y) = 1;
  return ids;
}

// More tracks than twice the instances that may be: each set of masks ends the track that was not seen for longest.
TEST(LateMasks, NameWhatTheyDropOnce) {
  Film<> film = street();
  Options options;
  options.mask.max_instances = 1;
  Tracker tracker(small_camera(), options);
  const auto next = [&]() -> const Result& {
    Frame frame = film.advance();
    frame.masks.reset();
    return tracker.track(frame);
  };
  const auto named_lost = [](const Result& result) {
    std::vector<std::uint32_t> ids;
    for (const ObjectResult& o : result.objects)
      if (o.reason == dot::Reason::Lost) ids.push_back(o.id);
    return ids;
  };
  const auto submit = [&](int frame, int place) {
    LateNetwork::submit(tracker, static_cast<std::uint64_t>(frame), lone_box(film.seen().ids, place));
  };
  const auto ids_of = [](const Result& result) {
    std::vector<std::uint32_t> ids;
    for (const ObjectResult& o : result.objects) ids.push_back(o.id);
    return ids;
  };
  for (int i = 0; i < 6; ++i) next();
  submit(0, 0), submit(1, 1);
  const std::vector<std::uint32_t> before = ids_of(next());
  ASSERT_EQ(before.size(), 2u);
  submit(2, 2), submit(3, 3);
  const Result& result = next();
  EXPECT_EQ(named_lost(result), before) << "the second after a further submission";
  EXPECT_EQ(result.objects.size, 4u);
  ASSERT_NE(result.find(before[0]), nullptr);
  EXPECT_EQ(result.find(before[0])->area, 0);
  EXPECT_EQ(result.find(before[0])->fused_velocity, (std::array<double, 3>{}));
  const std::vector<std::uint32_t> ids = ids_of(result);
  EXPECT_TRUE(std::is_sorted(ids.begin(), ids.end())) << "results are in the order of ids";
  for (const std::uint32_t id : ids) EXPECT_NE(result.find(id), nullptr);
  EXPECT_EQ(named_lost(next()), std::vector<std::uint32_t>{});
  EXPECT_EQ(next().objects.size, 2u);

  submit(4, 0);
  tracker.reset();
  EXPECT_EQ(next().objects.size, 0u) << "nothing of before a reset";
}

TEST(LateMasks, OfTheNewestFrameAreAsThoseInTime) {
  Film<> film = street();
  Tracker in_time(small_camera()), late(small_camera());
  for (int i = 0; i < 7; ++i) {
    Frame frame = film.advance();
    if (i != 0 && i != 4) frame.masks.reset();
    const Result& expected = in_time.track(frame);
    const bool segmented = frame.masks.has_value();
    frame.masks.reset();
    const Result& result = late.track(frame);
    if (segmented) {
      LateNetwork::submit(late, frame.id, film.seen().ids);
      continue;
    }
    SCOPED_TRACE(i);
    ASSERT_EQ(result.objects.size, expected.objects.size);
    for (const std::uint32_t body : {parked, mover}) {
      const ObjectResult* a = object_on(expected, film.truth().ids, body);
      const ObjectResult* b = object_on(result, film.truth().ids, body);
      ASSERT_TRUE(a && b) << body;
      EXPECT_EQ(a->id, b->id);
      EXPECT_EQ(a->state, b->state);
      EXPECT_NEAR(a->velocity[0], b->velocity[0], 0.03);
      EXPECT_NEAR(iou(film, expected, body), iou(film, result, body), 0.01);
    }
  }
}

// What the next frame shows for the first time is looked for in the frame whose masks were the late ones.
TEST(LateMasks, OfTheNewestFrameLeaveItsImages) {
  Film<> film = street();
  Tracker tracker(small_camera());
  for (int i = 0; i < 5; ++i) {
    Frame frame = film.advance();
    if (i < 4) frame.masks.reset();
    const Result& result = tracker.track(frame);
    if (i == 3) {
      Image<std::uint32_t> ids = film.seen().ids;
      for (int y = 0; y < ids.height(); ++y) std::replace(ids.row(y), ids.row(y) + ids.width(), mover, 0u);
      LateNetwork::submit(tracker, frame.id, ids);
    }
    if (i < 4) continue;
    const ObjectResult* o = object_on(result, film.truth().ids, mover);
    ASSERT_TRUE(o);
    EXPECT_EQ(o->reason, dot::Reason::None) << describe(o);
    EXPECT_EQ(o->state, State::Moving) << describe(o);
    EXPECT_NEAR(o->velocity[0], 3, 0.3) << describe(o);
  }
}

TEST(LateMasks, DoNotChangeTheLastResult) {
  Film<> film = street();
  Tracker tracker(small_camera());
  Image<std::uint32_t> late;
  for (int i = 0; i < 5; ++i) {
    Frame frame = film.advance();
    if (i > 0) frame.masks.reset();
    const Result& result = tracker.track(frame);
    if (i == 2) late = film.truth().ids;
    if (i < 4) continue;
    const std::vector<std::uint8_t> before = pixels(result);
    const std::vector<ObjectResult> objects(result.objects.begin(), result.objects.end());
    for (std::uint32_t* p = late.row(0); p != late.row(0) + late.width() * late.height(); ++p)
      if (*p == parked) *p = 0;
    LateNetwork::submit(tracker, 2, late);
    EXPECT_TRUE(pixels(result) == before);
    ASSERT_EQ(result.objects.size, objects.size());
    EXPECT_EQ(result.objects.data[0].id, objects[0].id);
    EXPECT_EQ(result.objects.data[0].area, objects[0].area);
  }
}

struct Refusal {
  const char* name;
  const char* field;
  double late_seconds;
  std::uint64_t frame;
  std::function<void(Masks&)> spoil;
};
class Refused : public testing::TestWithParam<Refusal> {};

// A twin that was never asked goes on in the same way.
TEST_P(Refused, AndNothingChanges) {
  Film<> film = street();
  film.edit = [](int i, Frame& frame) {
    if (i != 2) frame.masks.reset();
  };
  Options options;
  options.mask.late_seconds = GetParam().late_seconds;
  Tracker tracker(small_camera(), options), twin(small_camera(), options);
  for (int i = 0; i < 9; ++i) {
    const Frame& frame = film.advance();
    const Result& result = tracker.track(frame);
    EXPECT_TRUE(pixels(result) == pixels(twin.track(frame))) << i;
    if (i != 7) continue;
    Masks masks;
    masks.ids = film.seen().ids_ref();
    if (GetParam().spoil) GetParam().spoil(masks);
    try {
      tracker.submit_masks(GetParam().frame, masks);
      FAIL() << "was accepted";
    } catch (const std::invalid_argument& e) {
      EXPECT_EQ(std::string(e.what()).rfind(GetParam().field, 0), 0u) << e.what();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(LateMasks, Refused,
                         testing::Values(Refusal{"Unknown", "frame_id: 8 ", 1, 8, nullptr},
                                         Refusal{"BeforeTheLastSegmentation", "frame_id: 1 ", 1, 1, nullptr},
                                         Refusal{"SegmentedInTime", "frame_id: 2 ", 1, 2, nullptr},
                                         Refusal{"TooOld", "frame_id: 4 ", 0.25, 4, nullptr},
                                         Refusal{"NoneAwaited", "frame_id: 7 ", 0, 7, nullptr},
                                         Refusal{"WrongSize", "masks.ids", 1, 6, [](Masks& m) { m.ids.width = 319; }}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(LateMasks, AreAcceptedOnce) {
  Film<> film = street();
  film.edit = [](int, Frame& frame) { frame.masks.reset(); };
  Tracker tracker(small_camera());
  for (int i = 0; i < 4; ++i) film.next(tracker);
  LateNetwork::submit(tracker, 2, film.seen().ids);
  EXPECT_THROW(LateNetwork::submit(tracker, 2, film.seen().ids), std::invalid_argument);
  EXPECT_NO_THROW(LateNetwork::submit(tracker, 3, film.seen().ids));
  film.next(tracker);
  tracker.reset();
  EXPECT_THROW(LateNetwork::submit(tracker, 4, film.seen().ids), std::invalid_argument);
}

// The newest frame's masks, and those of one before it, on clocks that resolve a nanosecond or a quarter of a
// microsecond.
TEST(LateMasks, DoNotDependOnTheClock) {
  for (const std::uint64_t at : {3u, 2u}) {
    std::vector<std::uint8_t> expected;
    for (const double epoch : {0.0, 1.7e9}) {
      Film<> film = street();
      film.epoch = epoch;
      film.edit = [](int, Frame& frame) { frame.masks.reset(); };
      Tracker tracker(small_camera());
      Image<std::uint32_t> ids;
      for (std::uint64_t i = 0; i < 4; ++i) {
        film.next(tracker);
        if (i == at) ids = film.seen().ids;
      }
      LateNetwork::submit(tracker, at, ids);
      EXPECT_THROW(LateNetwork::submit(tracker, at, ids), std::invalid_argument) << epoch;
      for (int i = 4; i < 10; ++i) {
        const Result& result = film.next(tracker);
        EXPECT_EQ(result.camera.status, dot::CameraStatus::Tracked) << epoch << " frame " << i;
        EXPECT_GT(iou(film, result, parked), 0.85) << epoch << " frame " << i;
        EXPECT_GT(iou(film, result, mover), 0.7) << epoch << " frame " << i;
        if (i < 9) continue;
        if (epoch == 0) expected = pixels(result);
        EXPECT_TRUE(pixels(result) == expected) << "the labels depend on the clock";
      }
    }
  }
}

// Memory is bounded by frames as well as by time: a fast camera fills a second with hundreds of frames.
TEST(LateMasks, AreAwaitedForSoManyFrames) {
  Film<> film = street();
  film.interval = 1 / 240.0;
  film.edit = [](int, Frame& frame) { frame.masks.reset(); };
  Options options;
  options.mask.late_frames = 5;
  Tracker tracker(small_camera(), options);
  Image<std::uint32_t> ids;
  for (int i = 0; i < 12; ++i) {
    film.next(tracker);
    if (i == 7) ids = film.seen().ids;
  }
  try {
    LateNetwork::submit(tracker, 6, ids);
    FAIL() << "was accepted";
  } catch (const std::invalid_argument& e) {
    EXPECT_EQ(std::string(e.what()).rfind("frame_id: 6 is none of the frames", 0), 0u) << e.what();
  }
  EXPECT_NO_THROW(LateNetwork::submit(tracker, 7, ids));
  EXPECT_EQ(film.next(tracker).objects.size, 2u);
}

}  // namespace
