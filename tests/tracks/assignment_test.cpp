// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/tracks/assignment.hpp"

#include <gtest/gtest.h>

#include <array>
#include <deque>
#include <vector>

namespace {

using dot::Mask;
using dot::MaskSettings;
using dot::Observation;
using dot::Observations;
using dot::Track;
using Box = std::array<int, 4>;

Mask filled(const Box& box) {
  Mask out;
  dot::fill_mask(
      box, [](int, int) { return true; }, out);
  return out;
}

struct Scene {
  std::deque<Track> tracks;
  std::vector<Track*> all;
  Observations observations;
  dot::Assignment assignment;

  /// Expected at `box`, z metres ahead, `size` metres large.
  Track& expect(const Box& box, double z = 10, double size = 2) {
    Track& t = tracks.emplace_back();
    t.identity.id = static_cast<std::uint32_t>(tracks.size());
    t.outline.warped.mask = filled(box);
    t.expected = {{0.01 * box[0] * z, 0, z}, true};
    t.motion.size = size;
    all.push_back(&t);
    return t;
  }
  Track& expect_discovered(const Box& box, bool is_candidate) {
    Track& t = expect(box);
    t.identity.discovered = true;
    t.candidacy.is_candidate = is_candidate;
    return t;
  }
  Observation& see(const Box& box, double z = 10) {
    Observation& o = observations.add();
    o.mask = filled(box);
    o.centre = {0.01 * box[0] * z, 0, z};
    o.instance_id = static_cast<std::uint32_t>(100 + observations.list.size());
    return o;
  }
  void by_overlap() { assignment.by_overlap(all, observations, MaskSettings{}); }
  void by_place() { assignment.by_place(all, observations, MaskSettings{}); }
};

TEST(AssignmentByOverlap, ContinuesTheTrackThatIsThere) {
  Scene scene;
  Track &left = scene.expect({10, 10, 20, 20}), &right = scene.expect({60, 10, 20, 20});
  const Observation& o = scene.see({62, 11, 20, 20});
  scene.by_overlap();
  EXPECT_EQ(left.observed, nullptr);
  EXPECT_EQ(right.observed, &o);
  EXPECT_TRUE(right.segmented);
  EXPECT_TRUE(o.assigned);
  EXPECT_EQ(right.identity.instance_id, o.instance_id);
}

TEST(AssignmentByOverlap, LeavesWhatIsElsewhere) {
  Scene scene;
  Track& t = scene.expect({10, 10, 20, 20});
  const Observation& o = scene.see({40, 10, 20, 20});
  scene.by_overlap();
  EXPECT_EQ(t.observed, nullptr);
  EXPECT_FALSE(o.assigned);
}

TEST(AssignmentByOverlap, ANetworksMaskMakesADiscoveryKnown) {
  Scene scene;
  Track& t = scene.expect_discovered({10, 10, 20, 20}, true);
  scene.see({11, 10, 20, 20});
  scene.by_overlap();
  EXPECT_FALSE(t.identity.discovered);
  EXPECT_FALSE(t.candidacy.is_candidate);
}

TEST(AssignmentByOverlap, ADiscoveryContinuesNothingThatANetworkShowed) {
  Scene scene;
  Track &known = scene.expect({10, 10, 20, 20}), &discovered = scene.expect_discovered({60, 10, 20, 20}, true);
  Observation &on_known = scene.see({10, 10, 20, 20}), &on_discovered = scene.see({60, 10, 20, 20});
  on_known.discovered = on_discovered.discovered = true;
  scene.by_overlap();
  EXPECT_EQ(known.observed, nullptr);
  EXPECT_EQ(discovered.observed, &on_discovered);
  EXPECT_TRUE(discovered.identity.discovered) << "a network has not shown it";
}

TEST(AssignmentByOverlap, ARejectedCandidateIsNotSeenAgain) {
  Scene scene;
  Track& t = scene.expect_discovered({10, 10, 20, 20}, true);
  t.belief.state = dot::State::Static;
  scene.see({10, 10, 20, 20}).discovered = true;
  scene.by_overlap();
  EXPECT_EQ(t.observed, nullptr);
}

TEST(AssignmentByPlace, FindsWhatComesOutBesideItsOutline) {
  Scene scene;
  Track& t = scene.expect({10, 10, 20, 20}, 10, 3);
  const Observation& o = scene.see({30, 10, 10, 20});  // 2 m to the side
  scene.by_overlap();
  ASSERT_EQ(t.observed, nullptr);
  scene.by_place();
  EXPECT_EQ(t.observed, &o);
}

// Assignment by place comes after the decisions.
TEST(AssignmentByPlace, WhatTheCallerSaysMovesDoesSoAtOnce) {
  Scene scene;
  Track& t = scene.expect({10, 10, 20, 20}, 10, 3);
  t.belief.state = dot::State::Static, t.belief.p_moving = 0.01;
  scene.see({30, 10, 10, 20}).always_dynamic = true;
  scene.by_place();
  EXPECT_TRUE(t.belief.always_dynamic);
  EXPECT_EQ(t.belief.state, dot::State::Moving);
  EXPECT_EQ(t.belief.last_decided, dot::State::Moving);
  EXPECT_EQ(t.belief.p_moving, 1);
}

TEST(AssignmentByPlace, RefusesWhatIsTooFarForItsSize) {
  for (const bool aside : {true, false}) {
    Scene scene;
    Track& t = scene.expect({10, 10, 20, 20}, 10, 3);
    scene.see(aside ? Box{60, 10, 10, 20} : Box{30, 10, 10, 20}, aside ? 10 : 16);
    scene.by_place();
    EXPECT_EQ(t.observed, nullptr) << (aside ? "5 m to the side" : "6 m behind");
  }
}

// A car 8 m away is not found again in a bus that passes 2 m before the camera, though it is as large as that distance.
TEST(AssignmentByPlace, RefusesWhatPassesBeforeIt) {
  Scene scene;
  Track& t = scene.expect({10, 10, 20, 20}, 8, 4);
  scene.see({10, 10, 80, 60}, 2);
  scene.by_place();
  EXPECT_EQ(t.observed, nullptr);
}

TEST(AssignmentByPlace, NeedsAPlace) {
  Scene scene;
  scene.expect({10, 10, 20, 20}).expected = {};
  scene.see({30, 10, 10, 20});
  scene.by_place();
  EXPECT_EQ(scene.tracks.front().observed, nullptr);
}

TEST(DropCoveredCandidates, DropsPartsOfWhatIsSeenAsAWhole) {
  Scene scene;
  Track &part = scene.expect_discovered({12, 12, 8, 8}, true),
        &elsewhere = scene.expect_discovered({80, 12, 8, 8}, true);
  Track& whole = scene.expect({10, 10, 20, 20});
  scene.see({10, 10, 20, 20});
  scene.by_overlap();
  ASSERT_NE(whole.observed, nullptr);
  dot::drop_covered_candidates(scene.all, 0.7);
  EXPECT_TRUE(part.lost);
  EXPECT_FALSE(elsewhere.lost);
  EXPECT_FALSE(whole.lost);
}

}  // namespace
