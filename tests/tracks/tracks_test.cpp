// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/tracks/tracks.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/iou.hpp"
#include "support/stage_street.hpp"

// All objects, without a pipeline about them.

namespace {

using namespace dot::test;
using dot::CameraStatus;
using dot::Observation;
using dot::Reason;
using dot::State;
using dot::Track;
using dot::Vector3;

TEST(Tracks, TellWhatMovesFromWhatStands) {
  StageStreet street;
  for (int i = 0; i < 5; ++i) street.next(true);
  ASSERT_EQ(street.tracks.size(), 2u);
  EXPECT_EQ(street.find(parked)->belief.state, State::Static);
  EXPECT_EQ(street.find(mover)->belief.state, State::Moving);
  EXPECT_LT((street.find(mover)->belief.velocity_now - Vector3<double>(3, 0, 0)).norm(), 0.3);
}

TEST(Tracks, LendThePointsOfAPastFrameOnKnownObjects) {
  StageStreet street;
  street.next(true);
  const double first = street.cur->timestamp;
  EXPECT_EQ(street.tracks.points_of(first).size(), 2u);
  street.next(true);
  EXPECT_EQ(street.tracks.points_of(street.cur->timestamp).size(), 2u);
  EXPECT_EQ(street.tracks.points_of(first).size(), 2u) << "it is a reference still";
  EXPECT_TRUE(street.tracks.points_of(first - 1).empty());
  for (Track* t : street.tracks.all()) t->identity.discovered = true;
  EXPECT_TRUE(street.tracks.points_of(first).empty()) << "what no network has shown is background";
}

// With a mask of the frame it is known where the nearer object is before its motion is; without, both are followed at
// once, because they are far apart.
TEST(Tracks, WhatANetworkShowsHidesWhatIsFartherAtOnce) {
  StageStreet street;
  const auto hidden = [&street] {
    const auto& image = street.tracks.workers()[0].nearer.image();
    int pixels = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) pixels += image(x, y) != 0;
    return pixels;
  };
  street.next(true), street.next(true);
  const Track *a = street.find(parked), *b = street.find(mover);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(hidden(), (a->inverse_depth() > b->inverse_depth() ? a : b)->outline.mask.area);
  street.next(false);
  EXPECT_EQ(hidden(), 0);
}

TEST(Tracks, CarryOutlinesWhereNoMaskComes) {
  StageStreet street;
  for (int i = 0; i < 4; ++i) street.next(i == 0);
  for (const std::uint32_t id : {parked, mover}) {
    const dot::Mask &mask = street.find(id)->outline.mask, truth = street.mask(id);
    EXPECT_GT(iou(mask, truth), 0.85) << id;
    EXPECT_TRUE(street.find(id)->outline.is_newest);
  }
}

/// What has left the image is carried on. It is searched for again only where a mask without a track may show it.
TEST(Tracks, AreNotSearchedForWhileOutOfSight) {
  constexpr std::uint32_t leaving = 7;
  StageStreet street;
  street.film.add(leaving, straight({0, 0, 6}, {14, 0, 0}));
  while (street.film.index() < 0 || !street.mask(leaving).empty()) {
    ASSERT_LT(street.film.index(), 9);
    street.next(street.film.index() < 3);
  }
  const Track* t = street.find(leaving);
  ASSERT_TRUE(t && t->belief.has_velocity() && t->outline.warped.mask.empty());
  EXPECT_FALSE(t->motion.references.empty());
  EXPECT_EQ(t->motion.step.fit.reason, Reason::Hidden);
  EXPECT_LT((t->motion.step.T_o.t - street.film.T_o(leaving).t).norm(), 0.1);
  EXPECT_EQ(t->belief.state, State::Moving);

  street.advance();
  street.observe();
  Observation& other = street.observations.add();
  dot::fill_mask(
      {5, 5, 30, 30}, [](int, int) { return true; }, other.mask);
  other.centre = {-3, -1, 6};
  other.instance_id = 77;
  street.play(true);
  EXPECT_EQ(street.find(leaving)->motion.step.fit.reason, Reason::LowCorrelation) << "it was searched for";
}

/// A thin thing stops while no mask comes. Its prediction lies on the wall beside it, which is farther.
TEST(Tracks, WhatStopsUnseenIsFoundAgain) {
  constexpr std::uint32_t thin = 7;
  StageStreet street;
  street.film.interval = 0.2;
  street.film.camera_path = straight({0, 0, 0});
  street.film.add(box(thin, {0.15, 0.9, 0.15}, 7000, 0.25, 1.2), [](double t) {
    return dot::SE3d::translation(Vector3<double>(-1.5 + 2.5 * std::min(t, 0.8), 0.5, 5));
  });
  while (street.film.index() < 8) {
    street.next(street.film.index() < 4);
    const Track* t = street.find(thin);
    ASSERT_TRUE(t) << street.film.index();
    EXPECT_NE(t->motion.step.fit.reason, Reason::Hidden) << street.film.index();
  }
  EXPECT_TRUE(street.find(thin)->motion.step.fit.ok());
  EXPECT_LT(street.find(thin)->belief.velocity_now.norm(), 0.3);
}

TEST(Tracks, WithoutACameraNothingIsComparedAndNothingIsNewest) {
  StageStreet street;
  street.next(true);
  street.next(false);
  street.advance();
  street.camera_step.status = CameraStatus::Lost;
  street.play(false);
  const Track* t = street.find(parked);
  EXPECT_EQ(t->motion.step.fit.reason, Reason::CameraLost);
  EXPECT_FALSE(t->outline.is_newest);
  EXPECT_EQ(t->motion.references.size(), 1u) << "this frame alone";
}

TEST(Tracks, LookBackWhereANewObjectBegins) {
  StageStreet street;
  street.advance();
  street.play(false);
  street.next(true);
  const Track* t = street.find(mover);
  ASSERT_NE(t, nullptr);
  EXPECT_TRUE(t->motion.step.fit.ok());
  EXPECT_LT((t->motion.step.fit.motion.velocity - Vector3<double>(3, 0, 0)).norm(), 0.3);
  EXPECT_NEAR(t->motion.step.evidence.span_seconds, 0.1, kClockError);
}

/// A street with a thing that crosses it and rolls by 2 rad/s, in images so noisy that no fit correlates well.
struct NoisyStreet : StageStreet {
  static constexpr std::uint32_t rolling = 7;

  NoisyStreet() {
    film.degradation.noise = 25;
    film.add(rolling, [](double t) {
      return dot::SE3d{dot::so3::exp(Vector3<double>(0, 0, 2 * t)), Vector3<double>(-0.5 + 3 * t, 0.2, 6.5)};
    });
  }
  void expect_a_first_fit(bool doubtful) {
    const Track* t = find(rolling);
    ASSERT_TRUE(t && t->motion.step.fit.ok() && t->motion.step.has_evidence);
    ASSERT_LT(t->motion.step.fit.phi, dot::FirstFit::kSurePhi);
    EXPECT_NEAR(t->motion.step.fit.motion.angular_velocity.norm(), 2, 0.5);
    EXPECT_EQ(t->motion.step.evidence.is_doubtful, doubtful);
    EXPECT_EQ(t->belief.state, doubtful ? State::NotObservable : State::Moving);
  }
};

TEST(Tracks, AFirstFitThatTheOtherDirectionConfirmsDecides) {
  NoisyStreet street;
  street.next(true), street.next(true);
  street.expect_a_first_fit(false);
}

TEST(Tracks, AFirstFitThatNothingConfirmsWaitsForAnother) {
  for (const bool forwards : {true, false}) {
    SCOPED_TRACE(forwards ? "forwards" : "looking back");
    NoisyStreet street;
    street.next(forwards), street.next(!forwards);
    street.expect_a_first_fit(true);
    street.next(true);
    EXPECT_EQ(street.find(NoisyStreet::rolling)->belief.state, State::Moving);
  }
}

TEST(Tracks, ASmallInstanceStartsNone) {
  StageStreet street;
  street.advance();
  street.observe();
  Observation& small = street.observations.add();
  dot::fill_mask(
      {5, 5, 5, 5}, [](int, int) { return true; }, small.mask);
  small.instance_id = 77;
  street.play(true);
  EXPECT_EQ(street.too_small, 1);
  EXPECT_EQ(street.find(77), nullptr);
  EXPECT_EQ(street.tracks.size(), 2u);
}

TEST(Tracks, WhatAMaskShouldShowAndDoesNotIsContradictedThenLost) {
  StageStreet street;
  street.next(true);
  street.film.spoil = [](int, Rendering& seen) {
    for (int y = 0; y < seen.ids.height(); ++y)
      for (int x = 0; x < seen.ids.width(); ++x)
        if (seen.ids(x, y) == parked) seen.ids(x, y) = 0;
  };
  street.setup.mask.keep_seconds = 0.25;
  street.next(true);
  EXPECT_TRUE(street.find(parked)->outline.contradicted);
  EXPECT_FALSE(street.find(parked)->lost);
  street.next(true);
  street.next(true);
  EXPECT_TRUE(street.find(parked)->lost);
  EXPECT_EQ(street.find(parked)->motion.step.fit.reason, Reason::Lost);
  street.next(true);
  EXPECT_EQ(street.find(parked), nullptr);
  EXPECT_EQ(street.find(mover)->identity.id, 2u);
}

TEST(Tracks, OnlyTheLargestAreFollowed) {
  StageStreet street;
  street.setup.estimator.settings.max_fitted = 1;
  street.next(true);
  street.next(true);
  const bool parked_is_larger = street.mask(parked).area > street.mask(mover).area;
  EXPECT_EQ(street.find(parked)->followed, parked_is_larger);
  const Track* other = street.find(parked_is_larger ? mover : parked);
  EXPECT_FALSE(other->followed);
  EXPECT_EQ(other->motion.no_reference, Reason::TooManyObjects);
}

TEST(Tracks, AreCarriedWithoutOldFramesAfterAGap) {
  StageStreet street;
  street.next(true);
  street.next(true);
  street.tracks.forget_references();
  EXPECT_TRUE(street.find(mover)->motion.references.empty());
  EXPECT_EQ(street.find(mover)->motion.no_reference, Reason::NoReference);
  EXPECT_EQ(street.tracks.size(), 2u);
}

/// A belt or a noisy sensor gives dozens of regions.
TEST(Tracks, FollowAFewCandidatesAtATime) {
  StageStreet street;
  street.next(false);
  for (int i = 0; i < 3 * dot::Candidacy::kMost; ++i) {
    dot::Mask region;
    dot::fill_mask(
        {4 + 12 * i, 20, 10, 12}, [](int, int) { return true; }, region);
    street.observations.add_discovered(region, street.cur->inverse_depth(), street.camera);
  }
  street.play(false);
  ASSERT_EQ(street.tracks.size(), static_cast<std::size_t>(dot::Candidacy::kMost));
  for (const Track* t : street.tracks.all()) {
    EXPECT_TRUE(t->candidacy.is_candidate);
    EXPECT_LT(t->observed->mask.x, 4 + 12 * dot::Candidacy::kMost) << "the first ones, which have the largest seeds";
  }
}

}  // namespace
