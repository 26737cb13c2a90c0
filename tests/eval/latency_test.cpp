// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot_eval/latency.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace eval {
namespace {

constexpr double v0 = 0.5;

/// Sightings of one object at 10 Hz, 20 m away.
std::vector<Sighting> film(const std::vector<std::pair<double, Answer>>& speeds, int id = 1) {
  std::vector<Sighting> sightings;
  for (std::size_t i = 0; i < speeds.size(); ++i)
    sightings.push_back({static_cast<int>(i), 0.1 * static_cast<double>(i), id, speeds[i].first > 0, speeds[i].first,
                         20, 1000, speeds[i].second});
  return sightings;
}

TEST(Latency, OfAStart) {
  const auto events = decision_latency(film({{0, Answer::Static},
                                             {0.6, Answer::Static},
                                             {1.0, Answer::Static},
                                             {2, Answer::Missed},
                                             {3, Answer::Moving}}),
                                       v0);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_TRUE(events[0].starts);
  EXPECT_EQ(events[0].frame, 2);
  ASSERT_TRUE(events[0].seconds);
  EXPECT_NEAR(*events[0].seconds, 0.2, 1e-12);
  EXPECT_NEAR(events[0].metres, 0.1 * (1.5 + 2.5), 1e-12);  // at 1, 2 and 3 m/s
}

TEST(Latency, OfAStop) {
  const auto events = decision_latency(
      film({{2, Answer::Moving}, {0.3, Answer::Moving}, {0.2, Answer::Moving}, {0, Answer::Static}}), v0);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_FALSE(events[0].starts);
  EXPECT_EQ(events[0].frame, 2);
  EXPECT_NEAR(events[0].seconds.value(), 0.1, 1e-12);
}

TEST(Latency, WhatMovesAllTheTimeDoesNotStart) {
  EXPECT_TRUE(decision_latency(film({{2, Answer::Static}, {3, Answer::Moving}}), v0).empty());
  EXPECT_TRUE(decision_latency(film({{0.6, Answer::Static}, {3, Answer::Moving}}), v0).empty());
}

TEST(Latency, TheWaitEndsWithTheOppositeEvent) {
  const auto events =
      decision_latency(film({{0, Answer::Static}, {2, Answer::Static}, {0, Answer::Static}, {0, Answer::Moving}}), v0);
  ASSERT_EQ(events.size(), 2U);
  EXPECT_FALSE(events[0].seconds);
  EXPECT_NEAR(events[1].seconds.value(), 0, 1e-12);
  EXPECT_TRUE(std::isinf(latency({events[0]}, 50)));
}

TEST(Latency, TheWaitEndsWithTheOppositeEventAlsoFarAway) {
  std::vector<Sighting> sightings = film({{0, Answer::Static}, {2, Answer::Static}, {0, Answer::Moving}});
  sightings[2].range = 40;
  const auto events = decision_latency(sightings, v0);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_FALSE(events[0].seconds);
}

TEST(Latency, FarAndSmallObjectsDoNotCount) {
  std::vector<Sighting> far = film({{0, Answer::Static}, {2, Answer::Moving}});
  far[1].range = 30;
  EXPECT_TRUE(decision_latency(far, v0).empty());
  std::vector<Sighting> small = film({{0, Answer::Static}, {2, Answer::Moving}});
  small[1].area = 999;
  EXPECT_TRUE(decision_latency(small, v0).empty());
}

TEST(Latency, EventsInFramesThatAreLeftOutDoNotCount) {
  const std::vector<Sighting> sightings = film({{0, Answer::Static}, {2, Answer::Static}, {2, Answer::Moving}});
  EXPECT_EQ(decision_latency(sightings, v0, 1).size(), 1U) << "what it did before is known";
  EXPECT_TRUE(decision_latency(sightings, v0, 2).empty());
}

TEST(Latency, UnknownSpeedsSayNothing) {
  EXPECT_TRUE(decision_latency(film({{0, Answer::Static}, {-1, Answer::Moving}}), v0).empty());
  EXPECT_TRUE(decision_latency(film({{2, Answer::Static}, {-1, Answer::Moving}, {2, Answer::Moving}}), v0).empty());
}

TEST(Latency, MedianCountsEventsWithoutAnAnswerAsEndless) {
  const LatencyEvent quick{1, 0, true, 0.1, 0.2}, slow{2, 0, true, 0.5, 3}, never{3, 0, true, {}};
  EXPECT_DOUBLE_EQ(latency({quick, never, slow}, 50), 0.5);
  EXPECT_TRUE(std::isinf(latency({quick, never, slow}, 100)));
  EXPECT_DOUBLE_EQ(displacement({quick, slow}, 100), 3);
  EXPECT_TRUE(std::isnan(latency({}, 50)));
}

TEST(Latency, StartsAndStopsApart) {
  const auto events = decision_latency(
      film({{0, Answer::Static}, {2, Answer::Moving}, {2, Answer::Moving}, {0, Answer::Moving}, {0, Answer::Static}}),
      v0);
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events_of(events, true).size(), 1U);
  ASSERT_EQ(events_of(events, false).size(), 1U);
  EXPECT_EQ(events_of(events, false)[0].frame, 3);
}

}  // namespace
}  // namespace eval
