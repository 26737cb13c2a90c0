// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/motion/velocity_trust.hpp"

#include <gtest/gtest.h>

namespace {

using dot::VelocityTrust;

/// One in which this many fits have agreed.
VelocityTrust after(int fits) {
  VelocityTrust trust;
  for (int i = 0; i < fits; ++i) trust.accept(true);
  return trust;
}

TEST(VelocityTrust, NeedsFitsThatAgree) {
  VelocityTrust trust;
  EXPECT_FALSE(trust.known());
  EXPECT_TRUE(trust.accept(false)) << "the first has nothing to agree with";
  EXPECT_TRUE(trust.accept(true));
  EXPECT_FALSE(trust.known());
  EXPECT_TRUE(trust.accept(true));
  EXPECT_TRUE(trust.known());
}

TEST(VelocityTrust, UnknownStartsAgainWithAFitThatDisagrees) {
  VelocityTrust trust = after(2);
  EXPECT_TRUE(trust.accept(false));
  EXPECT_EQ(trust.agreeing, 1);
  EXPECT_FALSE(trust.known());
}

TEST(VelocityTrust, EndsWithRefusalsInARow) {
  VelocityTrust trust = after(3);
  trust.refuse();
  trust.refuse();
  EXPECT_TRUE(trust.known());
  trust.accept(true);
  trust.refuse();
  trust.refuse();
  EXPECT_TRUE(trust.known()) << "refusals count in a row";
  trust.refuse();
  EXPECT_FALSE(trust.known()) << "a wrong velocity must not shut out right fits for good";
  trust.accept(true);
  EXPECT_FALSE(trust.known());
}

TEST(VelocityTrust, OutlivesAWrongFitOrTwo) {
  VelocityTrust trust = after(5);
  EXPECT_FALSE(trust.accept(false)) << "the velocity goes on as it was";
  EXPECT_FALSE(trust.accept(false));
  EXPECT_TRUE(trust.known());
  trust.accept(true);
  EXPECT_FALSE(trust.accept(false));
  trust.refuse();
  EXPECT_TRUE(trust.accept(false)) << "the third in a row is believed";
  EXPECT_FALSE(trust.known());
  EXPECT_EQ(trust.agreeing, 1);
}

}  // namespace
