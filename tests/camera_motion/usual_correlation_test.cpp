// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/camera_motion/usual_correlation.hpp"

#include <gtest/gtest.h>

namespace {

using dot::UsualCorrelation;

TEST(UsualCorrelation, DoubtsNothingBeforeTheFirstInterval) { EXPECT_FALSE(UsualCorrelation{}.has_dropped(0.1)); }

TEST(UsualCorrelation, DoubtsWhatExplainsMuchLessThanBefore) {
  UsualCorrelation usual;
  usual.add(0.98);
  EXPECT_FALSE(usual.has_dropped(0.95));
  EXPECT_TRUE(usual.has_dropped(0.93));
  usual.add(0.9999);  // two images of one moment, nearly: the next pair need not be as alike
  EXPECT_FALSE(usual.has_dropped(0.99));
  EXPECT_TRUE(usual.has_dropped(0.98));
}

TEST(UsualCorrelation, GetsUsedToRainButNotToOneJolt) {
  UsualCorrelation usual;
  usual.add(0.99);
  usual.add(0.7);
  EXPECT_TRUE(usual.has_dropped(0.7));
  for (int i = 0; i < 10; ++i) usual.add(0.7);
  EXPECT_FALSE(usual.has_dropped(0.7));
  usual.add(0.99);
  EXPECT_TRUE(usual.has_dropped(0.7)) << "the rain is over";
}

TEST(UsualCorrelation, TakesAnotherMotionOnlyIfItIsMuchBetter) {
  EXPECT_TRUE(UsualCorrelation::is_much_better(0.97, 0.9));
  EXPECT_FALSE(UsualCorrelation::is_much_better(0.92, 0.9));
  EXPECT_FALSE(UsualCorrelation::is_much_better(0.9, 0.97));
}

}  // namespace
