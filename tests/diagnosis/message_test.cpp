// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/diagnosis/message.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace {

using dot::DiagnosisNews;
using dot::Suspicion;

TEST(DiagnosisMessage, NamesTheSuspicionItsFigureAndWhereToLook) {
  EXPECT_EQ(dot::describe({Suspicion::ImplausibleTimes, 100}),
            "implausible_times (100 s): steps between frames longer than max_gap, or under 0.5 ms: are the times in "
            "seconds?");
  EXPECT_EQ(dot::describe({Suspicion::DepthOutOfStep, -1}).find("depth_out_of_step (-1 frames late): "), 0u);
  EXPECT_EQ(dot::describe({}), "");
}

TEST(DiagnosisMessage, EverySuspicionHasOneOfItsOwn) {
  std::set<std::string> meanings;
  const int count = static_cast<int>(Suspicion::LensDistortion);
  for (int i = 1; i <= count; ++i) {
    const auto reason = static_cast<Suspicion>(i);
    const std::string text = dot::describe({reason, 0.25});
    const std::string start = std::string(dot::to_string(reason)) + " (0.25 ";
    EXPECT_EQ(text.find(start), 0u) << text;
    EXPECT_LT(text.size(), 200u) << "the C library's messages are of one line";
    meanings.insert(text.substr(text.find(": ")));
  }
  EXPECT_EQ(meanings.size(), static_cast<std::size_t>(count));
}

TEST(DiagnosisNews, IsWhatAppearsAndNotWhatStays) {
  DiagnosisNews news;
  EXPECT_FALSE(news.add({}));
  EXPECT_TRUE(news.add({Suspicion::ImplausibleTimes, 100}));
  for (int i = 0; i < 1000; ++i) EXPECT_FALSE(news.add({Suspicion::ImplausibleTimes, 100 + 0.1 * i}));
  EXPECT_TRUE(news.add({Suspicion::ImplausibleDepth, 5000})) << "another suspicion";
}

TEST(DiagnosisNews, SuspicionsThatTakeTurnsAreToldOnce) {
  DiagnosisNews news;
  int told = 0;
  for (int i = 0; i < 3000; ++i) {
    told += news.add({Suspicion::RepeatedImages, 0.2});
    told += news.add({});
    told += news.add({Suspicion::TooLittleTexture, 0.6});
    for (int j = 0; j < 150; ++j) told += news.add({});
  }
  EXPECT_EQ(told, 2);
}

TEST(DiagnosisNews, ComesAgainAfterALongAbsenceOrAReset) {
  DiagnosisNews news;
  EXPECT_TRUE(news.add({Suspicion::FixedPart, 0.1}));
  for (int i = 0; i < 200; ++i) EXPECT_FALSE(news.add({}));
  EXPECT_TRUE(news.add({Suspicion::FixedPart, 0.1}));
  EXPECT_FALSE(news.add({Suspicion::FixedPart, 0.1}));
  news.clear();
  EXPECT_TRUE(news.add({Suspicion::FixedPart, 0.1}));
}

}  // namespace
