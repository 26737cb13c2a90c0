// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/motion/velocity_trust.hpp"

#include <gtest/gtest.h>

namespace {

using dot::VelocityTrust;

constexpr double kFrame = 0.1;  // seconds

/// One in which this many fits have agreed, at 10 Hz.
VelocityTrust after(int fits) {
  VelocityTrust trust;
  for (int i = 0; i < fits; ++i) trust.accept(true, kFrame);
  return trust;
}

TEST(VelocityTrust, NeedsFitsThatAgree) {
  VelocityTrust trust;
  EXPECT_FALSE(trust.known());
  EXPECT_TRUE(trust.accept(false, kFrame)) << "the first has nothing to agree with";
  EXPECT_TRUE(trust.accept(true, kFrame));
  EXPECT_FALSE(trust.known());
  EXPECT_TRUE(trust.accept(true, kFrame));
  EXPECT_TRUE(trust.known());
}

TEST(VelocityTrust, UnknownStartsAgainWithAFitThatDisagrees) {
  VelocityTrust trust = after(2);
  EXPECT_TRUE(trust.accept(false, kFrame));
  EXPECT_TRUE(trust.accept(true, kFrame));
  EXPECT_FALSE(trust.known());
  EXPECT_TRUE(trust.accept(true, kFrame));
  EXPECT_TRUE(trust.known());
}

TEST(VelocityTrust, EndsWithRefusalsInARow) {
  VelocityTrust trust = after(3);
  trust.refuse(kFrame);
  trust.refuse(kFrame);
  EXPECT_TRUE(trust.known());
  trust.accept(true, kFrame);
  trust.refuse(kFrame);
  trust.refuse(kFrame);
  EXPECT_TRUE(trust.known()) << "refusals count in a row";
  trust.refuse(kFrame);
  EXPECT_FALSE(trust.known()) << "a wrong velocity must not shut out right fits for good";
  trust.accept(true, kFrame);
  EXPECT_FALSE(trust.known());
}

TEST(VelocityTrust, OutlivesAWrongFitOrTwo) {
  VelocityTrust trust = after(5);
  EXPECT_FALSE(trust.accept(false, kFrame)) << "the velocity goes on as it was";
  EXPECT_FALSE(trust.accept(false, kFrame));
  EXPECT_TRUE(trust.known());
  trust.accept(true, kFrame);
  EXPECT_FALSE(trust.accept(false, kFrame));
  trust.refuse(kFrame);
  EXPECT_TRUE(trust.accept(false, kFrame)) << "the third in a row is believed";
  EXPECT_FALSE(trust.known());
}

/// Seconds after the first fit at which a velocity becomes known, and after the first refusal at which it is given up.
struct Times {
  double known = 0, unknown = 0;
};
Times times_at(double rate) {
  VelocityTrust trust;
  Times t;
  for (trust.accept(true, 1 / rate); !trust.known(); t.known += 1 / rate) trust.accept(true, 1 / rate);
  for (trust.refuse(1 / rate); trust.known(); t.unknown += 1 / rate) trust.refuse(1 / rate);
  return t;
}

TEST(VelocityTrust, TakesTheSameTimeAtAnyFrameRate) {
  for (const double rate : {5.0, 10.0, 30.0, 60.0, 240.0}) {
    const Times t = times_at(rate);
    EXPECT_GE(t.known, VelocityTrust::kSeconds - 1e-9) << rate;
    EXPECT_LT(t.known, VelocityTrust::kSeconds + 1 / rate) << rate;
    EXPECT_DOUBLE_EQ(t.unknown, t.known) << rate;
  }
}

TEST(VelocityTrust, OneFitIsNoRowHoweverLongItTook) {
  VelocityTrust trust;
  trust.accept(true, 1);
  EXPECT_FALSE(trust.known());
  trust.accept(true, 1);
  EXPECT_TRUE(trust.known());
  trust.refuse(1);
  EXPECT_TRUE(trust.known());
}

}  // namespace
